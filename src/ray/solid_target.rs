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
    /// The box around all parts, in the world.
    bounds: [Vector3<f64>; 2],
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
        let nothing = Vector3::from_element(f64::INFINITY);
        let bounds = parts.iter().map(Part::bounds_world);
        let bounds = bounds
            .fold([nothing, -nothing], |[min, max], [low, high]| [min.inf(&low), max.sup(&high)]);
        Self { tree, parts, bounds: widened(bounds) }
    }
}

impl<S: Solid + LevelSet> Part<S> {
    fn new(primitive: Primitive<S>) -> Self {
        let cage = Cage::new(primitive.deformed.shape());
        let bounds = cage.bounds(&primitive.deformed);
        let bounds = widened(bounds.unwrap_or_else(|| primitive.deformed.bounding_box()));
        Self { primitive, bounds, cage }
    }

    /// The box along the world's axes around the part's own.
    fn bounds_world(&self) -> [Vector3<f64>; 2] {
        let [min, max] = self.bounds;
        let middle = self.primitive.pose.world_from_model(&(0.5 * (min + max)));
        let half = self.primitive.pose.rotation().matrix().abs() * (0.5 * (max - min));
        [middle - half, middle + half]
    }
}

impl<S: Solid + LevelSet> Hittable for SolidTarget<S> {
    fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        self.passage(ray)?.next()
    }

    fn all_hits(&self, ray: &Ray) -> Vec<Hit> {
        self.passage(ray).into_iter().flatten().collect()
    }
}

impl<S: Solid + LevelSet> SolidTarget<S> {
    /// A ray's passage, if it may come into the solid at all.
    fn passage(&self, ray: &Ray) -> Option<Passage<'_, S>> {
        ray.clipped(&self.bounds)?;
        Passage::of(&self.tree, &self.parts, ray)
    }
}
