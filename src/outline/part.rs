//! The parts of a solid whose rims are traced one by one.

use std::sync::Arc;

use nalgebra::Vector3;

use super::curve::Curve;
use super::facing::Facing;
use super::path::Seen;
use super::trace::trace;
use crate::model::Model;
use crate::shape::{Shape, Superellipsoid};
use crate::solid::{Primitive, Tree};
use crate::surface::{ChartSheet, GridSheet, Resolution, Sheet};
use crate::view::Viewpoint;

/// Fewest cells of a boolean's grid along its longest side: edges run across them.
const FEWEST_CELLS: usize = 64;

/// A part of a solid, which is the union of its parts.
pub(super) struct Part<'a> {
    pub solid: &'a Tree,
    /// The part as a model, if it is a convex superellipsoid.
    pub convex: Option<Model>,
    /// A box that holds it, `[min, max]`.
    pub bounds: [Vector3<f64>; 2],
}

/// The parts of a solid that are not empty.
pub(super) fn parts(solid: &Tree) -> Vec<Part<'_>> {
    if let Tree::Union(of) = solid {
        return of.iter().flat_map(parts).collect();
    }
    let bounds @ [min, max] = solid.bounding_box();
    let is_empty = (max - min).iter().any(|side| !(*side > 0.0 && side.is_finite()));
    if is_empty { Vec::new() } else { vec![Part { solid, convex: convex(solid), bounds }] }
}

/// A box that holds all parts, `[min, max]`.
pub(super) fn bounds(parts: &[Part<'_>]) -> [Vector3<f64>; 2] {
    let infinite = Vector3::from_element(f64::INFINITY);
    let hull = |[min, max]: [Vector3<f64>; 2], part: &Part<'_>| {
        [min.inf(&part.bounds[0]), max.sup(&part.bounds[1])]
    };
    parts.iter().fold([infinite, -infinite], hull)
}

/// The undeformed superellipsoid that is convex, if it is one.
pub(super) fn convex(solid: &Tree) -> Option<Model> {
    let Tree::Leaf(primitive) = solid else { return None };
    let Model { shape, pose } = primitive.undeformed()?;
    let is_convex = |shape: &Superellipsoid| shape.exponents().iter().all(|e| *e <= 2.0);
    match shape {
        Shape::Superellipsoid(shape) if is_convex(&shape) => Some(Model { shape, pose }),
        _ => None,
    }
}

impl<'a> Part<'a> {
    /// The curves of the rim, traced over triangles of so many segments; refined as [`trace`] does.
    pub fn trace(
        &self,
        viewpoint: &Viewpoint,
        segments: usize,
        is_coarse: impl Fn(&[Vector3<f64>; 3]) -> bool + Sync,
    ) -> Vec<Curve<'a>> {
        let facing = Facing { solid: self.solid, viewpoint: *viewpoint };
        trace(&Seen { facing, sheet: self.sheet(segments) }, is_coarse)
    }

    /// The part's boundary.
    fn sheet(&self, segments: usize) -> Arc<dyn Sheet + 'a> {
        match self.solid {
            Tree::Leaf(Primitive { deformed, pose }) => {
                let resolution = Resolution::new(segments).unwrap_or_default();
                Arc::new(ChartSheet::new(deformed, pose, resolution))
            }
            solid => Arc::new(GridSheet::new(solid, self.bounds, segments.max(FEWEST_CELLS))),
        }
    }
}
