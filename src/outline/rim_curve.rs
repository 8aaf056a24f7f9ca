//! The rim of any smooth solid: closed curves, several for a ring.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use rayon::prelude::*;

use super::facing::Facing;
use super::visibility::Visibility;
use crate::deform::Deformed;
use crate::shape::Shape;
use crate::surface::{Mesh, Resolution, deformed_mesh, tessellate_shape};
use crate::view::{RimError, Viewpoint};

/// A closed curve of the rim: the last point is next to the first.
#[derive(Debug, Clone, PartialEq)]
pub struct RimCurve {
    /// Points in their order; the part of the surface that faces the camera is to the left, as
    /// seen from outside.
    pub points: Vec<Vector3<f64>>,
    /// Whether the solid itself hides each.
    pub is_hidden: Vec<bool>,
}

/// The rim of a deformed shape of any family, in the shape's frame (JLS Eqs. 2.44, 2.45).
///
/// It separates the vertices of a mesh that face the camera from those that do not; each point is
/// then solved for on the surface. On edges, those of caps among them, where the normal jumps
/// past the rim's condition, it follows the edge. Parts of the rim smaller than the mesh's
/// triangles may be missed.
///
/// # Errors
/// If the camera is in the solid, or the viewpoint is no place or direction.
pub fn rim_curves(
    solid: &Deformed<Shape>,
    viewpoint: &Viewpoint,
    resolution: Resolution,
) -> Result<Vec<RimCurve>, RimError> {
    check(solid, viewpoint)?;
    let mesh = deformed_mesh(solid, &tessellate_shape(solid.shape(), resolution));
    let facing = Facing { solid, viewpoint: *viewpoint };
    let visibility = Visibility::new(solid, *viewpoint);
    let curve = |edges: Vec<[u32; 2]>| {
        let ends = |edge: [u32; 2]| edge.map(|i| mesh.vertices()[i as usize]);
        let mut points: Vec<Vector3<f64>> =
            edges.into_par_iter().map(|edge| facing.crossing(ends(edge))).collect();
        points.dedup();
        let is_hidden = points.par_iter().map(|x| visibility.is_hidden(x)).collect();
        RimCurve { points, is_hidden }
    };
    Ok(loops(&mesh, &facing).into_iter().map(curve).collect())
}

fn check(solid: &Deformed<Shape>, viewpoint: &Viewpoint) -> Result<(), RimError> {
    let (Viewpoint::At(vector) | Viewpoint::Along(vector)) = viewpoint;
    let is_finite = vector.iter().all(|component| component.is_finite());
    match viewpoint {
        _ if !is_finite => Err(RimError::Viewpoint),
        Viewpoint::Along(direction) if direction.amax() == 0.0 => Err(RimError::Viewpoint),
        Viewpoint::At(centre) if solid.inside_outside(centre) <= 1.0 && solid.contains(centre) => {
            Err(RimError::Inside)
        }
        _ => Ok(()),
    }
}

/// The edges `[front, back]` that each closed curve of the rim crosses, in their order.
///
/// Of a triangle that the rim crosses one edge leads away from what faces the camera and one back
/// to it. The latter is the former of the triangle beyond it: on a closed mesh all curves close.
fn loops(mesh: &Mesh, facing: &Facing<'_, Deformed<Shape>>) -> Vec<Vec<[u32; 2]>> {
    let faces: Vec<bool> = mesh.vertices().par_iter().map(|x| facing.away(x) < 0.0).collect();
    let mut next = BTreeMap::new();
    for &[a, b, c] in mesh.triangles() {
        let edges = [[a, b], [b, c], [c, a]];
        let turned = |from: bool| {
            edges
                .into_iter()
                .find(|[i, j]| faces[*i as usize] == from && faces[*j as usize] != from)
        };
        if let (Some(leaving), Some([back, front])) = (turned(true), turned(false)) {
            next.insert(leaving, [front, back]);
        }
    }
    let mut loops = Vec::new();
    while let Some((first, mut edge)) = next.pop_first() {
        let mut crossed = vec![first];
        while let Some(following) = next.remove(&edge) {
            crossed.push(edge);
            edge = following;
        }
        loops.push(crossed);
    }
    loops
}
