//! `superquadric.export_model` and `superquadric.import_models`.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::model::PyModel;
use super::solid::model_of;
use crate::exchange::{ExportFormat, ImportFormat};

/// A model as text for another program.
///
/// Args:
///     model: the model, or a fit.
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
    Ok(format.text(model_of(model)?)?)
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
pub(super) fn import_models(text: &str, source: &str) -> PyResult<Vec<PyModel>> {
    let format = ImportFormat::ALL.into_iter().find(|format| format.name() == source);
    let format =
        format.ok_or_else(|| unknown(&ImportFormat::ALL.map(ImportFormat::name), source))?;
    Ok(format.models(text)?.into_iter().map(PyModel).collect())
}

fn unknown(names: &[&str], found: &str) -> PyErr {
    PyValueError::new_err(format!("expected one of {}, found {found}", names.join(", ")))
}
