//! Arguments that may be a model, of a family or of any, a fit, or a solid.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyList;

use super::fit::PyFit;
use super::model::PyModel;
use super::shape::PyShape;
use super::tree::tree_of;
use crate::model::Model;
use crate::shape::Shape;
use crate::solid::Tree;

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

/// The solid that an object of any class stands for, or all of several together.
pub(super) fn solid_of(value: &Bound<'_, PyAny>) -> PyResult<Tree> {
    if value.is_instance_of::<PyList>() {
        let parts = value.try_iter()?.map(|part| solid_of(&part?));
        return Ok(Tree::Union(parts.collect::<PyResult<_>>()?));
    }
    tree_of(value)
}
