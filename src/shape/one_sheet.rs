//! The superhyperboloid of one sheet (B81; JLS Eqs. 2.20, 2.21).

mod mass;

use std::f64::consts::PI;

use nalgebra::{Matrix3, Vector3};

use super::form::{BarrForm, hyperbola_norm};
use super::mass::MassProperties;
use super::parametric::{Parametric, direction};
use super::solid::Solid;
use super::spherical_product::SphericalProduct;
use super::superellipse::Superellipse;
use super::superhyperbola::Superhyperbola;
use crate::error::ModelError;
use crate::math::signed_power;
use crate::math::superellipse_norm;

/// The solid `((x/a1)^(2/e2) + (y/a2)^(2/e2))^(e2/e1) - (z/a3)^(2/e1) <= 1` (JLS Eq. 2.21) between
/// the planes `z = -clip` and `z = clip`: a tower with a waist.
///
/// `size` holds the waist's semi-axes a1, a2 and the height a3 that goes with them, in the model's
/// unit, as `clip` is; `exponents` are e1 (north-south) and e2 (east-west). Domain: any positive
/// exponents. Latitudes get as near to the poles as doubles tell: `|z| < 1e16^e1 a3`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SuperhyperboloidOneSheet {
    size: [f64; 3],
    exponents: [f64; 2],
    clip: f64,
}

impl SuperhyperboloidOneSheet {
    /// A superhyperboloid of semi-axes `[a1, a2, a3]` and exponents `[e1, e2]` from `-clip` to
    /// `clip` in z.
    ///
    /// # Errors
    /// If one of them is not a positive, finite number.
    pub fn new(size: [f64; 3], exponents: [f64; 2], clip: f64) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        super::validated_exponents(&exponents)?;
        if !super::is_positive(clip) {
            return Err(ModelError::Clip { least: 0.0, value: clip });
        }
        Ok(Self { size, exponents, clip })
    }

    /// Semi-axes `[a1, a2, a3]`.
    pub fn size(&self) -> [f64; 3] {
        self.size
    }

    /// Exponents `[e1, e2]`: north-south, east-west.
    pub fn exponents(&self) -> [f64; 2] {
        self.exponents
    }

    /// Half of the height.
    pub fn clip(&self) -> f64 {
        self.clip
    }

    /// The dual, on which the normals lie: semi-axes `1/a`, exponents `2 - e`, clipped at the same
    /// latitude (B81). Its own dual is this shape.
    ///
    /// # Errors
    /// If an exponent is not below 2.
    pub fn dual(&self) -> Result<Self, ModelError> {
        let size = self.size.map(f64::recip);
        let exponents = self.exponents.map(|e| 2.0 - e);
        let clip = size[2] * self.top().powf(exponents[0] / self.exponents[0]);
        Self::new(size, exponents, clip)
    }

    /// The clip in units of a3.
    pub(crate) fn top(&self) -> f64 {
        self.clip / self.size[2]
    }

    /// How much wider than the waist it is at the height `w a3`, `w` not negative.
    pub(crate) fn radius(&self, w: f64) -> f64 {
        superellipse_norm(1.0, w, self.exponents[0])
    }

    fn form(&self) -> BarrForm {
        BarrForm { size: self.size, exponents: self.exponents, ring: 0.0, signs: [1.0, -1.0] }
    }

    fn product(&self) -> SphericalProduct<Superhyperbola, Superellipse> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        SphericalProduct {
            meridian: Superhyperbola::of([1.0, a3], e1),
            equator: Superellipse::of([a1, a2], e2),
        }
    }
}

impl Solid for SuperhyperboloidOneSheet {
    fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        self.form().value(x)
    }

    fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        self.form().derivatives(x).gradient
    }

    fn inside_outside_hessian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        self.form().derivatives(x).hessian
    }

    fn contains(&self, x: &Vector3<f64>) -> bool {
        x.z.abs() < self.clip && self.inside_outside(x) < 1.0
    }

    /// That to the unclipped surface along the ray from the centre; minus infinity where the ray
    /// runs within the asymptotic cone. At the centre, that of a ray to a corner of the waist.
    fn radial_distance(&self, x: &Vector3<f64>) -> f64 {
        let [a1, a2, _] = self.size;
        let [e1, e2] = self.exponents;
        if *x == Vector3::zeros() {
            return -a1.hypot(a2) / superellipse_norm(1.0, 1.0, e2);
        }
        let [u, v, w]: [f64; 3] = std::array::from_fn(|i| x[i].abs() / self.size[i]);
        let equatorial = superellipse_norm(u, v, e2);
        if equatorial <= w {
            return f64::NEG_INFINITY;
        }
        x.norm() * (1.0 - hyperbola_norm(equatorial, w, e1).recip())
    }

    fn support(&self, n: &Vector3<f64>) -> f64 {
        let [a1, a2, _] = self.size;
        let dual = (2.0 - self.exponents[1]).max(0.0);
        let waist = superellipse_norm(a1 * n.x.abs(), a2 * n.y.abs(), dual);
        self.radius(self.top()) * waist + self.clip * n.z.abs()
    }

    fn mass_properties(&self) -> MassProperties {
        self.masses()
    }

    fn surface_area(&self) -> f64 {
        self.area_of_side() + self.area_of_caps()
    }
}

impl Parametric for SuperhyperboloidOneSheet {
    fn domain(&self) -> [[f64; 2]; 2] {
        let north = self.top().powf(self.exponents[0].recip()).atan();
        [[-north, north], [-PI, PI]]
    }

    fn position(&self, eta: f64, omega: f64) -> Vector3<f64> {
        self.product().position(eta, omega)
    }

    fn tangents(&self, eta: f64, omega: f64) -> [Vector3<f64>; 2] {
        self.product().tangents(eta, omega)
    }

    fn second_derivatives(&self, eta: f64, omega: f64) -> [Vector3<f64>; 3] {
        self.product().second_derivatives(eta, omega)
    }

    /// From the dual (B81, whose third component lacks its minus).
    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let least = a1.min(a2).min(a3);
        direction([
            least / a1 * signed_power(omega.cos(), 2.0 - e2),
            least / a2 * signed_power(omega.sin(), 2.0 - e2),
            -least / a3 * signed_power(eta.sin(), 2.0 - e1),
        ])
    }
}
