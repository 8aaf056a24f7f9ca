//! Whether a cloud can be fitted, and whether to believe what was fitted to it.

use super::covariance::Covariance;
use super::descent::Descent;
use super::error::FitError;
use super::normalization::Moments;
use super::result::Doubt;
use crate::model::Model;

/// A spread of fewer steps of the coordinates' rounding than this is no shape.
const LEAST_RESOLVED: f64 = 16.0;

/// Deviation across a line or plane, relative to that along it, that counts as none. A needle
/// or plate of 1:1000 has a hundred times as much.
const FLATNESS: f64 = 1e-5;

/// Greatest RMS distance from the surface, relative to the least semi-axis, of points that are a
/// superellipsoid's: 5 % of noise on an aspect of 1:4 reaches 0.15.
const GREATEST_RELATIVE_RMS: f64 = 0.2;

/// Greatest relative standard error of a semi-axis that counts as known.
const GREATEST_SIZE_ERROR: f64 = 0.1;

/// Greatest share of points that are not of the model although neighbours do not hold them for
/// strays: a ball before its stand, which is found right, has 0.17, a bottle with its neck 0.23.
const GREATEST_OTHER_SHARE: f64 = 0.2;

/// Refuses clouds without an extent in at least two dimensions.
pub(crate) fn require_extent(moments: &Moments) -> Result<(), FitError> {
    let spread = moments.normalization.radius;
    if !spread.is_normal() || !spread.recip().is_normal() {
        return Err(FitError::OutOfRange { spread });
    }
    if moments.deviations[0] == 0.0 || LEAST_RESOLVED * moments.resolution >= 1.0 {
        return Err(FitError::Coincident { magnitude: moments.greatest_magnitude });
    }
    if moments.deviations[1] <= flatness(moments) {
        return Err(FitError::Collinear);
    }
    Ok(())
}

/// The deviation that counts as none in a cloud.
fn flatness(moments: &Moments) -> f64 {
    FLATNESS * moments.deviations[0] + LEAST_RESOLVED * moments.resolution
}

/// The reasons not to trust where a fit has ended: `descent` from points of these moments, at
/// `model`, in the cloud's coordinates, whose parameters have that covariance; `other_share` of the
/// points are neither of the model nor strays by their neighbours.
pub(crate) fn doubts(
    descent: &Descent,
    moments: &Moments,
    model: &Model,
    covariance: &Covariance,
    other_share: f64,
) -> Vec<Doubt> {
    let mut doubts = Vec::new();
    if !descent.termination.at_minimum {
        doubts.push(Doubt::NotConverged(descent.termination));
    }
    let least_semi_axis = descent.model.shape.size().into_iter().fold(f64::INFINITY, f64::min);
    let relative_rms = descent.geometric_mean_square.sqrt() / least_semi_axis;
    if relative_rms > GREATEST_RELATIVE_RMS {
        doubts.push(Doubt::PoorFit { relative_rms });
    }
    if moments.deviations[2] <= flatness(moments) {
        doubts.push(Doubt::Flat);
    }
    if other_share > GREATEST_OTHER_SHARE {
        doubts.push(Doubt::OtherSurfaces { share: other_share });
    }
    let errors = covariance.standard_errors();
    for (axis, size) in model.shape.size().into_iter().enumerate() {
        let relative_error = errors[axis] / size;
        if relative_error > GREATEST_SIZE_ERROR {
            let direction = model.pose.rotation().matrix().column(axis).into_owned().into();
            doubts.push(Doubt::UncertainSize { axis, relative_error, direction });
        }
    }
    doubts
}
