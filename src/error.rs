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
