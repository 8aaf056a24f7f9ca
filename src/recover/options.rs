//! What a caller may choose about a fit.

use std::num::NonZeroUsize;

use super::constraints::Constraints;
use super::plane::Plane;
use super::sight::Sight;

/// The distance of a point from the surface whose squares are minimised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Distance {
    /// Along the ray from the centre: the radial Euclidean distance (JLS Eq. 2.43).
    Radial,
    /// The radial distance first, then, from its best minima, the first-order geometric distance
    /// `(H - 1)/|grad H|`. On clouds seen from one side the radial distance prefers larger
    /// shapes; this one does not.
    #[default]
    Geometric,
}

/// The numbers in which the rows that are minimised, the residuals of points and their derivatives,
/// are evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// `f32`: twice as many at a time. Points are brought to the model's frame in `f64`, and sums
    /// are taken in it; residuals are rounded by 1e-7 of the cloud's radius.
    Single,
    /// `f64`.
    #[default]
    Double,
}

/// Options of [`fit`](super::fit).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FitOptions {
    /// Seed of the choice of the points that the first, coarse fits look at.
    pub seed: u64,
    /// The distance that is minimised.
    pub distance: Distance,
    /// The numbers in which the rows of the points are evaluated.
    pub precision: Precision,
    /// Threads to use; by default as many as the machine offers. The result's bytes do not
    /// depend on it.
    pub threads: Option<NonZeroUsize>,
    /// Where the sensor stood, and what else it saw. Not used with the radial distance.
    pub sight: Option<Sight>,
    /// The plane that the object stands on. Not used with the radial distance.
    pub support: Option<Plane>,
    /// What is known of the parameters. Where it bounds single semi-axes the model keeps their
    /// names, else it is put in canonical form.
    pub constraints: Constraints,
}

impl Distance {
    /// A name for machines: `radial` or `geometric`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Radial => "radial",
            Self::Geometric => "geometric",
        }
    }
}

impl Precision {
    /// A name for machines: `single` or `double`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Single => "single",
            Self::Double => "double",
        }
    }

    /// Rounding of a residual, in normalised units: that of `f64` is below what any fit looks at.
    pub(super) fn rounding(self) -> f64 {
        match self {
            Self::Single => 0.5 * f64::from(f32::EPSILON),
            Self::Double => 0.0,
        }
    }
}
