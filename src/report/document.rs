//! The JSON form of fits; its schema stands in `schema/fit-1.schema.json`.

use serde::Serialize;

use super::model_document::ModelDocument;
use crate::recover::{Covariance, Doubt, Fit, RangeNoise};

/// Name and version of the document of a fit.
pub const FIT_SCHEMA: &str = "superquadric.fit/1";

/// A fit: `{"schema": "superquadric.fit/1", "model": {..}, "fit": {..}}`.
#[derive(Debug, Clone, Serialize)]
pub struct FitDocument {
    schema: &'static str,
    model: ModelDocument,
    fit: EvidenceDocument,
}

#[derive(Debug, Clone, Serialize)]
struct EvidenceDocument {
    distance: &'static str,
    status: &'static str,
    termination: &'static str,
    trusted: bool,
    doubts: Vec<DoubtDocument>,
    rms_radial: f64,
    rms_geometric: f64,
    noise: f64,
    range_noise: Option<RangeNoiseDocument>,
    stray_share: f64,
    inliers: usize,
    uncertainty: UncertaintyDocument,
    points: usize,
    points_skipped: usize,
    evaluations: usize,
    starts: usize,
    seed: u64,
    seconds: f64,
}

#[derive(Debug, Clone, Serialize)]
struct RangeNoiseDocument {
    along: f64,
    across: f64,
}

impl From<RangeNoise> for RangeNoiseDocument {
    fn from(RangeNoise { along, across }: RangeNoise) -> Self {
        Self { along, across }
    }
}

#[derive(Debug, Clone, Serialize)]
struct DoubtDocument {
    kind: &'static str,
    message: String,
    #[serde(flatten)]
    unseen: Option<UnseenDocument>,
}

/// A semi-axis that the points do not determine.
#[derive(Debug, Clone, Serialize)]
struct UnseenDocument {
    parameter: &'static str,
    direction: [f64; 3],
    relative_error: f64,
}

impl From<&Doubt> for DoubtDocument {
    fn from(doubt: &Doubt) -> Self {
        let unseen = match *doubt {
            Doubt::UncertainSize { axis, relative_error, direction } => Some(UnseenDocument {
                parameter: Covariance::NAMES[axis],
                direction,
                relative_error,
            }),
            _ => None,
        };
        Self { kind: doubt.name(), message: doubt.to_string(), unseen }
    }
}

#[derive(Debug, Clone, Serialize)]
struct UncertaintyDocument {
    parameters: [&'static str; 11],
    standard_errors: [f64; 11],
    half_intervals_95: [f64; 11],
    covariance: [[f64; 11]; 11],
}

impl From<&Covariance> for UncertaintyDocument {
    fn from(covariance: &Covariance) -> Self {
        Self {
            parameters: Covariance::NAMES,
            standard_errors: covariance.standard_errors(),
            half_intervals_95: covariance.half_intervals(),
            covariance: covariance.rows(),
        }
    }
}

impl FitDocument {
    /// The document of a fit that took so many seconds.
    pub fn new(fit: &Fit, seconds: f64) -> Self {
        Self {
            schema: FIT_SCHEMA,
            model: ModelDocument::from(&fit.model),
            fit: EvidenceDocument {
                distance: fit.distance.name(),
                status: fit.termination.status(),
                termination: fit.termination.reason,
                trusted: fit.is_trusted(),
                doubts: fit.doubts.iter().map(DoubtDocument::from).collect(),
                rms_radial: fit.rms_radial,
                rms_geometric: fit.rms_geometric,
                noise: fit.noise,
                range_noise: fit.range_noise.map(RangeNoiseDocument::from),
                stray_share: fit.stray_share,
                inliers: fit.inliers(),
                uncertainty: UncertaintyDocument::from(&fit.covariance),
                points: fit.points,
                points_skipped: fit.points_skipped,
                evaluations: fit.evaluations,
                starts: fit.starts,
                seed: fit.seed,
                seconds,
            },
        }
    }

    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}

/// Indented JSON with a final newline.
pub(super) fn to_json(document: &impl Serialize) -> String {
    // Keys are strings and numbers are numbers or null: that always has a JSON form.
    serde_json::to_string_pretty(document).expect("the document is representable in JSON") + "\n"
}
