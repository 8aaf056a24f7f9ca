//! A shape of any family.

use nalgebra::{Matrix3, Vector3};

use super::mass::MassProperties;
use super::one_sheet::SuperhyperboloidOneSheet;
use super::parametric::Parametric;
use super::solid::Solid;
use super::superellipsoid::Superellipsoid;
use super::supertoroid::Supertoroid;
use super::three_exponent::ThreeExponent;
use super::two_sheets::SuperhyperboloidTwoSheets;
use crate::error::ModelError;

/// A shape of any family, in its own frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// Between box, cylinder, ellipsoid and octahedron.
    Superellipsoid(Superellipsoid),
    /// A tower with a waist.
    SuperhyperboloidOneSheet(SuperhyperboloidOneSheet),
    /// Two bowls that face away from each other.
    SuperhyperboloidTwoSheets(SuperhyperboloidTwoSheets),
    /// A tube around a ring.
    Supertoroid(Supertoroid),
    /// An exponent an axis.
    ThreeExponent(ThreeExponent),
}

/// An expression of whatever family a shape is of.
macro_rules! of_any_family {
    ($shape:expr, $family:ident => $value:expr) => {
        match $shape {
            Shape::Superellipsoid($family) => $value,
            Shape::SuperhyperboloidOneSheet($family) => $value,
            Shape::SuperhyperboloidTwoSheets($family) => $value,
            Shape::Supertoroid($family) => $value,
            Shape::ThreeExponent($family) => $value,
        }
    };
}

impl Shape {
    /// The family's name in documents.
    pub fn family(&self) -> &'static str {
        match self {
            Self::Superellipsoid(_) => "superellipsoid",
            Self::SuperhyperboloidOneSheet(_) => "superhyperboloid_one_sheet",
            Self::SuperhyperboloidTwoSheets(_) => "superhyperboloid_two_sheets",
            Self::Supertoroid(_) => "supertoroid",
            Self::ThreeExponent(_) => "three_exponent",
        }
    }

    /// The dual: the shape on which the normals lie (B81; JLS Eq. 2.39). Its own dual is this
    /// shape; but that of a supertoroid's is the tube alone, and three exponents that differ leave
    /// other semi-axes.
    ///
    /// # Errors
    /// If an exponent is one that has no dual.
    pub fn dual(&self) -> Result<Self, ModelError> {
        of_any_family!(self, shape => Ok(shape.dual()?.into()))
    }
}

/// A shape of the enum from a shape of a family.
macro_rules! shape_from {
    ($($family:ident),*) => {
        $(impl From<$family> for Shape {
            fn from(shape: $family) -> Self {
                Self::$family(shape)
            }
        })*
    };
}

shape_from!(
    Superellipsoid,
    SuperhyperboloidOneSheet,
    SuperhyperboloidTwoSheets,
    Supertoroid,
    ThreeExponent
);

impl Solid for Shape {
    fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        of_any_family!(self, shape => Solid::inside_outside(shape, x))
    }

    fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        of_any_family!(self, shape => shape.inside_outside_gradient(x))
    }

    fn inside_outside_hessian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        of_any_family!(self, shape => shape.inside_outside_hessian(x))
    }

    fn contains(&self, x: &Vector3<f64>) -> bool {
        of_any_family!(self, shape => shape.contains(x))
    }

    fn radial_distance(&self, x: &Vector3<f64>) -> f64 {
        of_any_family!(self, shape => Solid::radial_distance(shape, x))
    }

    fn support(&self, n: &Vector3<f64>) -> f64 {
        of_any_family!(self, shape => Solid::support(shape, n))
    }

    fn bounding_box(&self) -> [Vector3<f64>; 2] {
        of_any_family!(self, shape => shape.bounding_box())
    }

    fn mass_properties(&self) -> MassProperties {
        of_any_family!(self, shape => Solid::mass_properties(shape))
    }

    fn surface_area(&self) -> f64 {
        of_any_family!(self, shape => Solid::surface_area(shape))
    }
}

impl Parametric for Shape {
    fn domain(&self) -> [[f64; 2]; 2] {
        of_any_family!(self, shape => shape.domain())
    }

    fn position(&self, eta: f64, omega: f64) -> Vector3<f64> {
        of_any_family!(self, shape => Parametric::position(shape, eta, omega))
    }

    fn tangents(&self, eta: f64, omega: f64) -> [Vector3<f64>; 2] {
        of_any_family!(self, shape => shape.tangents(eta, omega))
    }

    fn second_derivatives(&self, eta: f64, omega: f64) -> [Vector3<f64>; 3] {
        of_any_family!(self, shape => shape.second_derivatives(eta, omega))
    }

    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        of_any_family!(self, shape => Parametric::normal(shape, eta, omega))
    }
}
