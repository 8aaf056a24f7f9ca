//! A solid of many primitives that rays are shot at.

use nalgebra::Vector3;

use super::hits::{Crossings, Ray};
use super::target::{Hit, Hittable, widened};
use crate::shape::{LevelSet, Shape, Solid};
use crate::solid::{Primitive, Tree};

/// A solid, and a box around each of its primitives: a ray asks only those whose box it meets.
#[derive(Debug, Clone)]
pub struct SolidTarget<S = Shape> {
    tree: Tree<(Primitive<S>, [Vector3<f64>; 2])>,
}

impl<S: Solid + LevelSet + Clone> SolidTarget<S> {
    /// A solid in the world.
    pub fn new(solid: &Tree<Primitive<S>>) -> Self {
        let boxed =
            |primitive: &Primitive<S>| (primitive.clone(), widened(primitive.bounding_box()));
        Self { tree: solid.map(&boxed) }
    }
}

impl<S: LevelSet> Hittable for SolidTarget<S> {
    fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        let Met { solid, range } = met(&self.tree, ray)?;
        Crossings::new(&solid, *ray, range).next().map(|t| Hit::of(&solid, ray, t))
    }

    fn all_hits(&self, ray: &Ray) -> Vec<Hit> {
        let Some(Met { solid, range }) = met(&self.tree, ray) else { return Vec::new() };
        Crossings::new(&solid, *ray, range).map(|t| Hit::of(&solid, ray, t)).collect()
    }
}

/// What of a solid a ray may meet, and where along the ray.
struct Met<'a, S> {
    solid: Tree<&'a Primitive<S>>,
    range: [f64; 2],
}

fn met<'a, S>(tree: &'a Tree<(Primitive<S>, [Vector3<f64>; 2])>, ray: &Ray) -> Option<Met<'a, S>> {
    match tree {
        Tree::Leaf((primitive, bounds)) => {
            let range = ray.clipped(bounds)?;
            Some(Met { solid: Tree::Leaf(primitive), range })
        }
        Tree::Union(parts) => {
            let met: Vec<Met<'a, S>> = parts.iter().filter_map(|part| met(part, ray)).collect();
            let hull = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
            let range = met.iter().map(|part| part.range).reduce(hull)?;
            Some(Met { solid: Tree::Union(solids(met)), range })
        }
        Tree::Intersection(parts) => {
            let met: Vec<Met<'a, S>> =
                parts.iter().map(|part| met(part, ray)).collect::<Option<_>>()?;
            let shared = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
            let range = met.iter().map(|part| part.range).reduce(shared)?;
            let is_empty = range[0] > range[1];
            (!is_empty).then(|| Met { solid: Tree::Intersection(solids(met)), range })
        }
        Tree::Difference(from, parts) => {
            let Met { solid, range } = met(from, ray)?;
            let taken = solids(parts.iter().filter_map(|part| met(part, ray)));
            Some(Met { solid: Tree::Difference(Box::new(solid), taken), range })
        }
    }
}

fn solids<'a, S>(met: impl IntoIterator<Item = Met<'a, S>>) -> Vec<Tree<&'a Primitive<S>>> {
    met.into_iter().map(|part| part.solid).collect()
}
