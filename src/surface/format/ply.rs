//! Binary little-endian PLY (Turk 1994).

use std::io::{self, Read, Write};

use super::Mesh;
use super::inscription::{self, InscriptionError};
use crate::model::Model;
use crate::shape::Shape;

/// Writes vertices as doubles and triangles as lists of three `int` indices; the model is a
/// comment.
pub(super) fn write(
    mesh: &Mesh,
    model: Option<&Model<Shape>>,
    writer: &mut (impl Write + ?Sized),
) -> io::Result<()> {
    writer.write_all(b"ply\nformat binary_little_endian 1.0\n")?;
    if let Some(model) = model {
        writeln!(writer, "comment {}", inscription::line(model)?)?;
    }
    write!(
        writer,
        "element vertex {}\n\
         property double x\n\
         property double y\n\
         property double z\n\
         element face {}\n\
         property list uchar int vertex_indices\n\
         end_header\n",
        mesh.vertices().len(),
        mesh.triangles().len(),
    )?;
    for coordinate in mesh.vertices().iter().flatten() {
        writer.write_all(&coordinate.to_le_bytes())?;
    }
    for triangle in mesh.triangles() {
        writer.write_all(&[3])?;
        for &index in triangle {
            let index = i32::try_from(index).map_err(io::Error::other)?;
            writer.write_all(&index.to_le_bytes())?;
        }
    }
    Ok(())
}

/// The model in the comments of a header.
pub(super) fn read_model(
    reader: &mut (impl Read + ?Sized),
) -> Result<Model<Shape>, InscriptionError> {
    inscription::read(reader, "comment", "a line `comment superquadric {..}` in the header")
}

#[cfg(test)]
mod tests {
    use super::super::MeshFormat;
    use super::super::tests::written;
    use nalgebra::Vector3;
    use ply_rs_bw::parser::Parser;
    use ply_rs_bw::ply::{DefaultElement, Property};

    #[test]
    fn another_reader_finds_the_same_mesh() {
        let (mesh, bytes) = written(MeshFormat::Ply);
        let ply = Parser::<DefaultElement>::new().read_ply(&mut &bytes[..]).unwrap();
        let vertices: Vec<[f64; 3]> = ply.payload["vertex"]
            .iter()
            .map(|vertex| {
                ["x", "y", "z"].map(|name| match vertex[name] {
                    Property::Double(value) => value,
                    ref other => panic!("{other:?}"),
                })
            })
            .collect();
        assert!(vertices.into_iter().map(Vector3::from).eq(mesh.vertices().iter().copied()));
        let triangles: Vec<Vec<i32>> = ply.payload["face"]
            .iter()
            .map(|face| match &face["vertex_indices"] {
                Property::ListInt(indices) => indices.clone(),
                other => panic!("{other:?}"),
            })
            .collect();
        let expected = mesh.triangles().iter().map(|triangle| triangle.map(|i| i as i32).to_vec());
        assert!(triangles.into_iter().eq(expected));
    }
}
