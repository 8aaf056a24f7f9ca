//! `superquadric.Superellipsoid`: a posed model and its geometry on arrays.

use std::path::PathBuf;

use nalgebra::Vector3;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

use super::arrays::{Array, Doubles, Table, Vector, vector};
use super::document::{from_python, read_text};
use super::pose::pose_of;
use super::shape::PyShape;
use super::surface;
use crate::model::Model;
use crate::report::model_from_json;
use crate::shape::Superellipsoid;
use crate::surface::sample_solid;

/// Greatest difference between the entries of rotations that count as the same: that of a matrix
/// and its Euler angles where they are worst determined.
const SAME_ROTATION: f64 = 1e-11;

/// A superellipsoid in general position (JLS section 2.3).
///
/// In its own frame it is the solid `((x/a1)^(2/e2) + (y/a2)^(2/e2))^(e2/e1) + (z/a3)^(2/e1)
/// <= 1` (JLS Eq. 2.15). It can be asked what every `Shape` can, and more. Models are equal if
/// size, exponents and translation are, and their rotations up to rounding; one solid has many
/// parameter vectors, which `score` sees through.
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
#[pyclass(frozen, eq, extends = PyShape, name = "Superellipsoid", module = "superquadric")]
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
    /// The Python object of a model.
    pub fn object(py: Python<'_>, model: Model) -> PyResult<Py<Self>> {
        Py::new(py, Self::initializer(model))
    }

    fn initializer(model: Model) -> PyClassInitializer<Self> {
        PyClassInitializer::from(PyShape(model.into())).add_subclass(Self(model))
    }
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
    ) -> PyResult<PyClassInitializer<Self>> {
        let size = Doubles::new("size", size)?.vector()?;
        let exponents = Doubles::new("exponents", exponents)?.vector()?;
        let shape = Superellipsoid::new(size, exponents)?;
        let pose = pose_of(euler_zyz, rotation, translation)?;
        Ok(Self::initializer(Model { shape, pose }))
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

    /// The parameters a1 a2 a3 e1 e2 phi theta psi px py pz: float64 of shape (11,).
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.parameters())
    }

    /// Arithmetic mean of the semi-axes.
    #[getter]
    fn mean_semi_axis(&self) -> f64 {
        self.0.shape.mean_semi_axis()
    }

    /// The gauge `F^(e1/2)` of points of shape (..., 3), in an array of shape (...): homogeneous
    /// of degree one about the centre, 1 on the surface.
    fn gauge<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        Doubles::new("points", points)?.map_rows(points.py(), |x| self.0.gauge(x))
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

    /// `n` random points of the solid, uniform by volume: float64 of shape (n, 3), the same for
    /// the same seed.
    #[pyo3(signature = (n, seed = 0))]
    fn sample_solid<'py>(&self, py: Python<'py>, n: usize, seed: u64) -> PyResult<Table<'py>> {
        let Model { shape, pose } = &self.0;
        surface::sample(py, pose, n, |n| sample_solid(shape, n, seed))
    }

    /// The same solid, described by the one parameter vector that stands for all equivalent
    /// ones: semi-axes in falling order where they can change places, the least rotation, none
    /// about an axis of revolution.
    fn canonical(&self, py: Python<'_>) -> PyResult<Py<Self>> {
        Self::object(py, self.0.canonical())
    }

    /// The model in a JSON text: a bare one, or that of a fit.
    #[classmethod]
    fn from_json(cls: &Bound<'_, PyType>, text: &str) -> PyResult<Py<Self>> {
        Self::object(cls.py(), model_from_json(text)?)
    }

    /// The model in a dictionary: a bare one, or that of a fit.
    #[classmethod]
    fn from_dict(cls: &Bound<'_, PyType>, document: &Bound<'_, PyAny>) -> PyResult<Py<Self>> {
        Self::object(cls.py(), model_from_json(&from_python(document)?)?)
    }

    /// The model in a JSON file: a bare one, or that of a fit.
    #[classmethod]
    fn load(cls: &Bound<'_, PyType>, path: PathBuf) -> PyResult<Py<Self>> {
        Self::object(cls.py(), model_from_json(&read_text(&path)?)?)
    }

    /// The arguments that make this very model again.
    fn __getnewargs_ex__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyTuple>, Bound<'py, PyDict>)> {
        let arguments = (self.0.shape.size(), self.0.shape.exponents()).into_pyobject(py)?;
        let pose = PyDict::new(py);
        let rotation: [[f64; 3]; 3] = self.0.pose.rotation().matrix().transpose().into();
        pose.set_item("rotation", rotation)?;
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
