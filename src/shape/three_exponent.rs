//! The solid of three exponents (FB81).

mod mass;
mod support;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Matrix3, Vector3};

use super::curve::{Jet, times};
use super::form::magnitude_power;
use super::mass::MassProperties;
use super::parametric::{Parametric, direction};
use super::solid::Solid;
use crate::error::ModelError;
use crate::math::signed_power;

/// The solid `|x/a1|^n1 + |y/a2|^n2 + |z/a3|^n3 <= 1` (FB81), semi-axes in the model's unit.
///
/// Equal exponents n make the superellipsoid of exponents `e1 = e2 = 2/n`. Domain: any positive
/// exponents; all at least 1 make it convex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreeExponent {
    size: [f64; 3],
    exponents: [f64; 3],
}

impl ThreeExponent {
    /// A solid of semi-axes `[a1, a2, a3]` and exponents `[n1, n2, n3]`.
    ///
    /// # Errors
    /// If one of them is not a positive, finite number.
    pub fn new(size: [f64; 3], exponents: [f64; 3]) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        super::validated_exponents(&exponents)?;
        Ok(Self { size, exponents })
    }

    /// Semi-axes `[a1, a2, a3]`.
    pub fn size(&self) -> [f64; 3] {
        self.size
    }

    /// Exponents `[n1, n2, n3]` of x, y and z.
    pub fn exponents(&self) -> [f64; 3] {
        self.exponents
    }

    /// The form on which the normals lie: exponents `n/(n - 1)`, semi-axes `n/(g a)` with g the
    /// geometric mean of the exponents. Its dual is this shape where the exponents are equal, else
    /// one of other semi-axes.
    ///
    /// # Errors
    /// If an exponent is not above 1.
    pub fn dual(&self) -> Result<Self, ModelError> {
        let mean = self.exponents.iter().product::<f64>().cbrt();
        let size = std::array::from_fn(|i| self.exponents[i] / (mean * self.size[i]));
        Self::new(size, self.exponents.map(|n| if n > 1.0 { n / (n - 1.0) } else { f64::NAN }))
    }

    fn ratios(&self, x: &Vector3<f64>) -> [f64; 3] {
        std::array::from_fn(|i| x[i] / self.size[i])
    }

    /// The factor that moves a point, not the centre, onto the surface along its ray.
    pub(crate) fn radial_factor(&self, x: &Vector3<f64>) -> f64 {
        let logs = self.ratios(x).map(|u| u.abs().ln());
        let terms: [_; 3] = std::array::from_fn(|i| (self.exponents[i], logs[i]));
        log_shift(&terms, 0.0).exp()
    }

    /// Powers of the cosines and sines of latitude and longitude whose products are coordinates.
    fn factors(&self, eta: f64, omega: f64) -> [[Jet; 2]; 3] {
        let [[cos_eta, sin_eta], [cos_omega, sin_omega]] = [eta, omega].map(Jet::cos_sin);
        let one = Jet { value: 1.0, first: 0.0, second: 0.0 };
        let [e1, e2, e3] = self.exponents.map(|n| 2.0 / n);
        let [a1, a2, a3] = self.size;
        [
            [cos_eta.power(e1, a1), cos_omega.power(e1, 1.0)],
            [cos_eta.power(e2, a2), sin_omega.power(e2, 1.0)],
            [sin_eta.power(e3, a3), one],
        ]
    }

    fn product(
        &self,
        [eta, omega]: [f64; 2],
        of: impl Fn(Jet) -> f64,
        by: impl Fn(Jet) -> f64,
    ) -> Vector3<f64> {
        self.factors(eta, omega).map(|[m, h]| times(of(m), by(h))).into()
    }
}

/// The shift s for which the terms `exp(n (s + l))` of pairs `(n, l)` add up to `exp(target)`.
///
/// The logarithm of the sum is convex in s: Newton's iteration from above descends to the root.
pub(crate) fn log_shift(terms: &[(f64, f64)], target: f64) -> f64 {
    let alone = |&(n, l): &(f64, f64)| target / n - l;
    let mut shift = terms.iter().map(alone).fold(f64::INFINITY, f64::min);
    for _ in 0..200 {
        let powers = terms.iter().map(|(n, l)| (n, (n * (shift + l)).exp()));
        let (sum, slope) = powers.fold((0.0, 0.0), |(s, d), (n, power)| (s + power, d + n * power));
        let step = (sum.ln() - target) * sum / slope;
        let is_settled = step.abs() <= f64::EPSILON * (1.0 + shift.abs());
        shift -= step;
        if is_settled {
            break;
        }
    }
    shift
}

impl Solid for ThreeExponent {
    fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        self.ratios(x).iter().zip(self.exponents).map(|(u, n)| u.abs().powf(n)).sum()
    }

    fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        let ratios = self.ratios(x);
        Vector3::from_fn(|i, _| magnitude_power(ratios[i], self.exponents[i]).first / self.size[i])
    }

    fn inside_outside_hessian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        let ratios = self.ratios(x);
        Matrix3::from_diagonal(&Vector3::from_fn(|i, _| {
            magnitude_power(ratios[i], self.exponents[i]).second / self.size[i].powi(2)
        }))
    }

    /// That along the ray from the centre; at the centre, along one to a corner of the box.
    fn radial_distance(&self, x: &Vector3<f64>) -> f64 {
        if *x == Vector3::zeros() {
            let corner = Vector3::from(self.size);
            return -corner.norm() * self.radial_factor(&corner);
        }
        x.norm() * (1.0 - self.radial_factor(x))
    }

    fn support(&self, n: &Vector3<f64>) -> f64 {
        self.greatest_projection(n)
    }

    fn mass_properties(&self) -> MassProperties {
        self.masses()
    }

    fn surface_area(&self) -> f64 {
        self.area()
    }
}

impl Parametric for ThreeExponent {
    fn domain(&self) -> [[f64; 2]; 2] {
        [[-FRAC_PI_2, FRAC_PI_2], [-PI, PI]]
    }

    fn position(&self, eta: f64, omega: f64) -> Vector3<f64> {
        self.product([eta, omega], |m| m.value, |h| h.value)
    }

    fn tangents(&self, eta: f64, omega: f64) -> [Vector3<f64>; 2] {
        let at = [eta, omega];
        [self.product(at, |m| m.first, |h| h.value), self.product(at, |m| m.value, |h| h.first)]
    }

    fn second_derivatives(&self, eta: f64, omega: f64) -> [Vector3<f64>; 3] {
        let at = [eta, omega];
        [
            self.product(at, |m| m.second, |h| h.value),
            self.product(at, |m| m.first, |h| h.first),
            self.product(at, |m| m.value, |h| h.second),
        ]
    }

    /// Along the gradient of F, from latitude and longitude.
    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let least = self.size.into_iter().fold(f64::INFINITY, f64::min);
        let (sin, cos) = eta.sin_cos();
        let roots = [cos * omega.cos(), cos * omega.sin(), sin];
        direction(std::array::from_fn(|i| {
            let n = self.exponents[i];
            n * least / self.size[i] * signed_power(roots[i], 2.0 - 2.0 / n)
        }))
    }
}
