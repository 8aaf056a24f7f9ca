//! The rim of one solid as closed curves whose points are solved for.

use std::collections::{BTreeMap, HashMap};

use nalgebra::Vector3;
use rayon::prelude::*;

use super::curve::Curve;
use super::path::{Path, Piece, Seen};

/// Halvings of a piece, at most.
const HALVINGS: u32 = 12;

/// The rim as closed curves of points of it, the last next to the first; what faces the camera is
/// to their left, as seen from outside.
///
/// It separates the corners of triangles that face the camera from those that do not; parts smaller
/// than the triangles may be missed. Chords are halved, with the point of the rim over their middle,
/// as long as they are coarse: `is_coarse([start, over the middle, end])`. On edges, those of caps
/// among them, where the normal jumps past the rim's condition, it follows the edge.
pub(super) fn trace<'a>(
    seen: &Seen<'a>,
    is_coarse: impl Fn(&[Vector3<f64>; 3]) -> bool + Sync,
) -> Vec<Curve<'a>> {
    let corners = 0..seen.sheet.count() as u32;
    let faces: Vec<bool> =
        corners.into_par_iter().map(|corner| seen.faces(&seen.corner(corner))).collect();
    let loops = loops(seen.sheet.triangles(), &faces);
    let beyond = Beyond::new(seen.sheet.triangles(), &faces, &loops);
    let curve = |crossed: Vec<[u32; 2]>| {
        let next = crossed.iter().cycle().skip(1);
        let pieces = crossed.iter().zip(next).map(|(from, to)| beyond.piece(*from, *to)).collect();
        let path = Path::new(seen.clone(), pieces, crossed);
        let (places, points) = refined(&path, &is_coarse);
        Curve::traced(path, places, points)
    };
    loops.into_par_iter().map(curve).collect()
}

/// Places on a closed path, and their points, so many that no chord between them is coarse.
fn refined(
    path: &Path<'_>,
    is_coarse: &(impl Fn(&[Vector3<f64>; 3]) -> bool + Sync),
) -> (Vec<f64>, Vec<Vector3<f64>>) {
    let at = |place: f64| (place, path.at(place));
    let starts = path.starts();
    let piece = |i: usize| {
        let mut piece = vec![(i as f64, starts[i])];
        // Ends of what lies ahead, nearest last.
        let mut ahead = vec![((i as f64 + 1.0, starts[(i + 1) % starts.len()]), 0)];
        while let Some((end, halved)) = ahead.pop() {
            let start = piece[piece.len() - 1];
            let is_point = start.1 == end.1;
            let middle = (halved < HALVINGS && !is_point).then(|| at(0.5 * (start.0 + end.0)));
            match middle {
                Some(middle) if is_coarse(&[start.1, middle.1, end.1]) => {
                    ahead.extend([(end, halved + 1), (middle, halved + 1)]);
                }
                _ => piece.push(end),
            }
        }
        piece.pop();
        piece
    };
    (0..starts.len()).into_par_iter().flat_map_iter(piece).unzip()
}

/// The sides `[front, back]` that each closed curve of the rim crosses, in their order.
///
/// Of a triangle that the rim crosses one side leads away from what faces the camera and one back
/// to it. The latter is the former of the triangle beyond it: on a closed surface all curves close.
fn loops(triangles: &[[u32; 3]], faces: &[bool]) -> Vec<Vec<[u32; 2]>> {
    let mut next = BTreeMap::new();
    for triangle in triangles {
        let turned = |from: bool| {
            sides(*triangle)
                .into_iter()
                .find(|[i, j]| faces[*i as usize] == from && faces[*j as usize] != from)
        };
        if let (Some(leaving), Some([back, front])) = (turned(true), turned(false)) {
            next.insert(leaving, [front, back]);
        }
    }
    let mut loops = Vec::new();
    while let Some((first, mut side)) = next.pop_first() {
        let mut crossed = vec![first];
        while let Some(following) = next.remove(&side) {
            crossed.push(side);
            side = following;
        }
        loops.push(crossed);
    }
    loops
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// What lies beyond the triangles that the rim crosses.
struct Beyond<'a> {
    faces: &'a [bool],
    /// The third corner of the triangles that have a side, by the side.
    corners: HashMap<[u32; 2], u32>,
}

impl<'a> Beyond<'a> {
    fn new(triangles: &[[u32; 3]], faces: &'a [bool], loops: &[Vec<[u32; 2]>]) -> Self {
        let mut is_near = vec![false; faces.len()];
        loops.iter().flatten().flatten().for_each(|corner| is_near[*corner as usize] = true);
        let mut corners = HashMap::new();
        for triangle in triangles {
            for (side @ [a, b], opposite) in sides(*triangle).into_iter().zip([2, 0, 1]) {
                if is_near[a as usize] && is_near[b as usize] {
                    corners.insert(side, triangle[opposite]);
                }
            }
        }
        Self { faces, corners }
    }

    /// The piece of the rim between two sides `[front, back]` of a triangle.
    fn piece(&self, from: [u32; 2], to: [u32; 2]) -> Piece {
        let faces = from[0] == to[0];
        let (apex, base) =
            if faces { (from[0], [from[1], to[1]]) } else { (from[1], [from[0], to[0]]) };
        // The triangle passes its base from the first end to the last if its apex faces the camera.
        let [a, b] = base;
        let beyond = self.corners.get(&if faces { [b, a] } else { [a, b] });
        let beyond = beyond.copied().filter(|corner| self.faces[*corner as usize] != faces);
        Piece { apex, faces, base, beyond }
    }
}
