//! Plane curves on arrays of parameters, and their spherical product.

use nalgebra::Vector2;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;

use super::arrays::{Array, Doubles, Vector, map_angles, shaped, vector};
use super::polyline::PyPolyline;
use crate::shape::{
    Curve, CurvePoint, LameArc, LameCurve, Parametric, Polyline, SphericalProduct, Superellipse,
    Superhyperbola,
};

/// The superellipse `|x/a|^(2/e) + |y/b|^(2/e) = 1` (JLS Eq. 2.4), by an angle in [-pi, pi).
///
/// Args:
///     size: semi-axes a, b.
///     exponent: e; 1 is an ellipse.
///
/// Raises:
///     ModelError: if a parameter is not a positive, finite number.
#[pyclass(frozen, name = "Superellipse", module = "superquadric")]
pub(super) struct PySuperellipse(Superellipse);

/// The superhyperbola `|x/a|^(2/e) - |y/b|^(2/e) = 1` (B81), by an angle in (-pi/2, pi/2); half a
/// turn leads to the other branch.
///
/// Args:
///     size: semi-axes a, b.
///     exponent: e; 1 is a hyperbola.
///
/// Raises:
///     ModelError: if a parameter is not a positive, finite number.
#[pyclass(frozen, name = "Superhyperbola", module = "superquadric")]
pub(super) struct PySuperhyperbola(Superhyperbola);

/// The Lame curve `(x/a)^m + (y/b)^m = 1` for m = numerator / denominator (JLS Eq. 2.3), in arcs of
/// one quadrant each, by an angle in [0, pi/2].
///
/// Args:
///     size: semi-axes a, b.
///     numerator, denominator: of m; the numerator may be negative.
///
/// Raises:
///     ModelError: if a semi-axis is not a positive, finite number, or m is 0 or no fraction.
#[pyclass(frozen, name = "LameCurve", module = "superquadric")]
pub(super) struct PyLameCurve(LameCurve);

/// The methods of a curve of one arc.
///
/// Not formatted by rustfmt, which would indent the attribute further each time.
#[rustfmt::skip]
macro_rules! curve_of_one_arc {
    ($class:ident, $curve:ident) => {
        #[pymethods]
        impl $class {
            #[new]
            fn new(size: &Bound<'_, PyAny>, exponent: f64) -> PyResult<Self> {
                Ok(Self($curve::new(Doubles::new("size", size)?.vector()?, exponent)?))
            }

            /// Semi-axes a, b: float64 of shape (2,).
            #[getter]
            fn size<'py>(&self, py: Python<'py>) -> Vector<'py> {
                vector(py, &self.0.size())
            }

            /// The exponent e.
            #[getter]
            fn exponent(&self) -> f64 {
                self.0.exponent()
            }

            /// Points, of shape (..., 2), at parameters of shape (...).
            fn position<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
                map_parameters(theta, &self.0, |point| point.position)
            }

            /// First derivatives, of shape (..., 2), at parameters of shape (...).
            fn tangent<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
                map_parameters(theta, &self.0, |point| point.tangent)
            }

            /// Second derivatives, of shape (..., 2), at parameters of shape (...).
            fn second_derivative<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
                map_parameters(theta, &self.0, |point| point.second)
            }
        }
    };
}

curve_of_one_arc!(PySuperellipse, Superellipse);
curve_of_one_arc!(PySuperhyperbola, Superhyperbola);

#[pymethods]
impl PyLameCurve {
    #[new]
    #[pyo3(signature = (size, numerator, denominator = 1))]
    fn new(size: &Bound<'_, PyAny>, numerator: i32, denominator: u32) -> PyResult<Self> {
        let size = Doubles::new("size", size)?.vector()?;
        Ok(Self(LameCurve::new(size, numerator, denominator)?))
    }

    /// Semi-axes a, b: float64 of shape (2,).
    #[getter]
    fn size<'py>(&self, py: Python<'py>) -> Vector<'py> {
        vector(py, &self.0.size())
    }

    /// The exponent m.
    #[getter]
    fn exponent(&self) -> f64 {
        self.0.exponent()
    }

    /// The number, 1 to 9, of the curve's kind in JLS's list (section 2.1.1).
    #[getter]
    fn kind(&self) -> u8 {
        self.0.kind()
    }

    /// How many arcs there are: 1, 3 or 4.
    #[getter]
    fn arcs(&self) -> usize {
        self.0.arcs().len()
    }

    /// Points of an arc, of shape (..., 2), at parameters of shape (...).
    #[pyo3(signature = (theta, arc = 0))]
    fn position<'py>(&self, theta: &Bound<'py, PyAny>, arc: usize) -> PyResult<Array<'py>> {
        map_parameters(theta, &self.arc(arc)?, |point| point.position)
    }

    /// First derivatives along an arc, of shape (..., 2), at parameters of shape (...).
    #[pyo3(signature = (theta, arc = 0))]
    fn tangent<'py>(&self, theta: &Bound<'py, PyAny>, arc: usize) -> PyResult<Array<'py>> {
        map_parameters(theta, &self.arc(arc)?, |point| point.tangent)
    }

    /// Second derivatives along an arc, of shape (..., 2), at parameters of shape (...).
    #[pyo3(signature = (theta, arc = 0))]
    fn second_derivative<'py>(
        &self,
        theta: &Bound<'py, PyAny>,
        arc: usize,
    ) -> PyResult<Array<'py>> {
        map_parameters(theta, &self.arc(arc)?, |point| point.second)
    }
}

impl PyLameCurve {
    fn arc(&self, arc: usize) -> PyResult<LameArc> {
        let arcs = self.0.arcs();
        let message = || format!("arc: expected a number below {}, found {arc}", arcs.len());
        arcs.get(arc).copied().ok_or_else(|| PyIndexError::new_err(message()))
    }
}

/// Points of the spherical product of two curves (B81): `(m1 h1, m1 h2, m2)`.
///
/// Args:
///     north: the vertical curve m; of a Lame curve the first arc.
///     east: the horizontal curve h; of a Lame curve the first arc.
///     eta: parameters of `north`.
///     omega: parameters of `east`, broadcast together with `eta`.
///
/// Returns:
///     Points of shape (..., 3).
///
/// Raises:
///     TypeError: if one of the curves is none.
#[pyfunction]
pub(super) fn spherical_product<'py>(
    north: AnyCurve<'py>,
    east: AnyCurve<'py>,
    eta: &Bound<'py, PyAny>,
    omega: &Bound<'py, PyAny>,
) -> PyResult<Array<'py>> {
    let surface = SphericalProduct { meridian: north.arc(), equator: east.arc() };
    map_angles(eta, omega, |eta, omega| surface.position(eta, omega))
}

/// A curve of any of the four classes.
#[derive(FromPyObject)]
pub(super) enum AnyCurve<'py> {
    Superellipse(PyRef<'py, PySuperellipse>),
    Superhyperbola(PyRef<'py, PySuperhyperbola>),
    Lame(PyRef<'py, PyLameCurve>),
    Polyline(PyRef<'py, PyPolyline>),
}

impl AnyCurve<'_> {
    fn arc(&self) -> AnyArc<'_> {
        match self {
            Self::Superellipse(curve) => AnyArc::Superellipse(curve.0),
            Self::Superhyperbola(curve) => AnyArc::Superhyperbola(curve.0),
            // Every Lame curve has the arc of the first quadrant.
            Self::Lame(curve) => AnyArc::Lame(curve.0.arcs()[0]),
            Self::Polyline(curve) => AnyArc::Polyline(&curve.0),
        }
    }
}

/// A curve of one parameter.
enum AnyArc<'a> {
    Superellipse(Superellipse),
    Superhyperbola(Superhyperbola),
    Lame(LameArc),
    Polyline(&'a Polyline),
}

impl Curve for AnyArc<'_> {
    fn range(&self) -> [f64; 2] {
        match self {
            Self::Superellipse(curve) => curve.range(),
            Self::Superhyperbola(curve) => curve.range(),
            Self::Lame(arc) => arc.range(),
            Self::Polyline(line) => line.range(),
        }
    }

    fn at(&self, t: f64) -> CurvePoint {
        match self {
            Self::Superellipse(curve) => curve.at(t),
            Self::Superhyperbola(curve) => curve.at(t),
            Self::Lame(arc) => arc.at(t),
            Self::Polyline(line) => line.at(t),
        }
    }
}

/// A pair of numbers for each parameter, in an array of shape (..., 2).
pub(super) fn map_parameters<'py>(
    theta: &Bound<'py, PyAny>,
    curve: &(impl Curve + Sync),
    part: impl Fn(CurvePoint) -> Vector2<f64> + Sync,
) -> PyResult<Array<'py>> {
    let py = theta.py();
    let theta = Doubles::new("theta", theta)?;
    let parameters = theta.values()?;
    let pair = |&t: &f64| <[f64; 2]>::from(part(curve.at(t)));
    let pairs: Vec<[f64; 2]> = py.detach(|| parameters.iter().map(pair).collect());
    shaped(py, pairs.into_flattened(), &[theta.shape(), &[2]].concat())
}
