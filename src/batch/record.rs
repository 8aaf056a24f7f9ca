//! What is kept of one scene.

use serde::{Deserialize, Serialize};

use crate::report::ModelDocument;

/// One scene's row.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Name of the scene.
    pub scene: String,
    /// Level of difficulty.
    pub level: String,
    /// Family of shapes.
    pub family: String,
    /// What came of it.
    #[serde(flatten)]
    pub outcome: Outcome,
}

/// What came of a scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "status", rename_all = "snake_case")]
pub enum Outcome {
    /// A model was found.
    Fitted(Box<Score>),
    /// None was: the scene's files or its cloud do not allow it.
    Failed {
        /// Why.
        error: String,
    },
}

impl Outcome {
    /// The score, if a model was found.
    pub fn score(&self) -> Option<&Score> {
        match self {
            Self::Fitted(score) => Some(score),
            Self::Failed { .. } => None,
        }
    }
}

/// A fit beside the truth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Score {
    /// Intersection over union of the two solids.
    pub iou: f64,
    /// Monte Carlo standard error of that.
    pub iou_standard_error: f64,
    /// Symmetric mean surface distance over the truth's mean semi-axis.
    pub surface_distance: f64,
    /// Greatest relative error of a semi-axis.
    pub size_error: f64,
    /// Angle of the least rotation between the two, in radians, modulo the shape's symmetry.
    pub rotation_error: f64,
    /// Whether the fit was trusted.
    pub trusted: bool,
    /// Residual RMS by the radial distance, in the cloud's unit.
    pub rms_radial: f64,
    /// Residual RMS by the geometric distance, in the cloud's unit.
    pub rms_geometric: f64,
    /// Points fitted.
    pub points: usize,
    /// Rows that were not finite.
    pub points_skipped: usize,
    /// Evaluations of residuals and derivatives.
    pub evaluations: usize,
    /// Models that a descent was started from.
    pub starts: usize,
    /// Wall-clock time of the fit.
    pub seconds: f64,
    /// The recovered model.
    pub model: ModelDocument,
}
