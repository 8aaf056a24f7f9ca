//! Shapes in their own frame, a file or folder a family.

pub(crate) mod arc;
mod branches;
mod clipped_curve;
mod curvature;
mod curve;
mod family;
mod form;
mod gauge;
mod lame;
mod level_set;
mod mass;
mod one_sheet;
mod parametric;
mod patch;
mod polyline;
mod solid;
mod spherical_product;
mod superellipse;
mod superellipsoid;
mod superhyperbola;
mod supertoroid;
mod three_exponent;
mod two_sheets;

pub(crate) use crate::math::superellipse_norm;
pub(crate) use arc::{greatest_arc_parameter, quarter_point};
pub use clipped_curve::{ClippedCurve, PlaneCurve};
pub use curvature::{Curvatures, FundamentalForms};
pub use curve::{Curve, CurvePoint};
pub use family::Shape;
pub(crate) use gauge::{GaugeTerms, LOG_FLOOR};
pub use lame::{LameArc, LameCurve};
pub use level_set::LevelSet;
pub use mass::MassProperties;
pub use one_sheet::SuperhyperboloidOneSheet;
pub use parametric::Parametric;
pub use patch::{Patch, Patched, SurfaceElement};
pub use polyline::Polyline;
pub use solid::Solid;
pub use spherical_product::SphericalProduct;
pub use superellipse::Superellipse;
pub use superellipsoid::Superellipsoid;
pub(crate) use superellipsoid::area_element;
pub use superhyperbola::Superhyperbola;
pub use supertoroid::Supertoroid;
pub use three_exponent::ThreeExponent;
pub(crate) use three_exponent::log_shift;
pub use two_sheets::SuperhyperboloidTwoSheets;

#[cfg(test)]
mod laws;

use crate::error::ModelError;

/// Whether a parameter is a positive, finite number.
fn is_positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// Makes sure that all semi-axes are positive, finite numbers.
fn validated_size(size: &[f64]) -> Result<(), ModelError> {
    match size.iter().position(|&a| !is_positive(a)) {
        Some(axis) => Err(ModelError::Size { axis, value: size[axis] }),
        None => Ok(()),
    }
}

/// Makes sure that all exponents are positive, finite numbers.
fn validated_exponents(exponents: &[f64]) -> Result<(), ModelError> {
    match exponents.iter().position(|&e| !is_positive(e)) {
        Some(index) => Err(ModelError::Exponent { index, value: exponents[index] }),
        None => Ok(()),
    }
}
