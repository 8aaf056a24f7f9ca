//! The JSON form of models and fits; its schema stands in `schema/fit-1.schema.json`.

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::deformation_document::DeformationDocument;
use crate::deform::DeformError;
use crate::error::ModelError;
use crate::model::Model;
use crate::pose::Pose;
use crate::recover::{Covariance, Doubt, Fit};
use crate::shape::Superellipsoid;

/// Name and version of the document of a fit.
pub const FIT_SCHEMA: &str = "superquadric.fit/1";

/// Greatest difference between a rotation matrix and the Euler angles beside it: both may have
/// been written with eight digits.
const AGREEMENT: f64 = 1e-6;

/// Text that is not the document of a model.
#[derive(Debug, Error)]
pub enum DocumentError {
    /// Not JSON, or without the keys or types of a model.
    #[error("expected a model or a fit in JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// A key of the model is missing or has the wrong type.
    #[error("expected a model, {{\"shape\": {{..}}, \"pose\": {{..}}}}: {0}")]
    Model(serde_json::Error),
    /// A fit of a schema that this version does not know.
    #[error("expected schema \"superquadric.fit/1\", found {0}")]
    Schema(String),
    /// A family that this version does not know.
    #[error("expected shape.family \"superellipsoid\", found \"{0}\"")]
    Family(String),
    /// Parameters outside their domain.
    #[error(transparent)]
    Parameters(#[from] ModelError),
    /// Deformations outside their domain, or that fold the shape.
    #[error(transparent)]
    Deformation(#[from] DeformError),
    /// A deformation with two frames.
    #[error("a deformation has a frame or an axis, not both")]
    TwoFrames,
    /// A deformed model where a plain one is needed.
    #[error("expected a model without deformations")]
    Deformed,
    /// A union, intersection or difference of nothing.
    #[error("expected a list of at least one solid after union, intersection or difference")]
    Parts,
    /// A profile that no document can describe.
    #[error("a profile that is neither line, polyline nor spline has no JSON form")]
    Function,
    /// Euler angles and rotation matrix that contradict each other.
    #[error("pose.euler_zyz and pose.rotation differ by {0:e}")]
    Contradiction(f64),
}

/// A model: `{"shape": {..}, "deformations": [..], "pose": {..}}`, the latter two if need be.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ModelDocument {
    shape: ShapeDocument,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) deformations: Vec<DeformationDocument>,
    #[serde(default)]
    pose: PoseDocument,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct ShapeDocument {
    family: String,
    size: [f64; 3],
    exponents: [f64; 2],
}

/// Either form of the rotation will do; without both there is none.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct PoseDocument {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    euler_zyz: Option<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rotation: Option<[[f64; 3]; 3]>,
    #[serde(default)]
    translation: [f64; 3],
}

impl From<&Model> for ModelDocument {
    fn from(model: &Model) -> Self {
        Self {
            shape: ShapeDocument {
                family: FAMILY.to_owned(),
                size: model.shape.size(),
                exponents: model.shape.exponents(),
            },
            deformations: Vec::new(),
            pose: (&model.pose).into(),
        }
    }
}

impl ModelDocument {
    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}

impl From<&Pose> for PoseDocument {
    fn from(pose: &Pose) -> Self {
        Self {
            euler_zyz: Some(pose.euler_zyz()),
            rotation: Some(rows(pose.rotation().matrix())),
            translation: (*pose.translation()).into(),
        }
    }
}

pub(super) fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    matrix.transpose().into()
}

const FAMILY: &str = "superellipsoid";

impl TryFrom<&ModelDocument> for Model {
    type Error = DocumentError;

    fn try_from(document: &ModelDocument) -> Result<Self, DocumentError> {
        if document.deformations.is_empty() {
            return document.undeformed();
        }
        Err(DocumentError::Deformed)
    }
}

impl ModelDocument {
    /// The model before its deformations.
    pub(super) fn undeformed(&self) -> Result<Model, DocumentError> {
        if self.shape.family != FAMILY {
            return Err(DocumentError::Family(self.shape.family.clone()));
        }
        let shape = Superellipsoid::new(self.shape.size, self.shape.exponents)?;
        Ok(Model { shape, pose: self.pose.to_pose()? })
    }
}

impl PoseDocument {
    pub fn to_pose(&self) -> Result<Pose, DocumentError> {
        let translation = Vector3::from(self.translation);
        let of_angles = self.euler_zyz.map(|angles| Pose::from_euler_zyz(angles, translation));
        let Some(rows) = self.rotation else {
            return Ok(of_angles.unwrap_or(Pose::new(Default::default(), translation)));
        };
        let matrix = Matrix3::from_fn(|i, j| rows[i][j]);
        let pose = Pose::from_matrix(matrix, translation)?;
        if let Some(of_angles) = of_angles {
            let difference = (of_angles.rotation().matrix() - pose.rotation().matrix()).amax();
            // Written so that NaN is refused too.
            let agree = difference <= AGREEMENT;
            if !agree {
                return Err(DocumentError::Contradiction(difference));
            }
        }
        Ok(pose)
    }
}

/// The model in a JSON text: a bare one, or that of a fit.
///
/// # Errors
/// If the text is not JSON, lacks a key, has parameters outside their domain, or deformations.
pub fn model_from_json(text: &str) -> Result<Model, DocumentError> {
    Model::try_from(&model_document(text)?)
}

/// The document of a model in a JSON text: a bare one, or that of a fit.
pub(super) fn model_document(text: &str) -> Result<ModelDocument, DocumentError> {
    model_document_of(&serde_json::from_str(text)?)
}

/// The document of a model in JSON: a bare one, or that of a fit.
pub(super) fn model_document_of(value: &serde_json::Value) -> Result<ModelDocument, DocumentError> {
    if let Some(schema) = value.get("schema").filter(|schema| *schema != FIT_SCHEMA) {
        return Err(DocumentError::Schema(schema.to_string()));
    }
    let model = value.get("model").unwrap_or(value).clone();
    serde_json::from_value(model).map_err(DocumentError::Model)
}

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

/// What is known of a model, besides its parameters.
#[derive(Debug, Clone, Serialize)]
pub struct InfoDocument {
    #[serde(flatten)]
    model: ModelDocument,
    extents: [f64; 3],
    volume: f64,
    surface_area: f64,
    /// About the centroid, in the model's axes, of unit density.
    inertia: [[f64; 3]; 3],
    bounding_box: [[f64; 3]; 2],
}

impl InfoDocument {
    /// The document of a model.
    pub fn new(model: &Model) -> Self {
        Self {
            model: model.into(),
            extents: model.shape.size().map(|a| 2.0 * a),
            volume: model.shape.volume(),
            surface_area: model.shape.surface_area(),
            inertia: rows(&model.shape.mass_properties().inertia()),
            bounding_box: model.bounding_box().map(Into::into),
        }
    }

    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}

pub(super) fn to_json(document: &impl Serialize) -> String {
    // Keys are strings and numbers are numbers or null: that always has a JSON form.
    serde_json::to_string_pretty(document).expect("the document is representable in JSON") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model() -> Model {
        Model {
            shape: Superellipsoid::new([1.0, 2.0, 3.0], [0.1, 1.9]).unwrap(),
            pose: Pose::from_euler_zyz([0.1, 0.2, 0.3], Vector3::new(1e5, -2.0, 1e-7)),
        }
    }

    fn json(model: &Model) -> serde_json::Value {
        serde_json::to_value(ModelDocument::from(model)).unwrap()
    }

    #[test]
    fn a_model_comes_back_from_its_document() {
        let again = model_from_json(&json(&model()).to_string()).unwrap();
        assert_eq!(again.shape, model().shape);
        assert_eq!(again.pose.translation(), model().pose.translation());
        let difference = again.pose.rotation().matrix() - model().pose.rotation().matrix();
        assert!(difference.amax() < 1e-15);
    }

    #[test]
    fn either_form_of_the_rotation_will_do_and_none_is_the_identity() {
        for key in ["euler_zyz", "rotation"] {
            let mut value = json(&model());
            value["pose"].as_object_mut().unwrap().remove(key);
            let again = model_from_json(&value.to_string()).unwrap();
            let difference = again.pose.rotation().matrix() - model().pose.rotation().matrix();
            assert!(difference.amax() < 1e-15);
        }
        let mut value = json(&model());
        value.as_object_mut().unwrap().remove("pose");
        assert_eq!(model_from_json(&value.to_string()).unwrap().pose, Pose::identity());
    }

    #[test]
    fn what_is_wrong_is_named() {
        let broken = |change: &dyn Fn(&mut serde_json::Value)| {
            let mut value = json(&model());
            change(&mut value);
            model_from_json(&value.to_string()).unwrap_err().to_string()
        };
        let cases: [(String, &str); 7] = [
            (model_from_json("{\n \"shape\": ").unwrap_err().to_string(), "line 2"),
            (broken(&|v| v["shape"]["family"] = "cone".into()), "\"cone\""),
            (broken(&|v| v["shape"]["size"][1] = (-2.0).into()), "size[1]"),
            (broken(&|v| v["shape"]["exponents"] = 1.0.into()), "expected an array"),
            (broken(&|v| v["pose"]["rotation"][0][0] = 2.0.into()), "orthonormal"),
            (broken(&|v| v["pose"]["euler_zyz"][0] = 2.0.into()), "differ"),
            (broken(&|v| v["schema"] = "superquadric.fit/9".into()), "superquadric.fit/9"),
        ];
        for (message, expected) in cases {
            assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        }
    }
}
