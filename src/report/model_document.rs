//! The JSON form of models; its schema stands in `schema/fit-1.schema.json`.

use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::deformation_document::DeformationDocument;
use super::document::{FIT_SCHEMA, to_json};
use super::shape_document::ShapeDocument;
use crate::deform::DeformError;
use crate::error::ModelError;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Shape;

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
    /// Not JSON, or without the keys or types of a plane curve.
    #[error("expected a curve, {{\"curve\": .., ..}}: {0}")]
    Curve(serde_json::Error),
    /// A fit of a schema that this version does not know.
    #[error("expected schema \"superquadric.fit/1\", found {0}")]
    Schema(String),
    /// Another family where only superellipsoids will do.
    #[error("expected shape.family \"superellipsoid\", found \"{0}\"")]
    Family(&'static str),
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
    /// Not TOML.
    #[error("expected a scene in TOML: {0}")]
    Toml(String),
    /// A scene with a key that is missing, unknown, or of the wrong type.
    #[error("expected a scene: {0}")]
    Scene(String),
    /// A camera of a scene that is none.
    #[error("{0}")]
    Camera(String),
    /// A key that means nothing.
    #[error("unknown key `{0}`")]
    UnknownKey(String),
    /// A value outside its domain.
    #[error("expected {expected}, found {found}")]
    Value {
        /// What would have done.
        expected: String,
        /// What is there.
        found: String,
    },
    /// An error in a part of a document.
    #[error("{place}: {source}")]
    At {
        /// The part, such as `union[2]`.
        place: String,
        /// What is wrong there.
        source: Box<DocumentError>,
    },
    /// A profile that no document can describe.
    #[error("a profile that is neither line, polyline nor spline has no JSON form")]
    Function,
    /// Euler angles and rotation matrix that contradict each other.
    #[error("pose.euler_zyz and pose.rotation differ by {0:e}")]
    Contradiction(f64),
}

impl DocumentError {
    /// The error in a part of a document.
    pub(super) fn at(self, place: impl Into<String>) -> Self {
        Self::At { place: place.into(), source: Box::new(self) }
    }
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

impl<S: Copy + Into<Shape>> From<&Model<S>> for ModelDocument {
    fn from(Model { shape, pose }: &Model<S>) -> Self {
        Self { shape: (*shape).into().into(), deformations: Vec::new(), pose: pose.into() }
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

impl ModelDocument {
    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }

    /// The model before its deformations.
    pub(super) fn undeformed(&self) -> Result<Model<Shape>, DocumentError> {
        Ok(Model { shape: (&self.shape).try_into()?, pose: self.pose.to_pose()? })
    }
}

/// The rows of a matrix.
pub(super) fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    matrix.transpose().into()
}

impl TryFrom<&ModelDocument> for Model<Shape> {
    type Error = DocumentError;

    fn try_from(document: &ModelDocument) -> Result<Self, DocumentError> {
        if document.deformations.is_empty() {
            return document.undeformed();
        }
        Err(DocumentError::Deformed)
    }
}

impl TryFrom<&ModelDocument> for Model {
    type Error = DocumentError;

    fn try_from(document: &ModelDocument) -> Result<Self, DocumentError> {
        let Model { shape, pose } = Model::<Shape>::try_from(document)?;
        match shape {
            Shape::Superellipsoid(shape) => Ok(Self { shape, pose }),
            other => Err(DocumentError::Family(other.family())),
        }
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

/// The superellipsoid in a JSON text: a bare model, or that of a fit.
///
/// # Errors
/// If the text is not JSON, lacks a key, has parameters outside their domain, is of another
/// family, or has deformations.
pub fn model_from_json(text: &str) -> Result<Model, DocumentError> {
    (&document_from_json(text)?).try_into()
}

/// The model of any family in a JSON text: a bare one, or that of a fit.
///
/// # Errors
/// If the text is not JSON, lacks a key, or has parameters outside their domain.
pub fn any_model_from_json(text: &str) -> Result<Model<Shape>, DocumentError> {
    (&document_from_json(text)?).try_into()
}

/// The document of a model in a JSON text: a bare one, or that of a fit.
pub(super) fn document_from_json(text: &str) -> Result<ModelDocument, DocumentError> {
    document_of(&serde_json::from_str(text)?)
}

/// The document of a model in JSON: a bare one, or that of a fit.
pub(super) fn document_of(value: &serde_json::Value) -> Result<ModelDocument, DocumentError> {
    if let Some(schema) = value.get("schema").filter(|schema| *schema != FIT_SCHEMA) {
        return Err(DocumentError::Schema(schema.to_string()));
    }
    let model = value.get("model").unwrap_or(value).clone();
    serde_json::from_value(model).map_err(DocumentError::Model)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Superellipsoid;

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
            (broken(&|v| v["shape"]["family"] = "cone".into()), "`cone`"),
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
