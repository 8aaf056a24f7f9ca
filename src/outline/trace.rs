//! The rim of one solid as closed curves whose points are solved for.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use rayon::prelude::*;

use super::facing::Facing;
use crate::shape::LevelSet;
use crate::surface::Mesh;

/// Halvings of a chord, at most.
const HALVINGS: u32 = 12;

/// Share of the mesh's size within which points are one: where several edges of the mesh meet on
/// an edge of the solid.
const SAME: f64 = 1e-9;

/// The rim as closed curves of points of it, the last next to the first; what faces the camera is
/// to their left, as seen from outside.
///
/// It separates the vertices of a mesh that face the camera from those that do not; parts smaller
/// than the mesh's triangles may be missed. Chords are halved, with the point of the rim beside
/// their middle, as long as they are coarse: `is_coarse([start, beside the middle, end])`. On
/// edges, those of caps among them, where the normal jumps past the rim's condition, it follows
/// the edge.
pub(super) fn trace<S: LevelSet + Sync>(
    facing: &Facing<'_, S>,
    mesh: &Mesh,
    is_coarse: impl Fn(&[Vector3<f64>; 3]) -> bool + Sync,
) -> Vec<Vec<Vector3<f64>>> {
    let from_first = |x: &Vector3<f64>| (x - mesh.vertices()[0]).norm();
    let same = SAME * mesh.vertices().iter().map(from_first).fold(0.0, f64::max);
    let curve = |edges: Vec<[u32; 2]>| {
        let ends = |edge: [u32; 2]| edge.map(|i| mesh.vertices()[i as usize]);
        let mut points: Vec<Vector3<f64>> =
            edges.into_par_iter().map(|edge| facing.crossing(ends(edge))).collect();
        points.dedup_by(|a, b| (*a - *b).norm() <= same);
        refined(facing, &points, &is_coarse)
    };
    loops(mesh, facing).into_iter().map(curve).filter(|curve| curve.len() >= 3).collect()
}

/// A closed curve with points between its own until none of its chords is coarse.
fn refined<S: LevelSet + Sync>(
    facing: &Facing<'_, S>,
    points: &[Vector3<f64>],
    is_coarse: &(impl Fn(&[Vector3<f64>; 3]) -> bool + Sync),
) -> Vec<Vector3<f64>> {
    let piece = |i: usize| {
        let (start, end) = (points[i], points[(i + 1) % points.len()]);
        let mut piece = vec![start];
        // Ends of what lies ahead, nearest last.
        let mut ahead = vec![(end, 0)];
        while let Some((end, halved)) = ahead.pop() {
            let start = piece[piece.len() - 1];
            let middle = (halved < HALVINGS).then(|| facing.beside([start, end], 0.5)).flatten();
            match middle {
                Some(middle) if is_coarse(&[start, middle, end]) => {
                    ahead.extend([(end, halved + 1), (middle, halved + 1)]);
                }
                _ => piece.push(end),
            }
        }
        piece.pop();
        piece
    };
    (0..points.len()).into_par_iter().flat_map_iter(piece).collect()
}

/// The edges `[front, back]` that each closed curve of the rim crosses, in their order.
///
/// Of a triangle that the rim crosses one edge leads away from what faces the camera and one back
/// to it. The latter is the former of the triangle beyond it: on a closed mesh all curves close.
fn loops<S: LevelSet + Sync>(mesh: &Mesh, facing: &Facing<'_, S>) -> Vec<Vec<[u32; 2]>> {
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
