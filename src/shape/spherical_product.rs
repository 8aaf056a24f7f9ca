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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{CurvePoint, Superellipse, Superhyperbola};
    use std::f64::consts::{FRAC_PI_2, PI};

    fn circle(radius: f64) -> Superellipse {
        Superellipse::new([radius, radius], 1.0).unwrap()
    }

    /// A horizontal star of five points, as in B81 Fig. 1: `(1 + b cos 5t)(cos t, sin t)`.
    struct Star;

    impl Curve for Star {
        fn range(&self) -> [f64; 2] {
            [-PI, PI]
        }

        fn at(&self, t: f64) -> CurvePoint {
            const DEPTH: f64 = 0.3;
            let [along, across] = [Vector2::new(t.cos(), t.sin()), Vector2::new(-t.sin(), t.cos())];
            let (sin, cos) = (5.0 * t).sin_cos();
            let [r, dr, ddr] = [1.0 + DEPTH * cos, -5.0 * DEPTH * sin, -25.0 * DEPTH * cos];
            CurvePoint {
                position: r * along,
                tangent: dr * along + r * across,
                second: (ddr - r) * along + 2.0 * dr * across,
            }
        }
    }

    /// B81 Fig. 2.
    #[test]
    fn a_circle_times_a_circle_is_a_sphere() {
        let sphere = SphericalProduct { meridian: circle(1.0), equator: circle(1.0) };
        for (eta, omega) in [(0.3, 0.7), (-1.2, 2.0), (1.0, -3.0)] {
            let x = sphere.position(eta, omega);
            assert!((x.norm() - 1.0).abs() < 1e-15);
            assert!((sphere.normal(eta, omega) - x).norm() < 1e-14);
        }
    }

    /// B81 Fig. 3: the quadrics as products of a hyperbola with a circle and with a hyperbola.
    #[test]
    fn hyperbolas_make_the_quadrics() {
        let hyperbola = Superhyperbola::new([1.0, 1.0], 1.0).unwrap();
        let one_sheet = SphericalProduct { meridian: hyperbola, equator: circle(1.0) };
        let two_sheets = SphericalProduct { meridian: hyperbola, equator: hyperbola };
        for (eta, omega) in [(0.3, 0.7), (-1.2, 1.1), (1.0, -0.2)] {
            let [x, y, z] = one_sheet.position(eta, omega).into();
            assert!((x * x + y * y - z * z - 1.0).abs() < 1e-13);
            let [x, y, z] = two_sheets.position(eta, omega).into();
            assert!((x * x - y * y - z * z - 1.0).abs() < 1e-12);
        }
    }

    /// B81 Fig. 1.
    #[test]
    fn an_ellipse_lifts_and_scales_a_star() {
        let meridian = Superellipse::new([1.0, 2.0], 1.0).unwrap();
        let surface = SphericalProduct { meridian, equator: Star };
        assert_eq!(surface.domain(), [[-PI, PI], [-PI, PI]]);
        let tip = surface.position(0.0, 0.4 * PI);
        assert!((tip.norm() - 1.3).abs() < 1e-15);
        assert!((surface.position(FRAC_PI_2, 0.3).z - 2.0).abs() < 1e-15);
        let h = 1e-6;
        for (eta, omega) in [(0.3, 0.7), (-1.2, 2.0), (1.0, -3.0)] {
            let [r_eta, r_omega] = surface.tangents(eta, omega);
            let along = |d: f64| surface.position(eta, omega + d);
            let across = |d: f64| surface.position(eta + d, omega);
            assert!(((along(h) - along(-h)) / (2.0 * h) - r_omega).norm() < 1e-8);
            assert!(((across(h) - across(-h)) / (2.0 * h) - r_eta).norm() < 1e-8);
            let normal = surface.normal(eta, omega);
            assert!(normal.dot(&r_eta).abs() < 1e-14 && normal.dot(&r_omega).abs() < 1e-14);
            assert!(normal.dot(&surface.position(eta, omega)) > 0.0);
        }
    }
}
