//! Why a model cannot be what it was asked to be.

use thiserror::Error;

/// A shape or pose whose parameters are outside their domain.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ModelError {
    /// A semi-axis that is not a positive, finite number.
    #[error("size[{axis}] must be a positive number, found {value}")]
    Size {
        /// Index of the semi-axis.
        axis: usize,
        /// The value found.
        value: f64,
    },
    /// An exponent that is not a positive, finite number.
    #[error("exponents[{index}] must be a positive number, found {value}")]
    Exponent {
        /// Index of the exponent.
        index: usize,
        /// The value found.
        value: f64,
    },
    /// A ring so small that the torus would pass through itself.
    #[error("ring must be a number of at least 1, found {value}")]
    Ring {
        /// The value found.
        value: f64,
    },
    /// A clip that leaves nothing of the solid, or is not finite.
    #[error("clip must be a number above {least}, found {value}")]
    Clip {
        /// The value that it must exceed.
        least: f64,
        /// The value found.
        value: f64,
    },
    /// A numerator or denominator that makes no exponent.
    #[error("the exponent must be a fraction other than 0, found {numerator}/{denominator}")]
    Fraction {
        /// The numerator found.
        numerator: i32,
        /// The denominator found.
        denominator: u32,
    },
    /// Too few or too many points of a polyline.
    #[error("a polyline has from {least} to {most} points, found {found}")]
    PointCount {
        /// The least number.
        least: usize,
        /// The greatest number.
        most: usize,
        /// The number found.
        found: usize,
    },
    /// A point of a polyline that is not as it must be.
    #[error("points[{index}] must {must}")]
    Point {
        /// Index of the point.
        index: usize,
        /// What it must.
        must: &'static str,
    },
    /// A matrix that is not a proper rotation.
    #[error("the rotation must be orthonormal and right-handed (R'R departs from 1 by {defect:e})")]
    NotARotation {
        /// Largest entry of `R'R - 1`.
        defect: f64,
    },
    /// A translation or angle that is not finite.
    #[error("{what} must be finite numbers")]
    NotFinite {
        /// What is not finite.
        what: &'static str,
    },
}
