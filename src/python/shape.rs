//! `superquadric.Shape`: a posed solid of any family, and its geometry on arrays.

use std::path::PathBuf;

use nalgebra::Vector3;
use pyo3::prelude::*;
use pyo3::types::PyType;

use super::arrays::{
    Angles, Array, Doubles, Table, Vector, map_angles, shaped, square, vector, vectors,
};
use super::deformed::any_to_python;
use super::derivatives;
use super::document::{from_python, read_text, save, to_python as to_dictionary};
use super::families::to_python;
use super::surface::{self, Fineness, MeshArrays};
use crate::model::Model;
use crate::report::{ModelDocument, primitive_from_json};
use crate::shape::{Parametric, Shape, Solid};
use crate::surface::sample_shape_surface;

/// A solid of any family, in general position: what its kinds `Superellipsoid`,
/// `SuperhyperboloidOneSheet`, `SuperhyperboloidTwoSheets`, `Supertoroid` and `ThreeExponent` can
/// be asked.
///
/// Lengths are in the unit of the caller, angles in radians; points are those of the world, and
/// those that are not finite give NaN. It cannot be changed.
#[pyclass(frozen, subclass, name = "Shape", module = "superquadric")]
pub(super) struct PyShape(pub Model<Shape>);

impl PyShape {
    fn rotated(&self, v_model: Vector3<f64>) -> Vector3<f64> {
        self.0.pose.rotation() * v_model
    }
}

#[pymethods]
impl PyShape {
    /// The family's name in documents.
    #[getter]
    fn family(&self) -> &'static str {
        self.0.shape.family()
    }

    /// Euler angles phi, theta, psi, in radians: float64 of shape (3,). phi and psi are in
    /// (-pi, pi], theta in [0, pi]; psi is 0 where theta is 0 or pi.
    #[getter]
    fn euler_zyz<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.pose.euler_zyz())
    }

    /// Rotation from the model's frame to the world: float64 of shape (3, 3), whose columns are the
    /// model's axes.
    #[getter]
    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        square(py, self.0.pose.rotation().matrix())
    }

    /// The model's centre in the world: float64 of shape (3,).
    #[getter]
    fn translation<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, self.0.pose.translation().as_slice())
    }

    /// Volume, of the clipped part where there is a clip.
    #[getter]
    fn volume(&self) -> f64 {
        self.0.shape.volume()
    }

    /// Area of the whole boundary, the caps of a clip included, by quadrature.
    #[getter]
    fn surface_area(&self) -> f64 {
        self.0.shape.surface_area()
    }

    /// Inertia tensor of unit density about the centroid, in the model's axes: float64 of shape
    /// (3, 3).
    #[getter]
    fn inertia<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        square(py, &self.0.shape.mass_properties().inertia())
    }

    /// Inertia tensor of unit density about a point of the world, in the world's axes: float64 of
    /// shape (3, 3). The point is the centroid if none is given.
    #[pyo3(signature = (point = None))]
    fn inertia_about<'py>(
        &self,
        py: Python<'py>,
        point: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Table<'py>> {
        let mass = self.0.mass_properties();
        let point = point.map(|point| Doubles::new("point", point)?.vector::<3>()).transpose()?;
        square(py, &mass.inertia_about(&point.map_or(mass.centroid(), Vector3::from)))
    }

    /// The least box along the world's axes that holds the solid: float64 of shape (2, 3), its least
    /// and greatest corner.
    #[getter]
    fn bounding_box<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        vectors(py, &self.0.bounding_box())
    }

    /// The natural ranges of latitude and longitude, float64 of shape (2, 2): of two sheets those
    /// of the first; half a turn of longitude leads to the second.
    #[getter]
    fn domain<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        shaped(py, self.0.shape.domain().as_flattened().to_vec(), &[2, 2])
    }

    /// Surface points, of shape (..., 3), at latitudes `eta` and longitudes `omega`, broadcast
    /// together.
    fn position<'py>(&self, eta: Angles<'_, 'py>, omega: Angles<'_, 'py>) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        map_angles(eta, omega, |eta, omega| pose.world_from_model(&shape.position(eta, omega)))
    }

    /// Outward unit normals, of shape (..., 3), at latitudes `eta` and longitudes `omega`,
    /// broadcast together.
    fn normal<'py>(&self, eta: Angles<'_, 'py>, omega: Angles<'_, 'py>) -> PyResult<Array<'py>> {
        map_angles(eta, omega, |eta, omega| self.rotated(self.0.shape.normal(eta, omega)))
    }

    /// The inside-outside function F of points of shape (..., 3), in an array of shape (...):
    /// below 1 inside, 1 on the surface, above 1 outside. It does not know of a clip.
    fn inside_outside<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows(points.py(), |x| self.0.inside_outside(x))
    }

    /// Gradients of F at points of shape (..., 3), in an array of that shape.
    fn inside_outside_gradient<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows_to_rows(points.py(), |x_world| {
            let x_model = self.0.pose.model_from_world(x_world);
            self.rotated(self.0.shape.inside_outside_gradient(&x_model))
        })
    }

    /// Tangents by eta and by omega, of shape (..., 2, 3), at latitudes `eta` and longitudes
    /// `omega`, broadcast together.
    fn tangents<'py>(&self, eta: Angles<'_, 'py>, omega: Angles<'_, 'py>) -> PyResult<Array<'py>> {
        derivatives::tangents(&self.0, eta, omega)
    }

    /// Second derivatives of the surface point, by eta twice, by both, by omega twice, of shape
    /// (..., 3, 3), at latitudes `eta` and longitudes `omega`, broadcast together.
    fn second_derivatives<'py>(
        &self,
        eta: Angles<'_, 'py>,
        omega: Angles<'_, 'py>,
    ) -> PyResult<Array<'py>> {
        derivatives::second_derivatives(&self.0, eta, omega)
    }

    /// First fundamental forms, of shape (..., 2, 2), at latitudes `eta` and longitudes `omega`,
    /// broadcast together: `[[E, F], [F, G]]`, the products of the tangents with each other (B81).
    fn first_fundamental_form<'py>(
        &self,
        eta: Angles<'_, 'py>,
        omega: Angles<'_, 'py>,
    ) -> PyResult<Array<'py>> {
        derivatives::fundamental_form(&self.0.shape, eta, omega, |forms| forms.first)
    }

    /// Second fundamental forms, of shape (..., 2, 2), at latitudes `eta` and longitudes `omega`,
    /// broadcast together: `[[D, D1], [D1, D2]]`, the products of the second derivatives with the
    /// inward normal (B81), so that the eigenvalues of `solve(first, second)` are `curvatures`.
    /// Domain, of both: where no tangent vanishes or is infinite.
    fn second_fundamental_form<'py>(
        &self,
        eta: Angles<'_, 'py>,
        omega: Angles<'_, 'py>,
    ) -> PyResult<Array<'py>> {
        derivatives::fundamental_form(&self.0.shape, eta, omega, |forms| forms.second)
    }

    /// Second derivatives of F at points of shape (..., 3), in an array of shape (..., 3, 3).
    fn inside_outside_hessian<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        derivatives::hessian(&self.0, points)
    }

    /// Principal curvatures, the greater first, of the level surfaces of F through points of shape
    /// (..., 3), in an array of shape (..., 2): positive where the surface bends away from its
    /// outward normal.
    fn curvatures<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows_to_pairs(points.py(), |x_world| {
            self.0.shape.curvatures(&self.0.pose.model_from_world(x_world)).principal
        })
    }

    /// Whether points of shape (..., 3) are inside, the clip included: 1 or 0, in an array of
    /// shape (...).
    fn contains<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows_to_flags(points.py(), |x| self.0.contains(x))
    }

    /// Signed distances of points of shape (..., 3) from the unclipped surface, along the ray from
    /// the centre or from the middle of a tube, in an array of shape (...): negative inside,
    /// infinite where the ray never meets it.
    fn radial_distance<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows(points.py(), |x| self.0.radial_distance(x))
    }

    /// The support function `max { n . x : x in the solid }` for directions n of shape (..., 3),
    /// in an array of shape (...), in the unit of length times that of n.
    fn support<'py>(&self, directions: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("directions", directions)?
            .map_rows(directions.py(), |direction| self.0.support(direction))
    }

    /// The dual, on which the normals lie, centred at the origin (B81, JLS Eq. 2.39): an object of its
    /// kind.
    fn dual(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        to_python(py, self.0.dual()?)
    }

    /// `n` random points of the boundary, the caps of a clip included, uniform by area: float64 of
    /// shape (n, 3), the same for the same seed. Domain: exponents up to 2; of three, from 1.
    #[pyo3(signature = (n, seed = 0))]
    fn sample<'py>(&self, py: Python<'py>, n: usize, seed: u64) -> PyResult<Table<'py>> {
        let Model { shape, pose } = &self.0;
        surface::sample(py, pose, n, |n| sample_shape_surface(shape, n, seed))
    }

    /// Points of the surface in rows, of shape (rows, points, 3), `n` steps to a quarter of a turn, or
    /// from the middle of a branch to its rim. Rows lead around the model's z axis, from the south pole
    /// to the north pole, from the lower rim of one sheet to the upper, or around a supertoroid's tube;
    /// those of two sheets from rim to rim, the first sheet's before the second's. `parameterization`
    /// tells how points are spread along the rows, and the rows (JLS section 2.5): "trigonometric" by
    /// the angles of `position`, "angle_centre" by angles at the centre, "explicit" by the coordinate
    /// that changes faster (`n` made even around), "equal_distance" along the curves. Points uniform by
    /// area are those of `sample`.
    #[pyo3(signature = (n, parameterization = "equal_distance"))]
    fn grid<'py>(&self, py: Python<'py>, n: usize, parameterization: &str) -> PyResult<Array<'py>> {
        surface::grid(py, &self.0, n, parameterization)
    }

    /// A closed mesh of the boundary: vertices on it, float64 of shape (v, 3), and triangles, uint32 of
    /// shape (t, 3), counter-clockwise as seen from outside.
    ///
    /// Args:
    ///     resolution: segments along each edge of a lattice, an even number from 2 to 4096; 32 if
    ///         nothing is given.
    ///     tolerance: instead, how far mesh and surface may be from each other.
    ///     method: how a mesh within a tolerance comes about: "subdivision" (if nothing is given)
    ///         where normals diverge (Barr 1984), "lattice", or "curvature", a lattice whose lines
    ///         are closer where the surface bends (Barr 1981).
    ///
    /// Raises:
    ///     ModelError: if the resolution or the tolerance is none, or needs too many triangles.
    #[pyo3(signature = (resolution = None, *, tolerance = None, method = None))]
    fn mesh<'py>(
        &self,
        py: Python<'py>,
        resolution: Option<usize>,
        tolerance: Option<f64>,
        method: Option<&str>,
    ) -> PyResult<MeshArrays<'py>> {
        surface::mesh(py, &self.0, &Fineness { resolution, tolerance, method })
    }

    /// The model as JSON text, `{"shape": .., "pose": ..}`.
    fn to_json(&self) -> String {
        ModelDocument::from(&self.0).to_json()
    }

    /// The model of any family in a JSON text, as an object of its kind: deformed or not.
    #[classmethod]
    fn from_json(cls: &Bound<'_, PyType>, text: &str) -> PyResult<Py<PyAny>> {
        any_to_python(cls.py(), primitive_from_json(text)?)
    }

    /// The model as a dictionary, `{"shape": .., "pose": ..}`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_dictionary(py, &self.to_json())
    }

    /// The model of any family in a dictionary, as an object of its kind: deformed or not.
    #[classmethod]
    fn from_dict(cls: &Bound<'_, PyType>, document: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        any_to_python(cls.py(), primitive_from_json(&from_python(document)?)?)
    }

    /// Write the model as JSON, whole or not at all.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        save(path, &self.to_json())
    }

    /// The model of any family in a JSON file, as an object of its kind: deformed or not.
    #[classmethod]
    fn load(cls: &Bound<'_, PyType>, path: PathBuf) -> PyResult<Py<PyAny>> {
        any_to_python(cls.py(), primitive_from_json(&read_text(&path)?)?)
    }

    fn __repr__(&self) -> String {
        let Model { shape, pose } = &self.0;
        let translation = pose.translation().as_slice();
        format!("{shape:?} at {translation:?}, euler_zyz={:?}", pose.euler_zyz())
    }
}
