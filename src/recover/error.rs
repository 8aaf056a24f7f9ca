//! Why a cloud cannot be fitted at all.

use thiserror::Error;

use crate::machine::InstructionSetError;

/// A cloud that does not determine a solid.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// Fewer finite points than the model has parameters.
    #[error("{found} finite points are too few: the eleven parameters need at least {needed}")]
    TooFewPoints {
        /// Finite points in the cloud.
        found: usize,
        /// The least number that will do.
        needed: usize,
    },
    /// All points are one, to within the rounding of their coordinates.
    #[error(
        "all points coincide, to within the rounding of their coordinates (up to {magnitude:e})"
    )]
    Coincident {
        /// Greatest coordinate, by magnitude.
        magnitude: f64,
    },
    /// All points lie on one line.
    #[error("all points lie on one line: no solid can be told from them")]
    Collinear,
    /// Coordinates at the end of the range of numbers.
    #[error(
        "the points' spread, {spread:e}, is at the end of the range of numbers: change the unit"
    )]
    OutOfRange {
        /// RMS distance from the centroid, as far as it could be computed.
        spread: f64,
    },
    /// Constraints that no model can keep.
    #[error("the constraints cannot be kept: {0}")]
    Contradiction(String),
    /// No descent stayed within the bounds of the sizes.
    #[error("no superellipsoid of finite size fits the points")]
    Unbounded,
    /// The threads asked for could not be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// The number asked for.
        threads: usize,
        /// What the system says.
        reason: String,
    },
    /// The instruction set asked for is not to be had.
    #[error(transparent)]
    InstructionSet(#[from] InstructionSetError),
    /// The caller has asked to stop.
    #[error("the fit was interrupted")]
    Interrupted,
}
