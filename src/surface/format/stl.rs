//! Binary STL.

use std::io::{self, Write};

use nalgebra::Vector3;

use super::stl_header::Parameters;
use super::{Mesh, float};
use crate::model::Model;
use crate::shape::Shape;

/// Writes every triangle as its outward normal and three corners, in floats; normals are
/// computed in doubles, before anything is rounded.
pub(super) fn write(
    mesh: &Mesh,
    model: Option<&Model<Shape>>,
    writer: &mut (impl Write + ?Sized),
) -> io::Result<()> {
    let parameters = Parameters::new(model, mesh.triangles().len());
    writer.write_all(&parameters.header)?;
    let count = u32::try_from(mesh.triangles().len()).map_err(io::Error::other)?;
    writer.write_all(&count.to_le_bytes())?;
    let attributes = parameters.attributes.into_iter().chain(std::iter::repeat(0));
    for ([a, b, c], attribute) in mesh.corners().zip(attributes) {
        for vector in [unit_normal([a, b, c]), a, b, c] {
            write_floats(&vector, writer)?;
        }
        writer.write_all(&attribute.to_le_bytes())?;
    }
    Ok(())
}

/// The outward unit normal of a triangle, or zero where it has no area.
fn unit_normal([a, b, c]: [Vector3<f64>; 3]) -> Vector3<f64> {
    let normal = (b - a).cross(&(c - a));
    normal.try_normalize(0.0).unwrap_or_default()
}

fn write_floats(vector: &Vector3<f64>, writer: &mut (impl Write + ?Sized)) -> io::Result<()> {
    for &coordinate in vector {
        writer.write_all(&float(coordinate, "STL")?.to_le_bytes())?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::MeshFormat;
    use super::super::tests::written;
    use super::*;

    #[test]
    fn records_hold_normals_and_rounded_corners() {
        let (mesh, bytes) = written(MeshFormat::Stl);
        assert!(!bytes.starts_with(b"solid"));
        assert_eq!(bytes[80..84], (mesh.triangles().len() as u32).to_le_bytes());
        let records: Vec<&[u8]> = bytes[84..].chunks(50).collect();
        assert_eq!(records.len(), mesh.triangles().len());
        for (i, (record, [a, b, c])) in records.iter().zip(mesh.corners()).enumerate() {
            assert_eq!(record.len(), 50);
            // Bits of the model's rotation in the first fifteen, and no mark of a colour.
            assert!(record[49] < 0x80 && (i < 15 || record[48..] == [0, 0]));
            let floats: Vec<f32> = record[..48]
                .chunks(4)
                .map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()))
                .collect();
            let corners = [a, b, c].iter().flatten().map(|&x| x as f32).collect::<Vec<_>>();
            assert_eq!(floats[3..], corners);
            let normal = Vector3::from_column_slice(&floats[..3]).cast::<f64>();
            // Floats are rounded to 6e-8.
            assert!((normal.norm() - 1.0).abs() < 2e-7);
            assert!(normal.dot(&(b - a).cross(&(c - a))) > 0.0);
        }
    }

    #[test]
    fn a_coordinate_beyond_floats_is_refused() {
        let vertices = vec![Vector3::zeros(), Vector3::x() * 1e39, Vector3::y()];
        let mesh = Mesh::new(vertices, vec![[0, 1, 2]]);
        let error = write(&mesh, None, &mut Vec::new()).unwrap_err();
        assert!(error.to_string().contains("1e39"));
    }
}
