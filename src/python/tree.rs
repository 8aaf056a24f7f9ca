//! `superquadric.Solid`: unions, intersections and differences.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyType;

use super::arrays::{Array, Doubles, Table, vectors};
use super::deformed::PyDeformed;
use super::document::{from_python, read_text, save, to_python};
use super::errors::ModelError;
use super::solid::any_model_of;
use super::surface::{MeshArrays, mesh_arrays};
use crate::deform::{Chain, Deformed};
use crate::report::{solid_from_json, solid_to_json};
use crate::solid::{Primitive, Tree, volume_bounds};
use crate::surface::boundary_mesh;

/// A solid made of models: what is in any of them, in all of them, or in one but not in others.
///
/// `a | b` is the union, `a & b` the intersection, and `a - b` the difference of solids; of the
/// two one may be a model.
///
/// Args:
///     model: a model of any family, deformed or not, a fit, or a solid.
#[pyclass(frozen, name = "Solid", module = "superquadric")]
pub(super) struct PySolid(pub Tree);

/// The solid that a model, deformed or not, a fit or a solid is.
pub(super) fn tree_of(value: &Bound<'_, PyAny>) -> PyResult<Tree> {
    if let Ok(solid) = value.cast::<PySolid>() {
        return Ok(solid.get().0.clone());
    }
    if let Ok(deformed) = value.cast::<PyDeformed>() {
        return Ok(deformed.get().0.clone().into());
    }
    let model = any_model_of(value)?;
    let deformed = Deformed::new(model.shape, Chain::default());
    let deformed = deformed.map_err(|error| ModelError::new_err(error.to_string()))?;
    Ok(Primitive { deformed, pose: model.pose }.into())
}

/// The solids in a list, of which there must be one at least.
fn parts_of(parts: &Bound<'_, PyAny>) -> PyResult<Vec<Tree>> {
    let parts = parts.try_iter()?.map(|part| tree_of(&part?)).collect::<PyResult<Vec<Tree>>>()?;
    if parts.is_empty() {
        return Err(ModelError::new_err("expected a list of at least one solid, found none"));
    }
    Ok(parts)
}

#[pymethods]
impl PySolid {
    #[new]
    fn new(model: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(tree_of(model)?))
    }

    /// What is in any of some solids.
    #[staticmethod]
    fn union(parts: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Union(parts_of(parts)?)))
    }

    /// What is in all of some solids.
    #[staticmethod]
    fn intersection(parts: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Intersection(parts_of(parts)?)))
    }

    /// What is in the first of some solids, but in none of the others.
    #[staticmethod]
    fn difference(parts: &Bound<'_, PyAny>) -> PyResult<Self> {
        let mut parts = parts_of(parts)?;
        let first = Box::new(parts.remove(0));
        Ok(Self(Tree::Difference(first, parts)))
    }

    fn __or__(&self, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Union(vec![self.0.clone(), tree_of(other)?])))
    }

    fn __ror__(&self, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Union(vec![tree_of(other)?, self.0.clone()])))
    }

    fn __and__(&self, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Intersection(vec![self.0.clone(), tree_of(other)?])))
    }

    fn __rand__(&self, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Intersection(vec![tree_of(other)?, self.0.clone()])))
    }

    fn __sub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Difference(Box::new(self.0.clone()), vec![tree_of(other)?])))
    }

    fn __rsub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(Tree::Difference(Box::new(tree_of(other)?), vec![self.0.clone()])))
    }

    /// Whether points of shape (..., 3) are inside: 1 or 0, in an array of shape (...).
    fn contains<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows_to_flags(points.py(), |x| self.0.contains(x))
    }

    /// A box along the world's axes that holds the solid, float64 of shape (2, 3); its ends are
    /// the wrong way round where boxes tell that nothing is left.
    #[getter]
    fn bounding_box<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        vectors(py, &py.detach(|| self.0.bounding_box()))
    }

    /// A lower and an upper bound on the volume, no further apart than `tolerance` times the
    /// upper one, or as near as it gets in a few seconds.
    #[pyo3(signature = (tolerance = 1e-3))]
    fn volume_bounds(&self, py: Python<'_>, tolerance: f64) -> (f64, f64) {
        py.detach(|| volume_bounds(&self.0, tolerance)).into()
    }

    /// A closed mesh of the boundary on a grid of `cells` along the longest side: vertices,
    /// float64 of shape (v, 3), and triangles, uint32 of shape (t, 3), counter-clockwise as seen
    /// from outside. Parts thinner than a cell may be missed.
    #[pyo3(signature = (cells = 100))]
    fn mesh<'py>(&self, py: Python<'py>, cells: usize) -> PyResult<MeshArrays<'py>> {
        let mesh = py.detach(|| boundary_mesh(&self.0, self.0.bounding_box(), cells));
        mesh_arrays(py, &mesh)
    }

    /// The solid as JSON text.
    fn to_json(&self) -> PyResult<String> {
        Ok(solid_to_json(&self.0)?)
    }

    /// The solid, or model, in a JSON text.
    #[classmethod]
    fn from_json(_cls: &Bound<'_, PyType>, text: &str) -> PyResult<Self> {
        Ok(Self(solid_from_json(text)?))
    }

    /// The solid as a dictionary.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.to_json()?)
    }

    /// The solid, or model, in a dictionary.
    #[classmethod]
    fn from_dict(_cls: &Bound<'_, PyType>, document: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self(solid_from_json(&from_python(document)?)?))
    }

    /// Write the solid as JSON, whole or not at all.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        save(path, &self.to_json()?)
    }

    /// The solid, or model, in a JSON file.
    #[classmethod]
    fn load(_cls: &Bound<'_, PyType>, path: PathBuf) -> PyResult<Self> {
        Ok(Self(solid_from_json(&read_text(&path)?)?))
    }

    fn __repr__(&self) -> String {
        format!("Solid of {} models", self.0.leaves())
    }
}
