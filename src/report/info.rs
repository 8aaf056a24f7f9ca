//! What is known of a model, in JSON.

use serde::Serialize;

use super::document::to_json;
use super::model_document::{ModelDocument, rows};
use crate::model::Model;
use crate::shape::{Shape, Solid};

/// What is known of a model, besides its parameters.
#[derive(Debug, Clone, Serialize)]
pub struct InfoDocument {
    #[serde(flatten)]
    model: ModelDocument,
    /// Of the solid's box along its own axes.
    extents: [f64; 3],
    volume: f64,
    surface_area: f64,
    /// About the centroid, in the model's axes, of unit density.
    inertia: [[f64; 3]; 3],
    bounding_box: [[f64; 3]; 2],
}

impl InfoDocument {
    /// The document of a model.
    pub fn new(model: &Model<Shape>) -> Self {
        let [min, max] = model.shape.bounding_box();
        let mass = model.shape.mass_properties();
        Self {
            model: model.into(),
            extents: (max - min).into(),
            volume: mass.volume(),
            surface_area: model.shape.surface_area(),
            inertia: rows(&mass.inertia()),
            bounding_box: model.bounding_box().map(Into::into),
        }
    }

    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}
