//! The superellipsoid as a solid and a surface like any other.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Matrix3, Vector3};

use super::Superellipsoid;
use crate::error::ModelError;
use crate::shape::form::BarrForm;
use crate::shape::mass::MassProperties;
use crate::shape::parametric::Parametric;
use crate::shape::solid::Solid;
use crate::shape::spherical_product::SphericalProduct;
use crate::shape::superellipse::Superellipse;

impl Superellipsoid {
    /// The dual superquadric, on which the normals lie: semi-axes `1/a`, exponents `2 - e` (B81;
    /// JLS Eq. 2.39). Its own dual is this shape.
    ///
    /// # Errors
    /// If an exponent is not below 2.
    pub fn dual(&self) -> Result<Self, ModelError> {
        Self::new(self.size.map(f64::recip), self.exponents.map(|e| 2.0 - e))
    }

    fn form(&self) -> BarrForm {
        let Self { size, exponents } = *self;
        BarrForm { size, exponents, ring: 0.0, signs: [1.0; 2] }
    }

    fn product(&self) -> SphericalProduct<Superellipse, Superellipse> {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        SphericalProduct {
            meridian: Superellipse::of([1.0, a3], e1),
            equator: Superellipse::of([a1, a2], e2),
        }
    }
}

impl Solid for Superellipsoid {
    fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        Self::inside_outside(self, x)
    }

    fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        self.form().derivatives(x).gradient
    }

    fn inside_outside_hessian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        self.form().derivatives(x).hessian
    }

    fn radial_distance(&self, x: &Vector3<f64>) -> f64 {
        Self::radial_distance(self, x)
    }

    fn support(&self, n: &Vector3<f64>) -> f64 {
        Self::support(self, n)
    }

    fn mass_properties(&self) -> MassProperties {
        Self::mass_properties(self)
    }

    fn surface_area(&self) -> f64 {
        Self::surface_area(self)
    }
}

impl Parametric for Superellipsoid {
    fn domain(&self) -> [[f64; 2]; 2] {
        [[-FRAC_PI_2, FRAC_PI_2], [-PI, PI]]
    }

    fn position(&self, eta: f64, omega: f64) -> Vector3<f64> {
        Self::position(self, eta, omega)
    }

    fn tangents(&self, eta: f64, omega: f64) -> [Vector3<f64>; 2] {
        self.product().tangents(eta, omega)
    }

    fn second_derivatives(&self, eta: f64, omega: f64) -> [Vector3<f64>; 3] {
        self.product().second_derivatives(eta, omega)
    }

    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        Self::normal(self, eta, omega)
    }
}
