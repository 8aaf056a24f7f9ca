//! Mesh files, a file per format.

mod obj;
mod ply;
mod stl;

use std::io::{self, Write};
use std::path::Path;

use thiserror::Error;

use super::Mesh;

/// A file format for meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MeshFormat {
    /// Binary little-endian PLY, coordinates as doubles.
    Ply,
    /// Wavefront OBJ, text that reads back as the same doubles.
    Obj,
    /// Binary STL, coordinates as floats: 24 bits. A mesh far from the origin loses what is
    /// smaller than 6e-8 of its distance, and no vertices are shared.
    Stl,
}

/// A file name that does not say which mesh format is meant.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{path}: the extension of a mesh file must be ply, obj or stl")]
pub struct UnknownMeshFormat {
    /// The file name.
    pub path: String,
}

impl MeshFormat {
    /// The format of a file, from its extension in upper or lower case.
    ///
    /// # Errors
    /// If the extension is none of `ply`, `obj` and `stl`.
    pub fn from_extension(path: impl AsRef<Path>) -> Result<Self, UnknownMeshFormat> {
        let path = path.as_ref();
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("ply") => Ok(Self::Ply),
            Some("obj") => Ok(Self::Obj),
            Some("stl") => Ok(Self::Stl),
            _ => Err(UnknownMeshFormat { path: path.display().to_string() }),
        }
    }

    /// Writes a mesh, in many small pieces: `writer` is best a buffered one.
    ///
    /// # Errors
    /// If `writer` fails, or the mesh has more triangles or greater coordinates than the format
    /// can hold.
    pub fn write(self, mesh: &Mesh, writer: &mut (impl Write + ?Sized)) -> io::Result<()> {
        match self {
            Self::Ply => ply::write(mesh, writer),
            Self::Obj => obj::write(mesh, writer),
            Self::Stl => stl::write(mesh, writer),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::shape::Superellipsoid;
    use crate::surface::{Resolution, tessellate};
    use nalgebra::Vector3;

    /// A mesh of uneven coordinates, and its bytes in a format.
    pub(super) fn written(format: MeshFormat) -> (Mesh, Vec<u8>) {
        let shape = Superellipsoid::new([2.0, 1.0, 0.3], [0.4, 1.3]).unwrap();
        let pose = Pose::from_euler_zyz([0.3, 1.1, -0.8], Vector3::new(1e-7, -2.0, 3e5));
        let mesh = tessellate(&shape, Resolution::new(4).unwrap()).transformed(&pose);
        let mut bytes = Vec::new();
        format.write(&mesh, &mut bytes).unwrap();
        (mesh, bytes)
    }

    #[test]
    fn extensions_name_formats_in_any_case() {
        for (path, format) in [
            ("a.ply", MeshFormat::Ply),
            ("dir.ply/b.OBJ", MeshFormat::Obj),
            ("c.tar.Stl", MeshFormat::Stl),
        ] {
            assert_eq!(MeshFormat::from_extension(path), Ok(format));
        }
        for path in ["", "ply", ".ply", "a.", "a.xyz", "a.ply/b"] {
            let error = MeshFormat::from_extension(path).unwrap_err();
            assert!(error.to_string().starts_with(path));
        }
    }

    #[test]
    fn a_failing_writer_is_an_error() {
        let (mesh, _) = written(MeshFormat::Ply);
        for format in [MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Stl] {
            let mut short = [0_u8; 200];
            assert!(format.write(&mesh, &mut &mut short[..]).is_err());
        }
    }
}
