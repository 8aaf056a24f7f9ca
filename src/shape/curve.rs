//! Plane curves and powers of trigonometric functions along them.

use nalgebra::Vector2;

use crate::math::signed_power;

/// A plane curve over a parameter, in radians unless it says otherwise.
pub trait Curve {
    /// The natural range of the parameter.
    fn range(&self) -> [f64; 2];

    /// The curve's point at a parameter, and its derivatives.
    fn at(&self, t: f64) -> CurvePoint;
}

/// A point of a curve, and what its parameter does there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// The point.
    pub position: Vector2<f64>,
    /// Its first derivative.
    pub tangent: Vector2<f64>,
    /// Its second derivative.
    pub second: Vector2<f64>,
}

impl CurvePoint {
    /// The point of two functions and their derivatives.
    pub(crate) fn of_components([x, y]: [Jet; 2]) -> Self {
        Self {
            position: Vector2::new(x.value, y.value),
            tangent: Vector2::new(x.first, y.first),
            second: Vector2::new(x.second, y.second),
        }
    }
}

/// A function of one variable, with its first two derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jet {
    pub value: f64,
    pub first: f64,
    pub second: f64,
}

impl Jet {
    /// `cos` and `sin`.
    pub fn cos_sin(t: f64) -> [Self; 2] {
        let (sin, cos) = t.sin_cos();
        [
            Self { value: cos, first: -sin, second: -cos },
            Self { value: sin, first: cos, second: -sin },
        ]
    }

    /// `sec` and `tan`.
    pub fn sec_tan(t: f64) -> [Self; 2] {
        let (sin, cos) = t.sin_cos();
        let (sec, tan) = (cos.recip(), sin / cos);
        let slope = sec * sec;
        [
            Self { value: sec, first: sec * tan, second: sec * (slope + tan * tan) },
            Self { value: tan, first: slope, second: 2.0 * tan * slope },
        ]
    }

    /// `factor` times the signed power of the function.
    pub fn power(self, e: f64, factor: f64) -> Self {
        let Self { value: g, first, second } = self;
        let slope = e * g.abs().powf(e - 1.0);
        let bend = times(e * (e - 1.0) * sign(g), g.abs().powf(e - 2.0));
        Self {
            value: factor * signed_power(g, e),
            first: factor * times(slope, first),
            second: factor * (times(bend, first * first) + times(slope, second)),
        }
    }
}

/// The sign of a number, 0 for 0.
pub(crate) fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// The product in which 0 outweighs infinity: the limit on a plane of symmetry.
pub(crate) fn times(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}
