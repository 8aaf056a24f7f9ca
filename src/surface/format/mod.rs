//! Mesh files, a file per format.

mod glb;
mod inscription;
mod obj;
mod ply;
mod stl;
mod stl_header;

use std::io::{self, Read, Write};
use std::path::Path;

use thiserror::Error;

pub use inscription::InscriptionError;

use super::Mesh;
use crate::model::Model;
use crate::shape::Shape;

/// A file format for meshes, with room for the parameters of the model that was meshed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MeshFormat {
    /// Binary little-endian PLY, coordinates as doubles.
    Ply,
    /// Wavefront OBJ, text that reads back as the same doubles.
    Obj,
    /// Binary STL, coordinates as floats: 24 bits. A mesh far from the origin loses what is
    /// smaller than 6e-8 of its distance, and no vertices are shared.
    Stl,
    /// Binary glTF 2.0: coordinates as floats about the mesh's middle, so that no place in the
    /// world costs digits. They are the world's own: nothing is turned to glTF's upward y.
    Glb,
}

/// A file name that does not say which mesh format is meant.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{path}: the extension of a mesh file must be ply, obj, stl or glb")]
pub struct UnknownMeshFormat {
    /// The file name.
    pub path: String,
}

impl MeshFormat {
    /// The format of a file, from its extension in upper or lower case.
    ///
    /// # Errors
    /// If the extension is none of `ply`, `obj`, `stl` and `glb`.
    pub fn from_extension(path: impl AsRef<Path>) -> Result<Self, UnknownMeshFormat> {
        let path = path.as_ref();
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("ply") => Ok(Self::Ply),
            Some("obj") => Ok(Self::Obj),
            Some("stl") => Ok(Self::Stl),
            Some("glb") => Ok(Self::Glb),
            _ => Err(UnknownMeshFormat { path: path.display().to_string() }),
        }
    }

    /// Writes a mesh, in many small pieces (`writer` is best a buffered one), and with it the
    /// model whose surface it is.
    ///
    /// # Errors
    /// If `writer` fails, or the mesh has more triangles or greater coordinates than the format
    /// can hold.
    pub fn write(
        self,
        mesh: &Mesh,
        model: Option<&Model<Shape>>,
        writer: &mut (impl Write + ?Sized),
    ) -> io::Result<()> {
        match self {
            Self::Ply => ply::write(mesh, model, writer),
            Self::Obj => obj::write(mesh, model, writer),
            Self::Stl => stl::write(mesh, model, writer),
            Self::Glb => glb::write(mesh, model, writer),
        }
    }

    /// The model that [`write`](Self::write) was given: the same doubles, but for rounding of the
    /// rotation in STL, which keeps no model with fewer than fifteen triangles. No more is read than
    /// the file's header, and those triangles.
    ///
    /// # Errors
    /// If `reader` fails, or the file holds no model, or a broken one.
    pub fn read_model(
        self,
        reader: &mut (impl Read + ?Sized),
    ) -> Result<Model<Shape>, InscriptionError> {
        match self {
            Self::Ply => ply::read_model(reader),
            Self::Obj => obj::read_model(reader),
            Self::Stl => stl_header::read_model(reader),
            Self::Glb => glb::read_model(reader),
        }
    }
}

/// A coordinate rounded to a float.
fn float(coordinate: f64, format: &str) -> io::Result<f32> {
    let rounded = coordinate as f32;
    if rounded.is_finite() {
        return Ok(rounded);
    }
    let message = format!("{format} cannot hold the coordinate {coordinate:e}");
    Err(io::Error::new(io::ErrorKind::InvalidData, message))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::shape::{
        Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
        ThreeExponent,
    };
    use crate::surface::{Resolution, tessellate_shape};
    use nalgebra::Vector3;

    const FORMATS: [MeshFormat; 4] =
        [MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Stl, MeshFormat::Glb];

    /// A model of uneven parameters.
    pub(super) fn model() -> Model<Shape> {
        posed(Superellipsoid::new([2.0, 1.0, 0.1 + 0.2], [0.4, 1.3]).unwrap())
    }

    fn posed(shape: impl Into<Shape>) -> Model<Shape> {
        let pose = Pose::from_euler_zyz([0.3, 1.1, -0.8], Vector3::new(1e-7, -2.0, 3e5));
        Model { shape: shape.into(), pose }
    }

    fn bytes(format: MeshFormat, mesh: &Mesh, model: Option<&Model<Shape>>) -> Vec<u8> {
        let mut bytes = Vec::new();
        format.write(mesh, model, &mut bytes).unwrap();
        bytes
    }

    /// The mesh of that model, and its bytes in a format.
    pub(super) fn written(format: MeshFormat) -> (Mesh, Vec<u8>) {
        let Model { shape, pose } = model();
        let mesh = tessellate_shape(&shape, Resolution::new(4).unwrap()).transformed(&pose);
        let bytes = bytes(format, &mesh, Some(&model()));
        (mesh, bytes)
    }

    #[test]
    fn extensions_name_formats_in_any_case() {
        for (path, format) in [
            ("a.ply", MeshFormat::Ply),
            ("dir.ply/b.OBJ", MeshFormat::Obj),
            ("c.tar.Stl", MeshFormat::Stl),
            ("d.glb", MeshFormat::Glb),
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
        for format in FORMATS {
            let mut short = [0_u8; 200];
            assert!(format.write(&mesh, Some(&model()), &mut &mut short[..]).is_err());
        }
    }

    #[test]
    fn the_model_of_any_family_comes_back_as_the_same_doubles() {
        let toroid = posed(Supertoroid::new([1.0, 0.7, 0.4], [0.4, 1.3], 2.5).unwrap());
        let three = posed(ThreeExponent::new([1.0, 0.7, 0.4], [2.0, 1.3, 4.0]).unwrap());
        let one = posed(SuperhyperboloidOneSheet::new([1.0, 0.7, 0.4], [0.4, 1.3], 2.5).unwrap());
        let two = posed(SuperhyperboloidTwoSheets::new([1.0, 0.7, 0.4], [0.4, 1.3], 2.5).unwrap());
        for model in [model(), one, two, toroid, three] {
            for format in FORMATS {
                let mesh = tessellate_shape(&model.shape, Resolution::new(2).unwrap());
                let bytes = bytes(format, &mesh, Some(&model));
                let read = format.read_model(&mut &bytes[..]).unwrap();
                if format == MeshFormat::Stl {
                    assert_eq!(read.shape, model.shape);
                    assert_eq!(read.pose.translation(), model.pose.translation());
                    let [back, given] = [read, model].map(|m| *m.pose.rotation().matrix());
                    // Axis and angle of a matrix, and back.
                    assert!((back - given).amax() < 2e-15, "{}", (back - given).amax());
                } else {
                    assert_eq!(read, model);
                }
            }
        }
    }

    #[test]
    fn a_file_without_a_model_says_so_and_no_damage_makes_another_of_it() {
        let (mesh, _) = written(MeshFormat::Ply);
        for format in FORMATS {
            let plain = bytes(format, &mesh, None);
            let error = format.read_model(&mut &plain[..]).unwrap_err();
            assert!(matches!(error, InscriptionError::Missing(_)), "{error}");
            assert!(format.read_model(&mut &plain[..3]).is_err());
            assert!(format.read_model(&mut &b""[..]).is_err());
        }
        let (_, mut bytes) = written(MeshFormat::Stl);
        bytes[4..12].copy_from_slice(&(-1.0_f64).to_le_bytes());
        let error = MeshFormat::Stl.read_model(&mut &bytes[..]).unwrap_err();
        assert!(error.to_string().contains("size[0]"), "{error}");
    }
}
