//! The supertoroid (B81; JLS Eqs. 2.26, 2.27).

mod mass;

use std::f64::consts::PI;

use nalgebra::{Matrix3, Vector3};

use super::curve::{Curve, CurvePoint};
use super::form::BarrForm;
use super::mass::MassProperties;
use super::parametric::{Parametric, direction};
use super::solid::Solid;
use super::spherical_product::SphericalProduct;
use super::superellipse::Superellipse;
use super::superellipsoid::Superellipsoid;
use crate::error::ModelError;
use crate::math::signed_power;
use crate::math::superellipse_norm;

/// The solid `|((x/a1)^(2/e2) + (y/a2)^(2/e2))^(e2/2) - a4|^(2/e1) + (z/a3)^(2/e1) <= 1` (JLS Eq.
/// 2.27): a tube around a ring.
///
/// `size` holds the tube's semi-axes a1, a2, a3 in the model's unit, `exponents` e1 (of the tube)
/// and e2 (of the ring). `ring` is a4, a ratio: the ring's own semi-axes are `a1 a4` and `a2 a4`.
/// Domain: any positive exponents, a ring of at least 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Supertoroid {
    size: [f64; 3],
    exponents: [f64; 2],
    ring: f64,
}

impl Supertoroid {
    /// A supertoroid of semi-axes `[a1, a2, a3]`, exponents `[e1, e2]` and the ring's a4.
    ///
    /// # Errors
    /// If a semi-axis or an exponent is not a positive, finite number, or the ring is below 1:
    /// the tube would pass through itself.
    pub fn new(size: [f64; 3], exponents: [f64; 2], ring: f64) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        super::validated_exponents(&exponents)?;
        if !(ring.is_finite() && ring >= 1.0) {
            return Err(ModelError::Ring { value: ring });
        }
        Ok(Self { size, exponents, ring })
    }

    /// Semi-axes `[a1, a2, a3]` of the tube.
    pub fn size(&self) -> [f64; 3] {
        self.size
    }

    /// Exponents `[e1, e2]`: of the tube, of the ring.
    pub fn exponents(&self) -> [f64; 2] {
        self.exponents
    }

    /// The ring's a4.
    pub fn ring(&self) -> f64 {
        self.ring
    }

    /// The form on which the normals lie, a torus whose ring has shrunk to nothing: the
    /// superellipsoid of semi-axes `1/a` and exponents `2 - e` (B81). Its dual is the
    /// superellipsoid of the tube, not this shape.
    ///
    /// # Errors
    /// If an exponent is not below 2.
    pub fn dual(&self) -> Result<Superellipsoid, ModelError> {
        Superellipsoid::new(self.size.map(f64::recip), self.exponents.map(|e| 2.0 - e))
    }

    fn form(&self) -> BarrForm {
        let Self { size, exponents, ring } = *self;
        BarrForm { size, exponents, ring, signs: [1.0; 2] }
    }

    fn product(&self) -> SphericalProduct<Tube, Superellipse> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let section = Superellipse::of([1.0, a3], e1);
        SphericalProduct {
            meridian: Tube { section, ring: self.ring },
            equator: Superellipse::of([a1, a2], e2),
        }
    }
}

/// A superellipse beside the axis.
struct Tube {
    section: Superellipse,
    ring: f64,
}

impl Curve for Tube {
    fn range(&self) -> [f64; 2] {
        self.section.range()
    }

    fn at(&self, theta: f64) -> CurvePoint {
        let mut point = self.section.at(theta);
        point.position.x += self.ring;
        point
    }
}

impl Solid for Supertoroid {
    fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        self.form().value(x)
    }

    fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        self.form().derivatives(x).gradient
    }

    fn inside_outside_hessian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        self.form().derivatives(x).hessian
    }

    /// That along the ray from the middle of the tube, in the half plane of the axis and the
    /// point. On the axis the half plane is that of positive x; on the middle itself the ray is one
    /// to a corner of the tube's box.
    fn radial_distance(&self, x: &Vector3<f64>) -> f64 {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let around = superellipse_norm(x.x.abs() / a1, x.y.abs() / a2, e2);
        // A unit of the tube's width in the half plane, in the model's unit.
        let width = if around == 0.0 { a1 } else { x.x.hypot(x.y) / around };
        let [u, w] = [(around - self.ring).abs(), x.z.abs() / a3];
        let gauge = superellipse_norm(u, w, e1);
        if gauge == 0.0 {
            return -width.hypot(a3) / superellipse_norm(1.0, 1.0, e1);
        }
        (u * width).hypot(x.z) * (1.0 - gauge.recip())
    }

    /// The ring's support and the tube's. From exponent 2 on, that of the convex hull.
    fn support(&self, n: &Vector3<f64>) -> f64 {
        let [u, v, w]: [f64; 3] = std::array::from_fn(|i| n[i].abs() * self.size[i]);
        let [d1, d2] = self.exponents.map(|e| (2.0 - e).max(0.0));
        let equatorial = superellipse_norm(u, v, d2);
        self.ring * equatorial + superellipse_norm(equatorial, w, d1)
    }

    fn mass_properties(&self) -> MassProperties {
        self.masses()
    }

    fn surface_area(&self) -> f64 {
        self.area()
    }
}

impl Parametric for Supertoroid {
    fn domain(&self) -> [[f64; 2]; 2] {
        [[-PI, PI], [-PI, PI]]
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

    /// From the dual (B81).
    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let least = a1.min(a2).min(a3);
        let across = signed_power(eta.cos(), 2.0 - e1);
        direction([
            least / a1 * across * signed_power(omega.cos(), 2.0 - e2),
            least / a2 * across * signed_power(omega.sin(), 2.0 - e2),
            least / a3 * signed_power(eta.sin(), 2.0 - e1),
        ])
    }
}
