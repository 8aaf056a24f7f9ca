//! `superquadric.Deformed`: a shape after deformations, and its geometry on arrays.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};

use super::arrays::{Array, Doubles, Table, map_angles, square, vector, vectors};
use super::document::{from_python, read_text, save, to_python as to_dictionary};
use super::families::to_python;
use super::solid::any_model_of;
use super::surface::{MeshArrays, mesh_arrays, sample};
use crate::model::Model;
use crate::report::{ModelDocument, primitive_from_json};
use crate::shape::Shape;
use crate::solid::Primitive;
use crate::surface::{Resolution, deformed_mesh, sample_deformed_surface, tessellate_shape};

/// A model of any family after deformations of its space (B84): first deformed, then moved.
///
/// Args:
///     model: the model before the deformations, or a fit.
///     deformations: dictionaries as in JSON, applied in their order in the shape's frame:
///         `{"kind": "scale", "factors": [..]}`, `{"kind": "taper", "profile": ..}`, `{"kind":
///         "twist", "profile": ..}` or `{"kind": "bend", "rate": k, "center": y0, "range": [..]}`,
///         each with an `axis` or a `frame` if need be. A profile is `{"form": "line", "at_zero":
///         .., "slope": ..}`, or a "polyline" or "spline" with `knots`.
///
/// Raises:
///     DocumentError: if a deformation is not one, or folds the shape.
#[pyclass(frozen, name = "Deformed", module = "superquadric")]
pub(super) struct PyDeformed(pub Primitive<Shape>);

/// The Python object of a model that may be deformed: one without deformations is of its family's
/// kind.
pub(super) fn any_to_python(py: Python<'_>, primitive: Primitive<Shape>) -> PyResult<Py<PyAny>> {
    match primitive.undeformed() {
        Some(model) => to_python(py, model),
        None => Ok(Py::new(py, PyDeformed(primitive))?.into_any()),
    }
}

#[pymethods]
impl PyDeformed {
    #[new]
    fn new(model: &Bound<'_, PyAny>, deformations: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = model.py();
        let json = ModelDocument::from(&any_model_of(model)?).to_json();
        let document = to_dictionary(py, &json)?.cast_into::<PyDict>()?;
        document.set_item("deformations", deformations)?;
        Ok(Self(primitive_from_json(&from_python(&document)?)?))
    }

    /// The model before its deformations, as an object of its kind.
    #[getter]
    fn model(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let Primitive { deformed, pose } = &self.0;
        to_python(py, Model { shape: *deformed.shape(), pose: *pose })
    }

    /// The deformations, as a list of dictionaries.
    #[getter]
    fn deformations<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.to_dict(py)?.get_item("deformations")
    }

    /// Surface points, of shape (..., 3), at latitudes `eta` and longitudes `omega` of the shape,
    /// broadcast together.
    fn position<'py>(
        &self,
        eta: &Bound<'py, PyAny>,
        omega: &Bound<'py, PyAny>,
    ) -> PyResult<Array<'py>> {
        let Primitive { deformed, pose } = &self.0;
        map_angles(eta, omega, |eta, omega| pose.world_from_model(&deformed.position(eta, omega)))
    }

    /// Outward unit normals, of shape (..., 3), at latitudes `eta` and longitudes `omega` of the
    /// shape, broadcast together.
    fn normal<'py>(
        &self,
        eta: &Bound<'py, PyAny>,
        omega: &Bound<'py, PyAny>,
    ) -> PyResult<Array<'py>> {
        let Primitive { deformed, pose } = &self.0;
        map_angles(eta, omega, |eta, omega| pose.rotation() * deformed.normal(eta, omega))
    }

    /// The inside-outside function F of the undeformed points of points of shape (..., 3), in an
    /// array of shape (...): below 1 inside, 1 on the surface, above 1 outside.
    fn inside_outside<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows(points.py(), |x| self.0.inside_outside(x))
    }

    /// Gradients of F at points of shape (..., 3), in an array of that shape.
    fn inside_outside_gradient<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows_to_rows(points.py(), |x_world| {
            let Primitive { deformed, pose } = &self.0;
            pose.rotation() * deformed.inside_outside_gradient(&pose.model_from_world(x_world))
        })
    }

    /// Whether points of shape (..., 3) are inside: 1 or 0, in an array of shape (...).
    fn contains<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows_to_flags(points.py(), |x| self.0.contains(x))
    }

    /// A box along the world's axes that holds the solid and is hardly larger: float64 of shape
    /// (2, 3).
    #[getter]
    fn bounding_box<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        vectors(py, &py.detach(|| self.0.bounding_box()))
    }

    /// Volume, area, centroid and inertia by quadrature, to a relative tolerance.
    ///
    /// Returns:
    ///     A dictionary of `volume`, `surface_area`, `centroid` (in the world, float64 of shape
    ///     (3,)), `inertia` (about the centroid, in the world's axes, of unit density, float64 of
    ///     shape (3, 3)) and `error`, a bound on their relative errors.
    #[pyo3(signature = (tolerance = 1e-6))]
    fn masses<'py>(&self, py: Python<'py>, tolerance: f64) -> PyResult<Bound<'py, PyDict>> {
        let estimate = py.detach(|| self.0.mass_estimate(tolerance));
        let masses = PyDict::new(py);
        masses.set_item("volume", estimate.properties.volume())?;
        masses.set_item("surface_area", estimate.surface_area)?;
        masses.set_item("centroid", vector(py, estimate.properties.centroid().as_slice()))?;
        masses.set_item("inertia", square(py, &estimate.properties.inertia())?)?;
        masses.set_item("error", estimate.error)?;
        Ok(masses)
    }

    /// `n` random points of the boundary, uniform by area: float64 of shape (n, 3), the same for the
    /// same seed. Domain: exponents up to 2; of three, from 1.
    #[pyo3(signature = (n, seed = 0))]
    fn sample<'py>(&self, py: Python<'py>, n: usize, seed: u64) -> PyResult<Table<'py>> {
        let Primitive { deformed, pose } = &self.0;
        sample(py, pose, n, |n| sample_deformed_surface(deformed, n, seed))
    }

    /// A closed mesh of the boundary: vertices, float64 of shape (v, 3), and triangles, uint32 of
    /// shape (t, 3), counter-clockwise as seen from outside.
    #[pyo3(signature = (resolution = 32))]
    fn mesh<'py>(&self, py: Python<'py>, resolution: usize) -> PyResult<MeshArrays<'py>> {
        let resolution = Resolution::new(resolution)?;
        let Primitive { deformed, pose } = &self.0;
        let mesh = py.detach(|| {
            let undeformed = tessellate_shape(deformed.shape(), resolution);
            deformed_mesh(deformed, &undeformed).transformed(pose)
        });
        mesh_arrays(py, &mesh)
    }

    /// The model as JSON text, `{"shape": .., "deformations": .., "pose": ..}`.
    fn to_json(&self) -> PyResult<String> {
        Ok(ModelDocument::try_from(&self.0)?.to_json())
    }

    /// The model of any family in a JSON text, as an object of its kind: deformed or not.
    #[classmethod]
    fn from_json(cls: &Bound<'_, PyType>, text: &str) -> PyResult<Py<PyAny>> {
        any_to_python(cls.py(), primitive_from_json(text)?)
    }

    /// The model as a dictionary, `{"shape": .., "deformations": .., "pose": ..}`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_dictionary(py, &self.to_json()?)
    }

    /// The model of any family in a dictionary, as an object of its kind: deformed or not.
    #[classmethod]
    fn from_dict(cls: &Bound<'_, PyType>, document: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        any_to_python(cls.py(), primitive_from_json(&from_python(document)?)?)
    }

    /// Write the model as JSON, whole or not at all.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        save(path, &self.to_json()?)
    }

    /// The model of any family in a JSON file, as an object of its kind: deformed or not.
    #[classmethod]
    fn load(cls: &Bound<'_, PyType>, path: PathBuf) -> PyResult<Py<PyAny>> {
        any_to_python(cls.py(), primitive_from_json(&read_text(&path)?)?)
    }

    fn __repr__(&self) -> String {
        let Primitive { deformed, pose } = &self.0;
        let names: Vec<&str> =
            deformed.chain().stages().iter().map(|stage| stage.kind().name()).collect();
        let translation = pose.translation().as_slice();
        format!("{:?}, {}, at {translation:?}", deformed.shape(), names.join(", "))
    }
}
