//! `superquadric.export_model` and `import_models`, `write_mesh` and `read_mesh_model`.

use std::fs::File;
use std::path::{Path, PathBuf};

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::errors::{ExchangeError, os_error};
use super::families::to_python;
use super::model::PyModel;
use super::solid::any_model_of;
use crate::exchange::{ExportFormat, ImportFormat};
use crate::output::write_whole;
use crate::surface::format::{InscriptionError, MeshFormat};
use crate::surface::{Resolution, tessellate_shape};

/// A model as text for another program.
///
/// Args:
///     model: the model, of any family, or a fit.
///     to: the program: vtk, ovito, liggghts, lammps, mercury, pov, ems or supercompose.
///
/// Returns:
///     The text of its file. Numbers read back as the same doubles.
///
/// Raises:
///     ExchangeError: if the program cannot express the shape.
///     ValueError: if the program is none of these.
#[pyfunction]
pub(super) fn export_model(model: &Bound<'_, PyAny>, to: &str) -> PyResult<String> {
    let format = ExportFormat::ALL.into_iter().find(|format| format.name() == to);
    let format = format.ok_or_else(|| unknown(&ExportFormat::ALL.map(ExportFormat::name), to))?;
    Ok(format.text(any_model_of(model)?)?)
}

/// The models in a text of another program.
///
/// Args:
///     text: the content of its file.
///     source: the program: ovito, liggghts, lammps, mercury, ems or supercompose.
///
/// Returns:
///     The models in the order of the text: at least one.
///
/// Raises:
///     ExchangeError: if the text is not of that format, holds no superquadric, or one whose
///         parameters are outside their domain.
///     ValueError: if the program is none of these.
#[pyfunction]
pub(super) fn import_models(
    py: Python<'_>,
    text: &str,
    source: &str,
) -> PyResult<Vec<Py<PyModel>>> {
    let format = ImportFormat::ALL.into_iter().find(|format| format.name() == source);
    let format =
        format.ok_or_else(|| unknown(&ImportFormat::ALL.map(ImportFormat::name), source))?;
    format.models(text)?.into_iter().map(|model| PyModel::object(py, model)).collect()
}

/// Write a mesh of a model's surface, in the world, with the model's parameters in the file.
///
/// The file is written whole or not at all.
///
/// Args:
///     model: the model, of any family, or a fit.
///     path: file to write, by its extension PLY, OBJ, STL or binary glTF (.glb).
///     resolution: segments along each edge of the mesh's lattice, an even number from 2 to 4096.
///
/// Raises:
///     ExchangeError: if the extension is none of these.
///     ModelError: if the resolution is none.
///     OSError: if the file cannot be written, or the format cannot hold the coordinates.
#[pyfunction]
#[pyo3(signature = (model, path, *, resolution = 32))]
pub(super) fn write_mesh(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    path: PathBuf,
    resolution: usize,
) -> PyResult<()> {
    let format = mesh_format(&path)?;
    let resolution = Resolution::new(resolution)?;
    let model = any_model_of(model)?;
    py.detach(|| {
        let mesh = tessellate_shape(&model.shape, resolution).transformed(&model.pose);
        Ok(write_whole(path, |writer| format.write(&mesh, Some(&model), writer))?)
    })
}

/// The model that is kept in a mesh file of `write_mesh` or the command line: the same doubles,
/// but for the rotation in STL, which is kept to 2e-9, and of superellipsoids alone.
///
/// Args:
///     path: the file, by its extension PLY, OBJ, STL or binary glTF (.glb).
///
/// Raises:
///     ExchangeError: if the file keeps no model, or a broken one.
///     OSError: if it cannot be read.
#[pyfunction]
pub(super) fn read_mesh_model(py: Python<'_>, path: PathBuf) -> PyResult<Py<PyAny>> {
    let name = path.display();
    let format = mesh_format(&path)?;
    let unreadable =
        |error: std::io::Error| os_error(error.kind(), format!("cannot read {name}: {error}"));
    let read = format.read_model(&mut File::open(&path).map_err(unreadable)?);
    let model = read.map_err(|error| match error {
        InscriptionError::Io(error) => unreadable(error),
        error => ExchangeError::new_err(format!("{name}: {error}")),
    })?;
    to_python(py, model)
}

fn mesh_format(path: &Path) -> PyResult<MeshFormat> {
    MeshFormat::from_extension(path).map_err(|error| ExchangeError::new_err(error.to_string()))
}

fn unknown(names: &[&str], found: &str) -> PyErr {
    PyValueError::new_err(format!("expected one of {}, found {found}", names.join(", ")))
}
