//! Arguments that may be a model or a fit.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::fit::PyFit;
use super::model::PyModel;
use crate::model::Model;

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
