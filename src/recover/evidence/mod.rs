//! What is known of a shape besides its points: rows of their own in the least-squares problem.

mod deepest;
mod facing;
mod free_space;
mod seen_area;
mod side;
mod support;

pub(crate) use facing::Facing;
pub(crate) use free_space::FreeSpace;
pub(crate) use seen_area::SeenArea;
pub(crate) use side::Side;
pub(crate) use support::Support;

use super::kernel::Gram;
use super::normalization::Normalization;
use crate::model::Model;

/// What is known, in normalised coordinates.
#[derive(Debug, Clone, Default)]
pub(crate) struct Evidence {
    /// The area on which the points lie.
    pub seen_area: Option<SeenArea>,
    /// From where the points were seen.
    pub facing: Option<Facing>,
    /// Where the sensor saw that there is nothing.
    pub free_space: Option<FreeSpace>,
    /// What the object stands on.
    pub support: Option<Support>,
}

impl Evidence {
    /// Nothing.
    pub const NONE: Self = Self { seen_area: None, facing: None, free_space: None, support: None };

    /// In the coordinates of another normalisation of the same cloud.
    pub fn renormalized(&self, from: &Normalization, to: &Normalization) -> Self {
        Self {
            seen_area: self.seen_area.map(|area| area.renormalized(from, to)),
            facing: self.facing.as_ref().map(|facing| facing.renormalized(from, to)),
            free_space: self.free_space.as_ref().map(|space| space.renormalized(from, to)),
            support: self.support.map(|support| support.renormalized(from, to)),
        }
    }

    /// What a search may lean on from the start: not on rays onto the object, which a rough model
    /// blocks at random, nor on what faces the sensor.
    pub fn for_search(&self) -> Self {
        let free_space = self.free_space.as_ref().map(FreeSpace::beside_only);
        Self { free_space, facing: None, ..self.clone() }
    }

    /// With one of so many points that face the sensor, and of so many rays, which stand for all.
    pub fn thinned(&self, every: usize) -> Self {
        Self {
            facing: self.facing.as_ref().map(|facing| facing.thinned(every)),
            free_space: self.free_space.as_ref().map(|space| space.thinned(every)),
            ..self.clone()
        }
    }

    /// What was seen, without what is only usual.
    pub fn seen(&self) -> Self {
        Self { seen_area: None, ..self.clone() }
    }

    /// Adds its rows at a model to those of points with that weight in all.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        // First what multiplies the cost of the points alone.
        if let Some(seen_area) = &self.seen_area {
            seen_area.add_to(gram, model, weight);
        }
        if let Some(facing) = &self.facing {
            facing.add_to(gram, model, weight);
        }
        if let Some(free_space) = &self.free_space {
            free_space.add_to(gram, model, weight);
        }
        if let Some(support) = &self.support {
            support.add_to(gram, model, weight);
        }
    }
}
