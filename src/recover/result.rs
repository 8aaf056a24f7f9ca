//! What a fit has found, and whether to believe it.

use std::fmt;

use levenberg_marquardt::TerminationReason;

use super::covariance::Covariance;
use super::options::Distance;
use crate::model::Model;

/// A recovered model with the evidence for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The model, in the cloud's coordinates and in canonical form.
    pub model: Model,
    /// The distance whose squares were minimised.
    pub distance: Distance,
    /// How the last descent ended.
    pub termination: Termination,
    /// Reasons not to trust the model; none if it can be trusted.
    pub doubts: Vec<Doubt>,
    /// Root mean square of the radial Euclidean distances (JLS Eq. 2.43), in the cloud's unit.
    pub rms_radial: f64,
    /// Root mean square of the first-order geometric distances `(H - 1)/|grad H|`, in the cloud's
    /// unit: nearly the distance from the surface, which the radial one exceeds where the
    /// surface is oblique to its ray.
    pub rms_geometric: f64,
    /// How well the points determine the model's parameters.
    pub covariance: Covariance,
    /// Standard deviation of the surface points' geometric distances, in the cloud's unit.
    pub noise: f64,
    /// The sensor's noise, where the points tell that it is along its rays; the model then minimises
    /// the distances that it makes likely.
    pub range_noise: Option<RangeNoise>,
    /// Estimated share of strays, points that are not of the surface, among all.
    pub stray_share: f64,
    /// Of each point fitted, whether it is more likely of the surface than a stray.
    pub is_inlier: Vec<bool>,
    /// Points fitted, strays included.
    pub points: usize,
    /// Rows of the cloud that were skipped because they were not finite.
    pub points_skipped: usize,
    /// Evaluations of residuals and derivatives, over all stages and point sets.
    pub evaluations: usize,
    /// Models that a descent was started from.
    pub starts: usize,
    /// The seed of the choice of points for the coarse stages.
    pub seed: u64,
}

impl Fit {
    /// Whether there is no reason to doubt the model.
    pub fn is_trusted(&self) -> bool {
        self.doubts.is_empty()
    }

    /// The number of points that are more likely of the surface than strays.
    pub fn inliers(&self) -> usize {
        self.is_inlier.iter().filter(|is_inlier| **is_inlier).count()
    }

    /// Radial residual RMS as a share of the mean semi-axis.
    pub fn relative_rms(&self) -> f64 {
        self.rms_radial / self.model.shape.mean_semi_axis()
    }
}

/// Standard deviations of the noise of points that a sensor saw, in the cloud's unit. Where no viewpoint
/// is told, the direction of the rays is rough, and some of what is along them seems to be across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeNoise {
    /// Along the sensor's rays.
    pub along: f64,
    /// Across them: at least a fifth of that along.
    pub across: f64,
}

/// How the last descent ended: the optimiser's own reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Termination {
    /// Whether it ended at a minimum.
    pub at_minimum: bool,
    /// Why it ended: `cost_settled`, `step_settled`, `residuals_zero`, `gradient_zero`,
    /// `arithmetic_exhausted`, `patience_lost` or `not_a_number`.
    pub reason: &'static str,
}

impl From<TerminationReason> for Termination {
    fn from(reason: TerminationReason) -> Self {
        let (at_minimum, reason) = match reason {
            // The problem has refused another Jacobian, as no step would be worth while.
            TerminationReason::Converged { ftol: true, .. } | TerminationReason::User(_) => {
                (true, "cost_settled")
            }
            TerminationReason::Converged { .. } => (true, "step_settled"),
            TerminationReason::ResidualsZero => (true, "residuals_zero"),
            TerminationReason::Orthogonal => (true, "gradient_zero"),
            // No step that the arithmetic can resolve leads further down.
            TerminationReason::NoImprovementPossible(_) => (true, "arithmetic_exhausted"),
            TerminationReason::LostPatience => (false, "patience_lost"),
            _ => (false, "not_a_number"),
        };
        Self { at_minimum, reason }
    }
}

impl Termination {
    /// One word: `converged` at a minimum, else `stopped`.
    pub fn status(&self) -> &'static str {
        if self.at_minimum { "converged" } else { "stopped" }
    }
}

/// A reason not to trust a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Doubt {
    /// The optimiser ended before it reached a minimum.
    NotConverged(Termination),
    /// The points do not lie on the model, or are too noisy to tell its thickness.
    PoorFit {
        /// RMS of the first-order geometric distances as a share of the least semi-axis.
        relative_rms: f64,
    },
    /// The points lie in one plane.
    Flat,
    /// Many points are not of the model, and no strays either: they have neighbours like its own.
    OtherSurfaces {
        /// Share of these points.
        share: f64,
    },
    /// The points do not determine a semi-axis.
    UncertainSize {
        /// Index of the semi-axis.
        axis: usize,
        /// Its relative standard error; near 1, it is not seen at all.
        relative_error: f64,
        /// Where it points: a unit vector in the cloud's frame.
        direction: [f64; 3],
    },
}

impl Doubt {
    /// A name for machines.
    pub fn name(&self) -> &'static str {
        match self {
            Self::NotConverged(_) => "not_converged",
            Self::PoorFit { .. } => "poor_fit",
            Self::Flat => "flat",
            Self::OtherSurfaces { .. } => "other_surfaces",
            Self::UncertainSize { .. } => "uncertain_size",
        }
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotConverged(termination) => {
                write!(f, "the descent ended before a minimum ({})", termination.reason)
            }
            Self::PoorFit { relative_rms } => write!(
                f,
                "the points do not lie on one superellipsoid (their distances from it are {:.0} % of \
                 its least semi-axis)",
                100.0 * relative_rms
            ),
            Self::Flat => write!(f, "the points lie in one plane"),
            Self::OtherSurfaces { share } => {
                write!(f, "{:.0} % of the points are of another surface", 100.0 * share)
            }
            Self::UncertainSize { axis, relative_error, direction: [x, y, z] } => write!(
                f,
                "the points do not determine semi-axis a{}, along ({x:.2}, {y:.2}, {z:.2}) (standard \
                 error {:.0} %)",
                axis + 1,
                100.0 * relative_error
            ),
        }
    }
}
