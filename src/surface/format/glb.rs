//! glTF 2.0 in its binary container (Khronos 2021, ISO/IEC 12113).

use std::io::{self, Read, Write};

use nalgebra::Vector3;
use serde_json::{Value, json};

use super::inscription::{InscriptionError, KEYWORD};
use super::{Mesh, float};
use crate::model::Model;
use crate::report::{ModelDocument, any_model_from_json};
use crate::shape::Shape;

const MAGIC: [u8; 4] = *b"glTF";
const VERSION: u32 = 2;
const JSON_CHUNK: [u8; 4] = *b"JSON";
const BINARY_CHUNK: [u8; 4] = *b"BIN\0";

/// Most bytes of JSON that are read: ours has less than two thousand.
const JSON_BYTES: u32 = 1 << 20;

const EXPECTED: &str = "a glTF 2.0 binary whose node has extras.superquadric";

/// Writes one node of one mesh: corners as floats about the node's translation, which is the
/// middle of the mesh's box in doubles, and triangles of 32-bit indices.
pub(super) fn write(
    mesh: &Mesh,
    model: Option<&Model<Shape>>,
    writer: &mut (impl Write + ?Sized),
) -> io::Result<()> {
    let middle = middle(mesh);
    let corners: Vec<[f32; 3]> =
        mesh.vertices().iter().map(|x| floats(&(x - middle))).collect::<io::Result<_>>()?;
    let json = serde_json::to_vec(&document(mesh, &corners, &middle, model))?;
    let padded = json.len().next_multiple_of(4);
    let binary = 12 * (corners.len() + mesh.triangles().len());

    writer.write_all(&MAGIC)?;
    writer.write_all(&VERSION.to_le_bytes())?;
    write_length(12 + 8 + padded + 8 + binary, writer)?;
    write_length(padded, writer)?;
    writer.write_all(&JSON_CHUNK)?;
    writer.write_all(&json)?;
    writer.write_all(&b"   "[..padded - json.len()])?;
    write_length(binary, writer)?;
    writer.write_all(&BINARY_CHUNK)?;
    for coordinate in corners.iter().flatten() {
        writer.write_all(&coordinate.to_le_bytes())?;
    }
    for index in mesh.triangles().iter().flatten() {
        writer.write_all(&index.to_le_bytes())?;
    }
    Ok(())
}

/// The middle of a mesh's box, the origin if it is empty.
fn middle(mesh: &Mesh) -> Vector3<f64> {
    let vertices = || mesh.vertices().iter().copied();
    match (vertices().reduce(|a, b| a.inf(&b)), vertices().reduce(|a, b| a.sup(&b))) {
        (Some(least), Some(greatest)) => 0.5 * least + 0.5 * greatest,
        _ => Vector3::zeros(),
    }
}

fn floats(x: &Vector3<f64>) -> io::Result<[f32; 3]> {
    Ok([float(x.x, "glTF")?, float(x.y, "glTF")?, float(x.z, "glTF")?])
}

fn write_length(bytes: usize, writer: &mut (impl Write + ?Sized)) -> io::Result<()> {
    writer.write_all(&u32::try_from(bytes).map_err(io::Error::other)?.to_le_bytes())
}

/// The JSON chunk.
fn document(
    mesh: &Mesh,
    corners: &[[f32; 3]],
    middle: &Vector3<f64>,
    model: Option<&Model<Shape>>,
) -> Value {
    let [vertices, triangles] = [corners.len(), mesh.triangles().len()];
    let extreme = |of: fn(f32, f32) -> f32| {
        corners.iter().copied().reduce(|a, b| std::array::from_fn(|i| of(a[i], b[i])))
    };
    let mut node = json!({"mesh": 0, "translation": middle.as_slice()});
    if let Some(model) = model {
        node["extras"] = json!({KEYWORD: ModelDocument::from(model)});
    }
    json!({
        "asset": {"version": "2.0", "generator": KEYWORD},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [node],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {
                "bufferView": 0, "componentType": FLOAT, "type": "VEC3", "count": vertices,
                "min": extreme(f32::min), "max": extreme(f32::max),
            },
            {
                "bufferView": 1, "componentType": UNSIGNED_INT, "type": "SCALAR",
                "count": 3 * triangles,
            },
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 12 * vertices, "target": ARRAY_BUFFER},
            {
                "buffer": 0, "byteOffset": 12 * vertices, "byteLength": 12 * triangles,
                "target": ELEMENT_ARRAY_BUFFER,
            },
        ],
        "buffers": [{"byteLength": 12 * (vertices + triangles)}],
    })
}

// Numbers of OpenGL's names.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// The model in the extras of a node.
pub(super) fn read_model(
    reader: &mut (impl Read + ?Sized),
) -> Result<Model<Shape>, InscriptionError> {
    let mut header = [0_u8; 20];
    reader.read_exact(&mut header)?;
    let number = |at: usize| u32::from_le_bytes([0, 1, 2, 3].map(|i| header[at + i]));
    let is_glb = header[..4] == MAGIC && number(4) == VERSION && header[16..] == JSON_CHUNK;
    let bytes = number(12);
    if !is_glb || bytes > JSON_BYTES {
        return Err(InscriptionError::Missing(EXPECTED));
    }
    let mut json = vec![0_u8; bytes as usize];
    reader.read_exact(&mut json)?;
    let document: Value =
        serde_json::from_slice(&json).map_err(|_| InscriptionError::Missing(EXPECTED))?;
    let nodes = document["nodes"].as_array().map(Vec::as_slice).unwrap_or_default();
    let model = nodes.iter().find_map(|node| node["extras"].get(KEYWORD));
    Ok(any_model_from_json(&model.ok_or(InscriptionError::Missing(EXPECTED))?.to_string())?)
}

#[cfg(test)]
mod tests {
    use super::super::MeshFormat;
    use super::super::tests::{model, written};
    use super::*;

    #[test]
    fn another_reader_finds_the_same_mesh_about_its_middle() {
        let (mesh, bytes) = written(MeshFormat::Glb);
        let gltf = gltf::Gltf::from_slice(&bytes).unwrap();
        let blob = gltf.blob.as_deref().unwrap();
        let node = gltf.document.default_scene().unwrap().nodes().next().unwrap();
        let ([tx, ty, tz], ..) = node.transform().decomposed();
        let primitive = node.mesh().unwrap().primitives().next().unwrap();
        assert_eq!(primitive.mode(), gltf::mesh::Mode::Triangles);
        let reader = primitive.reader(|_| Some(blob));

        let middle = middle(&mesh);
        // The reader keeps the translation in floats.
        let read = Vector3::new(tx, ty, tz).cast::<f64>();
        assert!((read - middle).amax() <= 6e-8 * middle.amax());
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let expected: Vec<[f32; 3]> =
            mesh.vertices().iter().map(|x| (x - middle).cast::<f32>().into()).collect();
        assert_eq!(positions, expected);
        let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
        assert!(indices.iter().eq(mesh.triangles().iter().flatten()));

        let bounds = primitive.bounding_box();
        for i in 0..3 {
            let coordinates = || positions.iter().map(|x| x[i]);
            assert_eq!(bounds.min[i], coordinates().fold(f32::INFINITY, f32::min));
            assert_eq!(bounds.max[i], coordinates().fold(f32::NEG_INFINITY, f32::max));
        }
        let extras: Value = serde_json::from_str(node.extras().as_deref().unwrap().get()).unwrap();
        assert_eq!(extras[KEYWORD], serde_json::to_value(ModelDocument::from(&model())).unwrap());
    }

    #[test]
    fn files_of_other_kinds_are_told() {
        let (_, bytes) = written(MeshFormat::Glb);
        for (place, value) in [(0, b'x'), (4, 1), (15, 0xff), (16, b'B'), (20, b'!')] {
            let mut damaged = bytes.clone();
            damaged[place] = value;
            let error = read_model(&mut &damaged[..]).unwrap_err();
            assert!(error.to_string().contains("extras.superquadric"), "{error}");
        }
        assert!(matches!(read_model(&mut &bytes[..100]), Err(InscriptionError::Io(_))));
    }
}
