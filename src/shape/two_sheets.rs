//! The superhyperboloid of two sheets (B81; JLS Eqs. 2.22, 2.23).

mod mass;

use nalgebra::{Matrix3, Vector3};

use super::curve::sign;
use super::form::{BarrForm, equator_norm, hyperbola_norm};
use super::mass::MassProperties;
use super::parametric::{Parametric, direction};
use super::solid::Solid;
use super::spherical_product::SphericalProduct;
use super::superhyperbola::Superhyperbola;
use crate::error::ModelError;
use crate::math::superellipse_norm;
use crate::math::{maximum, signed_power};

/// The two bodies `((x/a1)^(2/e2) - (y/a2)^(2/e2))^(e2/e1) - (z/a3)^(2/e1) >= 1` with `|x| <=
/// clip`: two bowls that face away from each other along x.
///
/// `size` holds a1, half of the gap between the bowls, and the a2 and a3 that go with it, in the
/// model's unit, as `clip` is; `exponents` are e1 (north-south) and e2 (east-west). Domain: any
/// positive exponents.
///
/// The function of JLS Eq. 2.23 is above 1 in the bowls. So that inside is below 1 as with every
/// solid, the inside-outside function here is that function's mirror image at 1, `2 - F`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SuperhyperboloidTwoSheets {
    size: [f64; 3],
    exponents: [f64; 2],
    clip: f64,
}

impl SuperhyperboloidTwoSheets {
    /// A superhyperboloid of semi-axes `[a1, a2, a3]` and exponents `[e1, e2]` that ends at `clip`
    /// from the centre along x, on either side.
    ///
    /// # Errors
    /// If a semi-axis or an exponent is not a positive, finite number, or the clip is not above
    /// a1.
    pub fn new(size: [f64; 3], exponents: [f64; 2], clip: f64) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        super::validated_exponents(&exponents)?;
        if !(clip.is_finite() && clip > size[0]) {
            return Err(ModelError::Clip { least: size[0], value: clip });
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

    /// The greatest `|x|`.
    pub fn clip(&self) -> f64 {
        self.clip
    }

    /// The dual, on which the normals lie: semi-axes `1/a`, exponents `2 - e`, clipped at the same
    /// latitude of the meridian omega = 0 (B81). Its own dual is this shape.
    ///
    /// # Errors
    /// If an exponent is not below 2.
    pub fn dual(&self) -> Result<Self, ModelError> {
        let size = self.size.map(f64::recip);
        let exponents = self.exponents.map(|e| 2.0 - e);
        let clip = size[0] * self.top().powf(exponents[0] / self.exponents[0]);
        Self::new(size, exponents, clip)
    }

    /// The clip in units of a1.
    pub(crate) fn top(&self) -> f64 {
        self.clip / self.size[0]
    }

    /// `|x| / a1` of the surface over `[v a2, w a3]`, both not negative.
    pub(crate) fn height(&self, v: f64, w: f64) -> f64 {
        superellipse_norm(v, self.waist(w), self.exponents[1])
    }

    /// The least `|x| / a1` of the surface at `z = w a3`, and the `|y| / a2` at which it bends most.
    pub(crate) fn waist(&self, w: f64) -> f64 {
        superellipse_norm(1.0, w, self.exponents[0])
    }

    /// Values of `|z| / a3`, from 0 to the greatest, between which nothing bends sharply: the
    /// others are where the surface does, and where the rim crosses its edge `v = waist`.
    pub(crate) fn cuts_of_w(&self) -> Vec<f64> {
        let [e1, e2] = self.exponents;
        let crossing = self.top() / superellipse_norm(1.0, 1.0, e2);
        let crossing = if crossing > 1.0 { hyperbola_norm(crossing, 1.0, e1) } else { 1.0 };
        let mut cuts = vec![0.0, 1.0, crossing, self.greatest_vw()[1]];
        cuts.retain(|&cut| cut <= self.greatest_vw()[1]);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        cuts
    }

    /// The greatest `|y| / a2` and `|z| / a3`.
    pub(crate) fn greatest_vw(&self) -> [f64; 2] {
        let [e1, e2] = self.exponents;
        [e2, e1].map(|e| hyperbola_norm(self.top(), 1.0, e))
    }

    /// The greatest `|y| / a2` at `z = w a3`; that of the rim's point there.
    pub(crate) fn greatest_v(&self, w: f64) -> f64 {
        let waist = self.waist(w);
        hyperbola_norm(self.top().max(waist), waist, self.exponents[1])
    }

    fn form(&self) -> BarrForm {
        BarrForm { size: self.size, exponents: self.exponents, ring: 0.0, signs: [-1.0, -1.0] }
    }

    fn product(&self) -> SphericalProduct<Superhyperbola, Superhyperbola> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        SphericalProduct {
            meridian: Superhyperbola::of([1.0, a3], e1),
            equator: Superhyperbola::of([a1, a2], e2),
        }
    }
}

impl Solid for SuperhyperboloidTwoSheets {
    fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        2.0 - self.form().value(x)
    }

    fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        -self.form().derivatives(x).gradient
    }

    fn inside_outside_hessian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        -self.form().derivatives(x).hessian
    }

    fn contains(&self, x: &Vector3<f64>) -> bool {
        x.x.abs() < self.clip && self.inside_outside(x) < 1.0
    }

    /// That to the unclipped surface along the ray from the centre, which is outside; infinity
    /// where the ray runs outside the asymptotic cone. At the centre, a1.
    fn radial_distance(&self, x: &Vector3<f64>) -> f64 {
        if *x == Vector3::zeros() {
            return self.size[0];
        }
        let [e1, e2] = self.exponents;
        let [u, v, w]: [f64; 3] = std::array::from_fn(|i| x[i].abs() / self.size[i]);
        let equatorial = equator_norm(u, v, e2, -1.0);
        if equatorial <= w {
            return f64::INFINITY;
        }
        x.norm() * (hyperbola_norm(equatorial, w, e1).recip() - 1.0)
    }

    fn support(&self, n: &Vector3<f64>) -> f64 {
        let [_, a2, a3] = self.size;
        let along_rim = |w: f64| a2 * n.y.abs() * self.greatest_v(w) + a3 * n.z.abs() * w;
        self.clip * n.x.abs() + maximum(along_rim, [0.0, self.greatest_vw()[1]])
    }

    fn mass_properties(&self) -> MassProperties {
        self.masses()
    }

    fn surface_area(&self) -> f64 {
        self.area_of_bowls_and_caps()
    }
}

impl Parametric for SuperhyperboloidTwoSheets {
    /// The least ranges that hold the part of the first sheet up to the clip.
    fn domain(&self) -> [[f64; 2]; 2] {
        let [north, east] =
            self.exponents.map(|e| hyperbola_norm(self.top(), 1.0, e).powf(e.recip()).atan());
        [[-north, north], [-east, east]]
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

    /// From the dual (B81, whose second and third components lack their minus), out of the bowls.
    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let least = a1.min(a2).min(a3);
        let (sin, cos) = omega.sin_cos();
        direction([
            -least / a1 * sign(cos),
            least / a2 * signed_power(sin * sign(cos), 2.0 - e2),
            least / a3 * signed_power(eta.sin(), 2.0 - e1) * cos.abs().powf(2.0 - e2),
        ])
    }
}
