//! `superquadric.Superellipsoid`: a posed model and its geometry on arrays.

use std::path::PathBuf;

use nalgebra::{Matrix3, Vector3};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

use super::arrays::{Array, Doubles, Table, Vector, map_angles, require_room, table, vector};
use super::derivatives;
use super::errors::os_error;
use super::pose::pose_of;
use super::surface::{self, Fineness, MeshArrays};
use crate::model::Model;
use crate::output::write_whole;
use crate::pose::Pose;
use crate::report::{ModelDocument, model_from_json};
use crate::shape::{Solid, Superellipsoid};
use crate::surface::sample_solid;

/// Greatest difference between the entries of rotations that count as the same: that of a matrix
/// and its Euler angles where they are worst determined.
const SAME_ROTATION: f64 = 1e-11;

/// A superellipsoid in general position (JLS section 2.3).
///
/// In its own frame it is the solid `((x/a1)^(2/e2) + (y/a2)^(2/e2))^(e2/e1) + (z/a3)^(2/e1)
/// <= 1` (JLS Eq. 2.15). Lengths are in the unit of the caller, angles in radians; points are
/// those of the world, and those that are not finite give NaN. It cannot be changed. Models are equal if size, exponents and
/// translation are, and their rotations up to rounding; one solid has many parameter vectors,
/// which `score` sees through.
///
/// Args:
///     size: semi-axes a1, a2, a3.
///     exponents: e1 (north-south) and e2 (east-west).
///     euler_zyz: phi, theta, psi of the rotation `Rz(phi) Ry(theta) Rz(psi)` from the model's
///         frame to the world.
///     rotation: the same as a matrix of shape (3, 3), instead of the angles.
///     translation: the model's centre in the world.
///
/// Raises:
///     ModelError: if a semi-axis or an exponent is not a positive number, the matrix is not a
///         rotation, a number is not finite, or both forms of the rotation are given.
///     ArrayError: if an argument has another shape.
#[pyclass(frozen, eq, name = "Superellipsoid", module = "superquadric")]
pub(super) struct PyModel(pub Model);

impl PartialEq for PyModel {
    fn eq(&self, other: &Self) -> bool {
        let [a, b] = [&self.0, &other.0].map(|model| model.pose.rotation().matrix());
        self.0.shape == other.0.shape
            && self.0.pose.translation() == other.0.pose.translation()
            && (a - b).amax() <= SAME_ROTATION
    }
}

impl PyModel {
    fn world_from_model(&self, points: Vec<Vector3<f64>>) -> Vec<[f64; 3]> {
        points.iter().map(|x| self.0.pose.world_from_model(x).into()).collect()
    }

    fn rotation_rows(&self) -> [[f64; 3]; 3] {
        self.0.pose.rotation().matrix().transpose().into()
    }
}

/// A matrix as an array of shape (3, 3).
pub(super) fn square<'py>(py: Python<'py>, matrix: &Matrix3<f64>) -> PyResult<Table<'py>> {
    table(py, <[[f64; 3]; 3]>::from(matrix.transpose()).to_vec())
}

#[pymethods]
impl PyModel {
    #[new]
    #[pyo3(
        signature = (size, exponents, *, euler_zyz = None, rotation = None, translation = None),
        text_signature = "(size, exponents, *, euler_zyz=None, rotation=None, \
                          translation=(0.0, 0.0, 0.0))"
    )]
    fn new(
        size: &Bound<'_, PyAny>,
        exponents: &Bound<'_, PyAny>,
        euler_zyz: Option<&Bound<'_, PyAny>>,
        rotation: Option<&Bound<'_, PyAny>>,
        translation: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let size = Doubles::new("size", size)?.vector()?;
        let exponents = Doubles::new("exponents", exponents)?.vector()?;
        let shape = Superellipsoid::new(size, exponents)?;
        Ok(Self(Model { shape, pose: pose_of(euler_zyz, rotation, translation)? }))
    }

    /// Semi-axes a1, a2, a3: float64 of shape (3,).
    #[getter]
    fn size<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.shape.size())
    }

    /// Exponents e1 (north-south) and e2 (east-west): float64 of shape (2,).
    #[getter]
    fn exponents<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.shape.exponents())
    }

    /// Euler angles phi, theta, psi, in radians: float64 of shape (3,). phi and psi are in
    /// (-pi, pi], theta in [0, pi]; psi is 0 where theta is 0 or pi.
    #[getter]
    fn euler_zyz<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.pose.euler_zyz())
    }

    /// Rotation from the model's frame to the world: float64 of shape (3, 3), whose columns are
    /// the model's axes.
    #[getter]
    fn rotation<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        table(py, self.rotation_rows().to_vec())
    }

    /// The model's centre in the world: float64 of shape (3,).
    #[getter]
    fn translation<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, self.0.pose.translation().as_slice())
    }

    /// The parameters a1 a2 a3 e1 e2 phi theta psi px py pz: float64 of shape (11,).
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.parameters())
    }

    /// Volume (JLS Eq. 2.59).
    #[getter]
    fn volume(&self) -> f64 {
        self.0.shape.volume()
    }

    /// Area of the surface, by quadrature: relative error below 1e-9 for exponents from 0.05 to 2
    /// and aspects up to 1:100.
    #[getter]
    fn surface_area(&self) -> f64 {
        self.0.shape.surface_area()
    }

    /// Inertia tensor of unit density about the centroid, in the model's axes: float64 of shape
    /// (3, 3) (JLS Eqs. 2.67-2.69).
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
        let point = match point {
            Some(point) => Doubles::new("point", point)?.vector::<3>()?.into(),
            None => mass.centroid(),
        };
        square(py, &mass.inertia_about(&point))
    }

    /// The least box along the world's axes that holds the solid: float64 of shape (2, 3), its
    /// least and greatest corner.
    #[getter]
    fn bounding_box<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        table(py, self.0.bounding_box().map(Into::into).to_vec())
    }

    /// Arithmetic mean of the semi-axes.
    #[getter]
    fn mean_semi_axis(&self) -> f64 {
        self.0.shape.mean_semi_axis()
    }

    /// Surface points, of shape (..., 3), at latitudes `eta` in [-pi/2, pi/2] and longitudes
    /// `omega` in [-pi, pi), broadcast together (JLS Eq. 2.10).
    fn position<'py>(
        &self,
        eta: &Bound<'py, PyAny>,
        omega: &Bound<'py, PyAny>,
    ) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        map_angles(eta, omega, |eta, omega| pose.world_from_model(&shape.position(eta, omega)))
    }

    /// Outward unit normals, of shape (..., 3), at latitudes `eta` and longitudes `omega`,
    /// broadcast together (JLS Eq. 2.39). Domain: exponents below 2.
    fn normal<'py>(
        &self,
        eta: &Bound<'py, PyAny>,
        omega: &Bound<'py, PyAny>,
    ) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        map_angles(eta, omega, |eta, omega| pose.rotation() * shape.normal(eta, omega))
    }

    /// The inside-outside function F of points of shape (..., 3), in an array of shape (...):
    /// below 1 inside, 1 on the surface, above 1 outside (JLS Eq. 2.16).
    fn inside_outside<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows(points.py(), |x| self.0.inside_outside(x))
    }

    /// Gradients of F at points of shape (..., 3), in an array of that shape.
    fn inside_outside_gradient<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        Doubles::new("points", points)?.map_rows_to_rows(points.py(), |x_world| {
            pose.rotation() * shape.inside_outside_gradient(&pose.model_from_world(x_world))
        })
    }

    /// Tangents by eta and by omega, of shape (..., 2, 3), at latitudes `eta` and longitudes
    /// `omega`, broadcast together.
    fn tangents<'py>(
        &self,
        eta: &Bound<'py, PyAny>,
        omega: &Bound<'py, PyAny>,
    ) -> PyResult<Array<'py>> {
        derivatives::tangents(&self.0, eta, omega)
    }

    /// Second derivatives of the surface point, by eta twice, by both, by omega twice, of shape
    /// (..., 3, 3), at latitudes `eta` and longitudes `omega`, broadcast together.
    fn second_derivatives<'py>(
        &self,
        eta: &Bound<'py, PyAny>,
        omega: &Bound<'py, PyAny>,
    ) -> PyResult<Array<'py>> {
        derivatives::second_derivatives(&self.0, eta, omega)
    }

    /// Second derivatives of F at points of shape (..., 3), in an array of shape (..., 3, 3).
    fn inside_outside_hessian<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        derivatives::hessian(&self.0, points)
    }

    /// Principal curvatures, the greater first, of the level surfaces of F through points of shape
    /// (..., 3), in an array of shape (..., 2): positive where the surface bends away from its
    /// outward normal.
    fn curvatures<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        Doubles::new("points", points)?.map_rows_to_pairs(points.py(), |x_world| {
            shape.curvatures(&pose.model_from_world(x_world)).principal
        })
    }

    /// The gauge `F^(e1/2)` of points of shape (..., 3), in an array of shape (...): homogeneous
    /// of degree one about the centre, 1 on the surface.
    fn gauge<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows(points.py(), |x| self.0.gauge(x))
    }

    /// Signed radial Euclidean distances of points of shape (..., 3) from the surface, in an
    /// array of shape (...): negative inside (JLS Eq. 2.43).
    fn radial_distance<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows(points.py(), |x| self.0.radial_distance(x))
    }

    /// The surface points on the rays from the centre through points of shape (..., 3), in an
    /// array of that shape. The centre is left where it is.
    fn radial_projection<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        Doubles::new("points", points)?.map_rows_to_rows(points.py(), |x_world| {
            pose.world_from_model(&shape.radial_projection(&pose.model_from_world(x_world)))
        })
    }

    /// Signed Euclidean distances of points of shape (..., 3) from the surface, in an array of shape
    /// (...): negative inside. Domain: exponents up to 2 (JLS section 2.4.2).
    fn euclidean_distance<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        Doubles::new("points", points)?.map_rows(points.py(), |x_world| {
            shape.euclidean_distance(&pose.model_from_world(x_world))
        })
    }

    /// The surface points nearest to points of shape (..., 3), in an array of that shape. Domain:
    /// exponents up to 2.
    fn nearest_point<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        let Model { shape, pose } = &self.0;
        Doubles::new("points", points)?.map_rows_to_rows(points.py(), |x_world| {
            pose.world_from_model(&shape.nearest_point(&pose.model_from_world(x_world)))
        })
    }

    /// The support function `max { n . x : x in the solid }` for directions n of shape (..., 3),
    /// in an array of shape (...), in the unit of length times that of n.
    fn support<'py>(&self, directions: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("directions", directions)?
            .map_rows(directions.py(), |direction| self.0.support(direction))
    }

    /// The dual, on which the normals lie, centred at the origin: semi-axes `1/a`, exponents
    /// `2 - e` (B81, JLS Eq. 2.39).
    fn dual(&self) -> PyResult<Self> {
        let pose = Pose::new(*self.0.pose.rotation(), Vector3::zeros());
        Ok(Self(Model { shape: self.0.shape.dual()?, pose }))
    }

    /// `n` random points of the surface, uniform by area: float64 of shape (n, 3), the same for
    /// the same seed. Domain: exponents up to 2.
    #[pyo3(signature = (n, seed = 0))]
    fn sample<'py>(&self, py: Python<'py>, n: usize, seed: u64) -> PyResult<Table<'py>> {
        surface::sample(py, &self.0.into(), n, seed)
    }

    /// `n` random points of the solid, uniform by volume: float64 of shape (n, 3), the same for
    /// the same seed.
    #[pyo3(signature = (n, seed = 0))]
    fn sample_solid<'py>(&self, py: Python<'py>, n: usize, seed: u64) -> PyResult<Table<'py>> {
        require_room(n)?;
        table(py, py.detach(|| self.world_from_model(sample_solid(&self.0.shape, n, seed))))
    }

    /// Points of the surface in rows around the model's z axis, of shape (rows, 4 n, 3), `n` steps
    /// to a quarter of a turn, from
    /// the south pole to the north pole. How they are spread along the rows, and the rows (JLS section 2.5),
    /// tells `parameterization`: "trigonometric" by the angles of `position`, "angle_centre" by
    /// angles at the centre, "explicit" by the coordinate that changes faster (`n` made even),
    /// "equal_distance" along the curves. Points uniform by area are those of `sample`.
    #[pyo3(signature = (n, parameterization = "equal_distance"))]
    fn grid<'py>(&self, py: Python<'py>, n: usize, parameterization: &str) -> PyResult<Array<'py>> {
        surface::grid(py, &self.0.into(), n, parameterization)
    }

    /// A closed mesh of the surface: vertices on it, float64 of shape (v, 3), and triangles, uint32 of
    /// shape (t, 3), counter-clockwise as seen from outside.
    ///
    /// Args:
    ///     resolution: segments along each edge of a lattice, an even number from 2 to 4096; 32 if
    ///         nothing is given. It has `v = 6 n^2 + 2`
    ///         and `t = 12 n^2`.
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
        surface::mesh(py, &self.0.into(), &Fineness { resolution, tolerance, method })
    }

    /// The same solid, described by the one parameter vector that stands for all equivalent
    /// ones: semi-axes in falling order where they can change places, the least rotation, none
    /// about an axis of revolution.
    fn canonical(&self) -> Self {
        Self(self.0.canonical())
    }

    /// The model as JSON text, `{"shape": .., "pose": ..}`.
    fn to_json(&self) -> String {
        ModelDocument::from(&self.0).to_json()
    }

    /// The model in a JSON text: a bare one, or that of a fit.
    #[classmethod]
    fn from_json(_: &Bound<'_, PyType>, text: &str) -> PyResult<Self> {
        Ok(Self(model_from_json(text)?))
    }

    /// The model as a dictionary, `{"shape": .., "pose": ..}`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("json")?.call_method1("loads", (self.to_json(),))
    }

    /// The model in a dictionary: a bare one, or that of a fit.
    #[classmethod]
    fn from_dict(_: &Bound<'_, PyType>, document: &Bound<'_, PyAny>) -> PyResult<Self> {
        let json = document.py().import("json")?.call_method1("dumps", (document,))?;
        Ok(Self(model_from_json(json.extract()?)?))
    }

    /// Write the model as JSON, whole or not at all.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        let json = self.to_json();
        Ok(write_whole(path, |writer| writer.write_all(json.as_bytes()))?)
    }

    /// The model in a JSON file: a bare one, or that of a fit.
    #[classmethod]
    fn load(_: &Bound<'_, PyType>, path: PathBuf) -> PyResult<Self> {
        let bytes = std::fs::read(&path).map_err(|error| {
            os_error(error.kind(), format!("cannot read {}: {error}", path.display()))
        })?;
        // Bytes that are no text become characters that are no JSON.
        Ok(Self(model_from_json(&String::from_utf8_lossy(&bytes))?))
    }

    /// The arguments that make this very model again.
    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        let arguments = (self.0.shape.size(), self.0.shape.exponents()).into_pyobject(py)?;
        let pose = PyDict::new(py);
        pose.set_item("rotation", self.rotation_rows())?;
        pose.set_item("translation", self.0.pose.translation().as_slice())?;
        Ok((arguments, pose))
    }

    fn __copy__(slf: Bound<'_, Self>) -> Bound<'_, Self> {
        slf
    }

    fn __deepcopy__<'py>(slf: Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf
    }

    pub(super) fn __repr__(&self) -> String {
        let Model { shape, pose } = &self.0;
        let mut arguments = format!("{:?}, {:?}", shape.size(), shape.exponents());
        if pose.euler_zyz() != [0.0; 3] {
            arguments += &format!(", euler_zyz={:?}", pose.euler_zyz());
        }
        if *pose.translation() != Vector3::zeros() {
            arguments += &format!(", translation={:?}", pose.translation().as_slice());
        }
        format!("Superellipsoid({arguments})")
    }
}
