//! Why a deformation cannot be what it was asked to be, or cannot take a point.

use thiserror::Error;

/// A deformation outside its domain.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DeformError {
    /// A parameter outside its domain.
    #[error("{what} must be {expected}, found {found}")]
    Parameter {
        /// Which parameter.
        what: &'static str,
        /// What was expected.
        expected: &'static str,
        /// The value found.
        found: f64,
    },
    /// A profile of no knots, or of knots that do not ascend.
    #[error(
        "the knots of a profile must be at least one pair of finite numbers, in ascending order"
    )]
    Knots,
    /// A taper shrinks the object to nothing, or turns it inside out.
    #[error("the taper folds at z = {z}: its profile must be positive there, found {radius}")]
    TaperFolds {
        /// Height along the taper's axis.
        z: f64,
        /// Least value of the profile there.
        radius: f64,
    },
    /// A bend crushes the object: its axis runs through it.
    #[error("the bend folds at z = {z}: 1 - k z must be positive there, found {stretch}")]
    BendFolds {
        /// Distance from the bend's centre line towards its axis.
        z: f64,
        /// Least value of `1 - k z` there.
        stretch: f64,
    },
    /// The rigid ends of a bend meet: two points of the object come to lie in one.
    #[error("the ends of the bend meet at y = {y}: it turns them onto each other")]
    BendMeets {
        /// Position along the bend's centre line.
        y: f64,
    },
}

/// Makes sure that a parameter is a finite number.
pub(super) fn finite(what: &'static str, found: f64) -> Result<(), DeformError> {
    if found.is_finite() {
        return Ok(());
    }
    Err(DeformError::Parameter { what, expected: "a finite number", found })
}
