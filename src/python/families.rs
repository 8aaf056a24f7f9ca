//! The kinds of `superquadric.Shape`.

use pyo3::prelude::*;

use super::arrays::{Doubles, Vector, vector};
use super::model::PyModel;
use super::pose::pose_of;
use super::shape::PyShape;
use crate::model::Model;
use crate::shape::{
    Shape, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid, ThreeExponent,
};

/// The Python object of a model.
pub(super) fn to_python(py: Python<'_>, model: Model<Shape>) -> PyResult<Py<PyAny>> {
    let base = PyClassInitializer::from(PyShape(model));
    Ok(match model.shape {
        Shape::Superellipsoid(shape) => {
            PyModel::object(py, Model { shape, pose: model.pose })?.into_any()
        }
        Shape::SuperhyperboloidOneSheet(shape) => {
            Py::new(py, base.add_subclass(PyOneSheet(shape)))?.into_any()
        }
        Shape::SuperhyperboloidTwoSheets(shape) => {
            Py::new(py, base.add_subclass(PyTwoSheets(shape)))?.into_any()
        }
        Shape::Supertoroid(shape) => {
            Py::new(py, base.add_subclass(PySupertoroid(shape)))?.into_any()
        }
        Shape::ThreeExponent(shape) => {
            Py::new(py, base.add_subclass(PyThreeExponent(shape)))?.into_any()
        }
    })
}

/// A superhyperboloid of one sheet in general position, between two planes: a tower with a waist.
///
/// In its own frame it is the solid `((x/a1)^(2/e2) + (y/a2)^(2/e2))^(e2/e1) - (z/a3)^(2/e1) <= 1`
/// (JLS Eq. 2.21) with `|z| <= clip`.
///
/// Args:
///     size: semi-axes a1, a2, a3.
///     exponents: e1 (north-south) and e2 (east-west).
///     clip: half of the height.
///     euler_zyz, rotation, translation: as of `Superellipsoid`.
///
/// Raises:
///     ModelError: if a parameter is outside its domain.
#[pyclass(frozen, extends = PyShape, name = "SuperhyperboloidOneSheet", module = "superquadric")]
pub(super) struct PyOneSheet(SuperhyperboloidOneSheet);

/// A superhyperboloid of two sheets in general position: two bowls that face away from each other.
///
/// In its own frame these are `((x/a1)^(2/e2) - (y/a2)^(2/e2))^(e2/e1) - (z/a3)^(2/e1) >= 1` with
/// `|x| <= clip`. So that inside is below 1, `inside_outside` is 2 less that function (JLS Eq.
/// 2.23).
///
/// Args:
///     size: semi-axes a1, a2, a3.
///     exponents: e1 (north-south) and e2 (east-west).
///     clip: the greatest `|x|`, above a1.
///     euler_zyz, rotation, translation: as of `Superellipsoid`.
///
/// Raises:
///     ModelError: if a parameter is outside its domain.
#[pyclass(frozen, extends = PyShape, name = "SuperhyperboloidTwoSheets", module = "superquadric")]
pub(super) struct PyTwoSheets(SuperhyperboloidTwoSheets);

/// A supertoroid in general position (JLS Eq. 2.27): a tube around a ring.
///
/// Args:
///     size: semi-axes a1, a2, a3 of the tube.
///     exponents: e1 (of the tube) and e2 (of the ring).
///     ring: a4, a ratio of at least 1: the ring's semi-axes are `a1 a4` and `a2 a4`.
///     euler_zyz, rotation, translation: as of `Superellipsoid`.
///
/// Raises:
///     ModelError: if a parameter is outside its domain.
#[pyclass(frozen, extends = PyShape, name = "Supertoroid", module = "superquadric")]
pub(super) struct PySupertoroid(Supertoroid);

/// The solid `|x/a1|^n1 + |y/a2|^n2 + |z/a3|^n3 <= 1` (FB81) in general position.
///
/// Args:
///     size: semi-axes a1, a2, a3.
///     exponents: n1, n2, n3; 2 is round.
///     euler_zyz, rotation, translation: as of `Superellipsoid`.
///
/// Raises:
///     ModelError: if a parameter is outside its domain.
#[pyclass(frozen, extends = PyShape, name = "ThreeExponent", module = "superquadric")]
pub(super) struct PyThreeExponent(ThreeExponent);

/// The methods of a kind that has one more parameter than size and exponents.
///
/// Not formatted by rustfmt, which would indent the attribute further each time.
#[rustfmt::skip]
macro_rules! kind_with_parameter {
    ($class:ident, $family:ident, $parameter:ident, $documentation:literal, $signature:literal) => {
        #[pymethods]
        impl $class {
            #[new]
            #[pyo3(
                signature = (
                    size, exponents, $parameter, *,
                    euler_zyz = None, rotation = None, translation = None
                ),
                text_signature = $signature
            )]
            fn new(
                size: &Bound<'_, PyAny>,
                exponents: &Bound<'_, PyAny>,
                $parameter: f64,
                euler_zyz: Option<&Bound<'_, PyAny>>,
                rotation: Option<&Bound<'_, PyAny>>,
                translation: Option<&Bound<'_, PyAny>>,
            ) -> PyResult<PyClassInitializer<Self>> {
                let size = Doubles::new("size", size)?.vector()?;
                let exponents = Doubles::new("exponents", exponents)?.vector()?;
                let shape = $family::new(size, exponents, $parameter)?;
                let pose = pose_of(euler_zyz, rotation, translation)?;
                let base = PyShape(Model { shape: shape.into(), pose });
                Ok(PyClassInitializer::from(base).add_subclass(Self(shape)))
            }

            /// Semi-axes a1, a2, a3: float64 of shape (3,).
            #[getter]
            fn size<'py>(&self, py: Python<'py>) -> Vector<'py> {
                vector(py, &self.0.size())
            }

            /// Exponents e1 and e2: float64 of shape (2,).
            #[getter]
            fn exponents<'py>(&self, py: Python<'py>) -> Vector<'py> {
                vector(py, &self.0.exponents())
            }

            #[doc = $documentation]
            #[getter]
            fn $parameter(&self) -> f64 {
                self.0.$parameter()
            }
        }
    };
}

kind_with_parameter!(
    PyOneSheet,
    SuperhyperboloidOneSheet,
    clip,
    "Half of the height.",
    "(size, exponents, clip, *, euler_zyz=None, rotation=None, translation=(0.0, 0.0, 0.0))"
);
kind_with_parameter!(
    PyTwoSheets,
    SuperhyperboloidTwoSheets,
    clip,
    "The greatest `|x|`.",
    "(size, exponents, clip, *, euler_zyz=None, rotation=None, translation=(0.0, 0.0, 0.0))"
);
kind_with_parameter!(
    PySupertoroid,
    Supertoroid,
    ring,
    "The ring's a4, a ratio.",
    "(size, exponents, ring, *, euler_zyz=None, rotation=None, translation=(0.0, 0.0, 0.0))"
);

#[pymethods]
impl PyThreeExponent {
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
        let shape = ThreeExponent::new(size, exponents)?;
        let pose = pose_of(euler_zyz, rotation, translation)?;
        let base = PyShape(Model { shape: shape.into(), pose });
        Ok(PyClassInitializer::from(base).add_subclass(Self(shape)))
    }

    /// Semi-axes a1, a2, a3: float64 of shape (3,).
    #[getter]
    fn size<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.size())
    }

    /// Exponents n1, n2, n3: float64 of shape (3,).
    #[getter]
    fn exponents<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.exponents())
    }
}
