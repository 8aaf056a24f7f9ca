//! What is known of a shape besides its points: rows of their own in the least-squares problem.

mod seen_area;

pub(crate) use seen_area::SeenArea;

use super::kernel::Gram;
use super::normalization::Normalization;
use crate::model::Model;

/// What is known, in normalised coordinates.
#[derive(Debug, Clone, Default)]
pub(crate) struct Evidence {
    /// The area on which the points lie.
    pub seen_area: Option<SeenArea>,
}

impl Evidence {
    /// Nothing.
    pub const NONE: Self = Self { seen_area: None };

    /// In the coordinates of another normalisation of the same cloud.
    pub fn renormalized(&self, from: &Normalization, to: &Normalization) -> Self {
        let ratio = from.radius * to.inverse_radius;
        let seen_area = self.seen_area.map(|SeenArea(area)| SeenArea(area * ratio * ratio));
        Self { seen_area }
    }

    /// Adds its rows at a model to those of points with that weight in all.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        if let Some(seen_area) = &self.seen_area {
            seen_area.add_to(gram, model, weight);
        }
    }
}
