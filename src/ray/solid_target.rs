//! A solid of many primitives that rays are shot at.

use nalgebra::Vector3;

use super::cage::Cage;
use super::half_line::Ray;
use super::passage::Passage;
use super::target::{Hit, Hittable, widened};
use crate::shape::{LevelSet, Shape, Solid};
use crate::solid::{Primitive, Tree};

/// A solid, and around each of its primitives a box, cut into cells where its surface is.
///
/// A ray asks only those primitives whose box it meets, and of them only the cells that it
/// passes. No crossing is missed, however thin the part.
#[derive(Debug, Clone)]
pub struct SolidTarget<S = Shape> {
    /// The numbers of the parts, made a solid.
    tree: Tree<usize>,
    parts: Vec<Part<S>>,
}

/// A primitive, with its box and cells in its own frame.
#[derive(Debug, Clone)]
pub(super) struct Part<S> {
    pub primitive: Primitive<S>,
    pub bounds: [Vector3<f64>; 2],
    pub cage: Cage,
}

impl<S: Solid + LevelSet + Clone> SolidTarget<S> {
    /// A solid in the world.
    pub fn new(solid: &Tree<Primitive<S>>) -> Self {
        let mut parts = Vec::new();
        let tree = solid.map(&mut |primitive| {
            parts.push(Part::new(primitive.clone()));
            parts.len() - 1
        });
        Self { tree, parts }
    }
}

impl<S: Solid + LevelSet> Part<S> {
    fn new(primitive: Primitive<S>) -> Self {
        let cage = Cage::new(primitive.deformed.shape());
        let bounds = cage.bounds(&primitive.deformed);
        let bounds = widened(bounds.unwrap_or_else(|| primitive.deformed.bounding_box()));
        Self { primitive, bounds, cage }
    }
}

impl<S: Solid + LevelSet> Hittable for SolidTarget<S> {
    fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        Passage::of(&self.tree, &self.parts, ray)?.next()
    }

    fn all_hits(&self, ray: &Ray) -> Vec<Hit> {
        Passage::of(&self.tree, &self.parts, ray).into_iter().flatten().collect()
    }
}
