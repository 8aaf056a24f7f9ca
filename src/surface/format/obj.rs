//! Wavefront OBJ.

use std::io::{self, Read, Write};

use super::Mesh;
use super::inscription::{self, InscriptionError};
use crate::model::Model;
use crate::shape::Shape;

/// Writes `v` lines in the shortest digits that read back as the same doubles, and `f` lines,
/// whose indices count from one; the model is a comment.
pub(super) fn write(
    mesh: &Mesh,
    model: Option<&Model<Shape>>,
    writer: &mut (impl Write + ?Sized),
) -> io::Result<()> {
    if let Some(model) = model {
        writeln!(writer, "# {}", inscription::line(model)?)?;
    }
    for vertex in mesh.vertices() {
        writeln!(writer, "v {:?} {:?} {:?}", vertex.x, vertex.y, vertex.z)?;
    }
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|index| u64::from(index) + 1);
        writeln!(writer, "f {a} {b} {c}")?;
    }
    Ok(())
}

/// The model in the comments at the beginning.
pub(super) fn read_model(
    reader: &mut (impl Read + ?Sized),
) -> Result<Model<Shape>, InscriptionError> {
    inscription::read(reader, "#", "a line `# superquadric {..}` at the beginning")
}

#[cfg(test)]
mod tests {
    use super::super::MeshFormat;
    use super::super::tests::written;
    use nalgebra::Vector3;
    use std::str::FromStr;

    /// The three numbers of every line that begins with `keyword`.
    fn rows<T: FromStr>(text: &str, keyword: &str) -> Vec<[T; 3]>
    where
        T::Err: std::fmt::Debug,
    {
        let row = |line: &str| {
            let mut numbers = line.split(' ').skip(1).map(|number| number.parse().unwrap());
            let row = [(); 3].map(|()| numbers.next().unwrap());
            assert!(numbers.next().is_none());
            row
        };
        text.lines().filter(|line| line.starts_with(keyword)).map(row).collect()
    }

    #[test]
    fn numbers_read_back_as_they_were() {
        let (mesh, bytes) = written(MeshFormat::Obj);
        let text = String::from_utf8(bytes).unwrap();
        let vertices: Vec<[f64; 3]> = rows(&text, "v ");
        assert!(vertices.into_iter().map(Vector3::from).eq(mesh.vertices().iter().copied()));
        let triangles: Vec<[u32; 3]> = rows(&text, "f ");
        assert!(triangles.into_iter().eq(mesh.triangles().iter().map(|t| t.map(|i| i + 1))));
    }
}
