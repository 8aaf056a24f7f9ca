//! The superellipse (JLS section 2.1, B81).

use std::f64::consts::PI;

use nalgebra::Vector2;

use super::curve::{Curve, CurvePoint, Jet};
use crate::error::ModelError;
use crate::math::superellipse_norm;
use crate::math::{beta, signed_power};

/// The plane figure `|x/a|^(2/e) + |y/b|^(2/e) <= 1` (JLS Eq. 2.4) with semi-axes a, b in the
/// model's unit. Domain: any positive exponent; the figure is convex up to 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Superellipse {
    size: [f64; 2],
    exponent: f64,
}

impl Superellipse {
    /// A superellipse of semi-axes `[a, b]` and an exponent e.
    ///
    /// # Errors
    /// If one of them is not a positive, finite number.
    pub fn new(size: [f64; 2], exponent: f64) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        super::validated_exponents(&[exponent])?;
        Ok(Self { size, exponent })
    }

    /// A superellipse of semi-axes and an exponent known to be valid.
    pub(crate) fn of(size: [f64; 2], exponent: f64) -> Self {
        Self { size, exponent }
    }

    /// Semi-axes `[a, b]`.
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// The exponent e.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// The curve's point `(a cos^e, b sin^e)` at an angle theta in [-pi, pi) (JLS Eq. 2.9).
    pub fn position(&self, theta: f64) -> Vector2<f64> {
        let (sin, cos) = theta.sin_cos();
        let e = self.exponent;
        Vector2::new(self.size[0] * signed_power(cos, e), self.size[1] * signed_power(sin, e))
    }

    /// The gauge `(|x/a|^(2/e) + |y/b|^(2/e))^(e/2)`: homogeneous of degree one, 1 on the curve.
    pub fn gauge(&self, x: &Vector2<f64>) -> f64 {
        let [a, b] = self.size;
        superellipse_norm(x.x.abs() / a, x.y.abs() / b, self.exponent)
    }

    /// Area `2 a b e B(e/2, e/2 + 1)` (JLS Eq. 2.52).
    pub fn area(&self) -> f64 {
        let [a, b] = self.size;
        a * b * unit_area(self.exponent)
    }

    /// Moments of inertia `[Ixx, Iyy, Izz]` of unit density about the axes x, y and z: the
    /// integrals of `y^2`, `x^2` and their sum (JLS Eqs. 2.63-2.65, the last without its slip of
    /// a factor 2). The moment of deviation Ixy vanishes (JLS Eq. 2.66).
    pub fn inertia(&self) -> [f64; 3] {
        let [a, b] = self.size;
        let moment = unit_second_moment(self.exponent);
        [a * b.powi(3) * moment, a.powi(3) * b * moment, a * b * (a * a + b * b) * moment]
    }
}

impl Curve for Superellipse {
    fn range(&self) -> [f64; 2] {
        [-PI, PI]
    }

    fn at(&self, theta: f64) -> CurvePoint {
        let [cos, sin] = Jet::cos_sin(theta);
        let [a, b] = self.size;
        CurvePoint::of_components([cos.power(self.exponent, a), sin.power(self.exponent, b)])
    }
}

/// Area of the superellipse with semi-axes 1 (JLS Eq. 2.52).
pub(crate) fn unit_area(e: f64) -> f64 {
    2.0 * e * beta(0.5 * e, 0.5 * e + 1.0)
}

/// The integral of `x^2` over the superellipse with semi-axes 1 (JLS Eq. 2.64).
pub(crate) fn unit_second_moment(e: f64) -> f64 {
    0.5 * e * beta(1.5 * e, 0.5 * e)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Error of exponent 1e-5 in place of 0, which is quadratic.
    const NEAR_ZERO: f64 = 1e-9;

    #[test]
    fn areas_of_a_rectangle_an_ellipse_and_a_deltoid() {
        for (e, expected) in [(1e-5, 4.0), (1.0, PI), (2.0, 2.0)] {
            let area = Superellipse::new([2.0, 0.3], e).unwrap().area();
            assert!((area / (0.6 * expected) - 1.0).abs() < NEAR_ZERO, "{e}");
        }
    }

    /// JLS Table 2.2.
    #[test]
    fn moments_of_jls_table_2_2() {
        let [a, b] = [2.0_f64, 0.3_f64];
        for (e, factor) in [(1e-5, 4.0 / 3.0), (1.0, PI / 4.0)] {
            let inertia = Superellipse::new([a, b], e).unwrap().inertia();
            let expected =
                [a * b.powi(3), a.powi(3) * b, a * b * (a * a + b * b)].map(|m| m * factor);
            for (found, expected) in inertia.into_iter().zip(expected) {
                assert!((found / expected - 1.0).abs() < NEAR_ZERO, "{e}");
            }
        }
    }

    #[test]
    fn masses_are_sums_over_a_grid() {
        for e in [0.1, 0.5, 1.0, 1.5, 2.0, 3.0] {
            let figure = Superellipse::new([2.0, 0.3], e).unwrap();
            let n = 2000;
            let [mut area, mut ixx, mut iyy] = [0.0; 3];
            // Columns of exact height over midpoints, on the quarter.
            for i in 0..n {
                let u = (f64::from(i) + 0.5) / f64::from(n);
                let height = 0.3 * (1.0 - u.powf(2.0 / e)).powf(0.5 * e);
                let x = 2.0 * u;
                area += height;
                ixx += height.powi(3) / 3.0;
                iyy += x * x * height;
            }
            let cell = 4.0 * 2.0 / f64::from(n);
            let found = [figure.area(), figure.inertia()[0], figure.inertia()[1]];
            for (found, sum) in found.into_iter().zip([area, ixx, iyy]) {
                // Midpoints miss a cusp by a power of their distance.
                assert!((cell * sum / found - 1.0).abs() < 3e-4, "{e} {found} {}", cell * sum);
            }
        }
    }

    #[test]
    fn positions_have_gauge_one() {
        for e in [0.05, 0.5, 1.0, 2.0, 3.0] {
            let figure = Superellipse::new([2.0, 0.3], e).unwrap();
            for i in -16..16 {
                let x = figure.position(f64::from(i) * PI / 16.0);
                assert!((figure.gauge(&x) - 1.0).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn parameters_outside_their_domain_are_refused() {
        assert!(Superellipse::new([1.0, 0.0], 1.0).is_err());
        assert!(Superellipse::new([1.0, 1.0], f64::NAN).is_err());
    }
}
