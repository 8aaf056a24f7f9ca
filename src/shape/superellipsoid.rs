//! The superellipsoid in its own frame (B81; JLS section 2.2).

mod mass;
mod nearest;
mod solid;

use nalgebra::Vector3;

pub(crate) use mass::area_element;

use super::gauge::GaugeTerms;
use super::parametric::direction;
use crate::error::ModelError;
use crate::math::{signed_power, superellipse_norm};

/// The solid `((x/a1)^(2/e2) + (y/a2)^(2/e2))^(e2/e1) + (z/a3)^(2/e1) <= 1` (JLS Eq. 2.15).
///
/// `size` holds the semi-axes a1, a2, a3 in the model's unit, `exponents` e1 (north-south) and
/// e2 (east-west). Both exponents at most 2 make it convex; formulas are checked for exponents
/// from 0.05 to 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Superellipsoid {
    size: [f64; 3],
    exponents: [f64; 2],
}

impl Superellipsoid {
    /// A superellipsoid of semi-axes `[a1, a2, a3]` and exponents `[e1, e2]`.
    ///
    /// # Errors
    /// If one of them is not a positive, finite number.
    pub fn new(size: [f64; 3], exponents: [f64; 2]) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        super::validated_exponents(&exponents)?;
        Ok(Self { size, exponents })
    }

    /// Semi-axes `[a1, a2, a3]`.
    pub fn size(&self) -> [f64; 3] {
        self.size
    }

    /// Exponents `[e1, e2]`: north-south, east-west.
    pub fn exponents(&self) -> [f64; 2] {
        self.exponents
    }

    /// Arithmetic mean of the semi-axes, the length that errors are measured against.
    pub fn mean_semi_axis(&self) -> f64 {
        self.size.iter().sum::<f64>() / 3.0
    }

    /// The same shape, `factor` times as large.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        self.with_size(self.size.map(|a| a * factor))
    }

    /// The same exponents on other semi-axes, known to be valid.
    pub(crate) fn with_size(&self, size: [f64; 3]) -> Self {
        Self { size, ..*self }
    }

    /// Surface point at latitude `eta` in [-pi/2, pi/2] and longitude `omega` in [-pi, pi)
    /// (JLS Eq. 2.10).
    pub fn position(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let parallel = signed_power(eta.cos(), e1);
        Vector3::new(
            a1 * parallel * signed_power(omega.cos(), e2),
            a2 * parallel * signed_power(omega.sin(), e2),
            a3 * signed_power(eta.sin(), e1),
        )
    }

    /// Outward unit normal at latitude `eta` and longitude `omega`, from the dual superquadric
    /// (B81; JLS Eq. 2.39). Unique for exponents below 2; at an edge or a cusp of others one of
    /// those that meet there, or a mean.
    pub fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let least = a1.min(a2).min(a3);
        let parallel = signed_power(eta.cos(), 2.0 - e1);
        direction([
            least / a1 * parallel * signed_power(omega.cos(), 2.0 - e2),
            least / a2 * parallel * signed_power(omega.sin(), 2.0 - e2),
            least / a3 * signed_power(eta.sin(), 2.0 - e1),
        ])
    }

    /// The gauge `H(x) = F(x)^(e1/2)`: homogeneous of degree one, 1 on the surface, 0 at the
    /// centre.
    pub fn gauge(&self, x: &Vector3<f64>) -> f64 {
        let [u, v, w]: [f64; 3] = std::array::from_fn(|i| x[i].abs() / self.size[i]);
        let [e1, e2] = self.exponents;
        superellipse_norm(superellipse_norm(u, v, e2), w, e1)
    }

    /// Gradient of the gauge at `x`; on the surface it points outwards along the normal.
    ///
    /// Homogeneous of degree zero. A component along an axis on whose plane of symmetry the
    /// point lies is 0; so is the whole at the centre, where none is defined.
    pub fn gauge_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        let terms = GaugeTerms::at((*x).into(), &self.size, &self.exponents);
        Vector3::from_fn(|i, _| {
            if x[i] == 0.0 {
                return 0.0;
            }
            (terms.weights[i] / (terms.inverse * terms.magnitudes[i])).copysign(x[i])
        })
    }

    /// The inside-outside function F: below 1 inside, 1 on the surface, above 1 outside (JLS
    /// Eq. 2.16). Far outside it overflows to infinity where `e1` is small; [`gauge`] does not.
    ///
    /// [`gauge`]: Self::gauge
    pub fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        self.gauge(x).powf(2.0 / self.exponents[0])
    }

    /// Signed radial Euclidean distance `|x| (1 - F^(-e1/2))`, negative inside (JLS Eq. 2.43).
    ///
    /// At the centre, where no ray is defined, that along a ray to a corner of the bounding box.
    pub fn radial_distance(&self, x: &Vector3<f64>) -> f64 {
        let terms = GaugeTerms::at((*x).into(), &self.size, &self.exponents);
        Vector3::from(terms.magnitudes).norm() * (1.0 - terms.inverse)
    }

    /// The point of the surface on the ray from the centre through `x`.
    ///
    /// At the centre, where no ray is defined, the centre itself.
    pub fn radial_projection(&self, x: &Vector3<f64>) -> Vector3<f64> {
        x * GaugeTerms::at((*x).into(), &self.size, &self.exponents).inverse
    }

    /// The support function `max { n . x : x in the solid }`, in the unit of `size` times that
    /// of `n`.
    ///
    /// It is the gauge of the polar, the dual superquadric with exponents `2 - e` (B81, JLS Eq.
    /// 2.39); from exponent 2 on, that of the convex hull.
    pub fn support(&self, n: &Vector3<f64>) -> f64 {
        let [u, v, w]: [f64; 3] = std::array::from_fn(|i| n[i].abs() * self.size[i]);
        let [d1, d2] = self.exponents.map(|e| (2.0 - e).max(0.0));
        superellipse_norm(superellipse_norm(u, v, d2), w, d1)
    }
}

#[cfg(test)]
mod tests;
