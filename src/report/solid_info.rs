//! What is known of solids and scenes, in JSON.

use nalgebra::Vector3;
use serde::Serialize;

use super::document::to_json;
use crate::ray::Scene;
use crate::solid::{Tree, volume_bounds};

/// How near to each other the bounds on a volume are to come, if cells as fine as
/// [`volume_bounds`] takes them allow.
const VOLUME_TOLERANCE: f64 = 1e-3;

/// What is known of a union, intersection or difference.
#[derive(Debug, Clone, Serialize)]
pub struct SolidInfoDocument {
    /// Models that it is made of.
    pub(super) models: usize,
    /// A lower and an upper bound.
    pub(super) volume_bounds: [f64; 2],
    /// In the world; holds the solid. None if boxes tell that nothing is left of it.
    pub(super) bounding_box: Option<[[f64; 3]; 2]>,
}

impl SolidInfoDocument {
    /// The document of a solid.
    pub fn new(solid: &Tree) -> Self {
        Self {
            models: solid.leaves(),
            volume_bounds: volume_bounds(solid, VOLUME_TOLERANCE),
            bounding_box: box_of(solid),
        }
    }

    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}

/// What is known of a scene.
#[derive(Debug, Clone, Serialize)]
pub struct SceneInfoDocument {
    pub(super) solids: Vec<SolidInfoDocument>,
    /// Of all solids.
    pub(super) bounding_box: Option<[[f64; 3]; 2]>,
}

impl SceneInfoDocument {
    /// The document of a scene.
    pub fn new(scene: &Scene) -> Self {
        let solids = scene.items.iter().map(|item| SolidInfoDocument::new(&item.solid));
        Self { solids: solids.collect(), bounding_box: box_of(&scene.solid()) }
    }

    /// Indented JSON with a final newline.
    pub fn to_json(&self) -> String {
        to_json(self)
    }
}

fn box_of(solid: &Tree) -> Option<[[f64; 3]; 2]> {
    let [min, max] = solid.bounding_box();
    let is_box = |side: &f64| *side >= 0.0 && side.is_finite();
    (max - min).iter().all(is_box).then(|| [min, max].map(Vector3::into))
}
