//! The spherical product of two curves (B81).

use nalgebra::{Vector2, Vector3};

use super::curve::{Curve, times};
use super::parametric::{Parametric, direction};

/// The surface `(m1 h1, m1 h2, m2)` of two plane curves: a horizontal one, h(omega), which a
/// vertical one, m(eta), scales and raises (B81).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphericalProduct<M, H> {
    /// The vertical curve m.
    pub meridian: M,
    /// The horizontal curve h.
    pub equator: H,
}

impl<M: Curve, H: Curve> Parametric for SphericalProduct<M, H> {
    fn domain(&self) -> [[f64; 2]; 2] {
        [self.meridian.range(), self.equator.range()]
    }

    fn position(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let [m, h] = [self.meridian.at(eta).position, self.equator.at(omega).position];
        product(&m, &h)
    }

    fn tangents(&self, eta: f64, omega: f64) -> [Vector3<f64>; 2] {
        let (m, h) = (self.meridian.at(eta), self.equator.at(omega));
        [product(&m.tangent, &h.position), product(&level(&m.position), &h.tangent)]
    }

    fn second_derivatives(&self, eta: f64, omega: f64) -> [Vector3<f64>; 3] {
        let (m, h) = (self.meridian.at(eta), self.equator.at(omega));
        [
            product(&m.second, &h.position),
            product(&level(&m.tangent), &h.tangent),
            product(&level(&m.position), &h.second),
        ]
    }

    /// The unit vector along `r_omega x r_eta`, which points outwards where both curves run
    /// counter-clockwise. Domain: where both tangents are finite and not parallel; NaN elsewhere.
    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let [r_eta, r_omega] = self.tangents(eta, omega);
        direction(r_omega.cross(&r_eta).into())
    }
}

fn product(m: &Vector2<f64>, h: &Vector2<f64>) -> Vector3<f64> {
    Vector3::new(times(m.x, h.x), times(m.x, h.y), m.y)
}

/// The point that scales and does not raise.
fn level(m: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(m.x, 0.0)
}
