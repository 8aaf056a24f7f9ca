//! Deformed models as documents, and what is known of them.

use serde::Serialize;

use super::deformation_document::DeformationDocument;
use super::document::to_json;
use super::model_document::{DocumentError, ModelDocument, document_from_json, rows};
use crate::deform::{Chain, Deformed, MassEstimate};
use crate::model::Model;
use crate::shape::Shape;
use crate::solid::Primitive;

/// Relative accuracy of the masses that are told.
const MASS_TOLERANCE: f64 = 1e-6;

impl TryFrom<&ModelDocument> for Primitive<Shape> {
    type Error = DocumentError;

    fn try_from(document: &ModelDocument) -> Result<Self, DocumentError> {
        let stages = document.deformations.iter().map(DeformationDocument::to_deformation);
        let chain = Chain::new(stages.collect::<Result<Vec<_>, _>>()?);
        let Model { shape, pose } = document.undeformed()?;
        Ok(Self { deformed: Deformed::new(shape, chain)?, pose })
    }
}

impl TryFrom<&Primitive<Shape>> for ModelDocument {
    type Error = DocumentError;

    /// Fails where a profile is a function that has no document.
    fn try_from(primitive: &Primitive<Shape>) -> Result<Self, DocumentError> {
        let Primitive { deformed, pose } = primitive;
        let stages = deformed.chain().stages().iter().map(DeformationDocument::new);
        let model = Model { shape: *deformed.shape(), pose: *pose };
        let mut document = Self::from(&model);
        document.deformations = stages.collect::<Result<_, _>>()?;
        Ok(document)
    }
}

/// The model in a JSON text, with its deformations: a bare one, or that of a fit.
///
/// # Errors
/// If the text is not JSON, lacks a key, has parameters outside their domain, or deformations
/// that fold the shape.
pub fn primitive_from_json(text: &str) -> Result<Primitive<Shape>, DocumentError> {
    Primitive::try_from(&document_from_json(text)?)
}

/// The masses of a deformed model, in its own frame.
pub(super) fn masses(primitive: &Primitive<Shape>) -> MassEstimate {
    primitive.deformed.mass_estimate(MASS_TOLERANCE)
}

/// What is known of a deformed model, besides its parameters.
#[derive(Debug, Clone, Serialize)]
pub struct PrimitiveInfoDocument {
    #[serde(flatten)]
    model: ModelDocument,
    volume: f64,
    surface_area: f64,
    /// In the world.
    centroid: [f64; 3],
    /// About the centroid, in the model's axes, of unit density.
    inertia: [[f64; 3]; 3],
    /// Bound on the relative error of the masses.
    mass_error: f64,
    /// In the world; holds the solid, and is hardly larger.
    bounding_box: [[f64; 3]; 2],
}

impl PrimitiveInfoDocument {
    /// The document of a deformed model.
    ///
    /// # Errors
    /// If a profile is a function that has no document.
    pub fn new(primitive: &Primitive<Shape>) -> Result<Self, DocumentError> {
        let estimate = masses(primitive);
        let centroid = primitive.pose.world_from_model(&estimate.properties.centroid());
        Ok(Self {
            model: primitive.try_into()?,
            volume: estimate.properties.volume(),
            surface_area: estimate.surface_area,
            centroid: centroid.into(),
            inertia: rows(&estimate.properties.inertia()),
            mass_error: estimate.error,
            bounding_box: primitive.bounding_box().map(Into::into),
        })
    }

    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deform::{DeformError, Deformation, Profile, Twist};
    use std::sync::Arc;

    const BENT: &str = r#"{
        "shape": {"family": "superellipsoid", "size": [0.5, 2, 0.3], "exponents": [0.3, 0.6]},
        "deformations": [
            {"kind": "scale", "factors": [1, 1, 2]},
            {"kind": "taper", "profile": {"form": "polyline", "knots": [[-1, 1], [1, 0.5]]},
             "axis": {"direction": [0, 1, 0]}},
            {"kind": "twist", "profile": {"form": "line", "at_zero": 0, "slope": 0.5},
             "axis": {"origin": [1, 0, 0], "direction": [0, 1, 0]}},
            {"kind": "twist", "profile": {"form": "spline", "knots": [[-1, 0], [1, 0.5]]}},
            {"kind": "bend", "rate": 0.25, "center": 0, "range": [-1, 1],
             "frame": {"euler_zyz": [0.1, 0.2, 0.3], "translation": [0, 0.1, 0]}}
        ],
        "pose": {"translation": [1, 2, 3]}
    }"#;

    #[test]
    fn a_deformed_model_comes_back_from_its_document() {
        let primitive = primitive_from_json(BENT).unwrap();
        assert_eq!(primitive.deformed.chain().stages().len(), 5);
        let document = ModelDocument::try_from(&primitive).unwrap();
        let again = primitive_from_json(&serde_json::to_string(&document).unwrap()).unwrap();
        let x = primitive.pose.world_from_model(&primitive.deformed.position(0.3, 0.4));
        assert!((again.inside_outside(&x) - 1.0).abs() < 1e-12);
        let rotation =
            |p: &Primitive<Shape>| *p.deformed.chain().stages()[4].frame().rotation().matrix();
        assert!((rotation(&again) - rotation(&primitive)).amax() < 1e-15);
        assert_eq!(again.deformed.chain().stages()[..2], primitive.deformed.chain().stages()[..2]);
    }

    #[test]
    fn what_is_wrong_with_a_deformation_is_named() {
        let broken = |from: &str, to: &str| {
            assert!(BENT.contains(from));
            primitive_from_json(&BENT.replace(from, to)).unwrap_err().to_string()
        };
        let cases = [
            (broken("\"scale\"", "\"shear\""), "shear"),
            (broken("[1, 1, 2]", "[1, 0, 2]"), "factor of a scaling"),
            (broken("[1, 0.5]]},", "[1, -0.5]]},"), "taper folds"),
            (broken("\"rate\": 0.25", "\"rate\": 3"), "of the bend meet"),
            (broken("[[-1, 0], [1, 0.5]]", "[[1, 0], [1, 0.5]]"), "knots"),
            (broken("\"frame\"", "\"axis\": {\"direction\": [0, 0, 1]}, \"frame\""), "not both"),
        ];
        for (message, expected) in cases {
            assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        }
        let plain = super::super::model_from_json(BENT).unwrap_err().to_string();
        assert!(plain.contains("without deformations"), "{plain}");
    }

    #[test]
    fn a_function_has_no_document() -> Result<(), DeformError> {
        let mut primitive = primitive_from_json(BENT).unwrap();
        let line = crate::deform::Line::new(0.0, 0.1)?;
        let twist = Twist::new(Profile::Function(Arc::new(line)));
        let chain = Chain::new([Deformation::new(twist)]);
        primitive.deformed = Deformed::new(*primitive.deformed.shape(), chain)?;
        assert!(matches!(ModelDocument::try_from(&primitive), Err(DocumentError::Function)));
        Ok(())
    }
}
