//! The parts of a solid whose rims are traced one by one.

use nalgebra::Vector3;

use super::facing::Facing;
use super::spacing::evenly;
use super::trace::trace;
use crate::model::Model;
use crate::shape::{Shape, Superellipsoid};
use crate::solid::{Primitive, Tree};
use crate::surface::{Mesh, Resolution, boundary_mesh, deformed_mesh, tessellate_shape};
use crate::view::{RimError, Viewpoint, rim};

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

impl Part<'_> {
    /// The curves of the rim, traced on a mesh of so many segments; refined as [`trace`] does.
    pub fn trace(
        &self,
        viewpoint: &Viewpoint,
        segments: usize,
        is_coarse: impl Fn(&[Vector3<f64>; 3]) -> bool + Sync,
    ) -> Vec<Vec<Vector3<f64>>> {
        trace(&self.facing(viewpoint), &self.mesh(segments), is_coarse)
    }

    /// So many points at even distances along one of the curves.
    ///
    /// # Errors
    /// If the viewpoint is not outside a convex part.
    pub fn evenly(
        &self,
        curve: &[Vector3<f64>],
        viewpoint: &Viewpoint,
        count: usize,
    ) -> Result<Vec<Vector3<f64>>, RimError> {
        let Some(Model { shape, pose }) = &self.convex else {
            return Ok(evenly(&self.facing(viewpoint), curve, count));
        };
        let points = rim(shape, &viewpoint.in_frame_of(pose), count)?;
        Ok(points.iter().map(|x| pose.world_from_model(x)).collect())
    }

    fn facing(&self, viewpoint: &Viewpoint) -> Facing<'_, Tree> {
        Facing { solid: self.solid, viewpoint: *viewpoint }
    }

    /// A closed mesh of the part's boundary.
    fn mesh(&self, segments: usize) -> Mesh {
        match self.solid {
            Tree::Leaf(Primitive { deformed, pose }) => {
                let resolution = Resolution::new(segments).unwrap_or_default();
                deformed_mesh(deformed, &tessellate_shape(deformed.shape(), resolution))
                    .transformed(pose)
            }
            solid => boundary_mesh(solid, self.bounds, segments),
        }
    }
}
