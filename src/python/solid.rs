//! Arguments that may be a model, of a family or of any, or a fit.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::fit::PyFit;
use super::model::PyModel;
use super::shape::PyShape;
use crate::model::Model;
use crate::shape::Shape;

/// A model, or that of a fit.
pub(super) fn model_of(value: &Bound<'_, PyAny>) -> PyResult<Model> {
    if let Ok(model) = value.cast::<PyModel>() {
        return Ok(model.get().0);
    }
    if let Ok(fit) = value.cast::<PyFit>() {
        return Ok(*fit.get().model());
    }
    let found = value.get_type().name()?;
    Err(PyTypeError::new_err(format!("expected a Superellipsoid or a Fit, found {found}")))
}

/// A model of any family, or that of a fit.
pub(super) fn any_model_of(value: &Bound<'_, PyAny>) -> PyResult<Model<Shape>> {
    match value.cast::<PyShape>() {
        Ok(shape) => Ok(shape.get().0),
        Err(_) => Ok(model_of(value)?.into()),
    }
}
