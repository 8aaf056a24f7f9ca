//! A closed curve of the rim as a function of one number.

use std::sync::Arc;

use nalgebra::Vector3;
use rayon::prelude::*;

use super::facing::Facing;
use crate::solid::Tree;
use crate::surface::Sheet;

/// A surface over triangles, and where it is seen from.
#[derive(Clone)]
pub(super) struct Seen<'a> {
    pub facing: Facing<'a, Tree>,
    pub sheet: Arc<dyn Sheet + 'a>,
}

impl Seen<'_> {
    /// The point of the surface over a corner.
    pub fn corner(&self, corner: u32) -> Vector3<f64> {
        self.sheet.point([corner; 3], [1.0, 0.0, 0.0])
    }

    /// The point over a place on a side, from 0 to 1.
    fn on_side(&self, [from, to]: [u32; 2], place: f64) -> Vector3<f64> {
        self.sheet.point([from, to, to], [1.0 - place, place, 0.0])
    }

    /// Whether a point of the surface faces the camera.
    pub fn faces(&self, x: &Vector3<f64>) -> bool {
        self.facing.away(x) < 0.0
    }

    /// Where the rim passes a path on the surface between 0 and 1, if 0 alone faces the camera, or 0
    /// alone does not.
    fn crossing(&self, faces: bool, path: impl Fn(f64) -> Vector3<f64>) -> f64 {
        if faces {
            self.facing.crossing(path)
        } else {
            1.0 - self.facing.crossing(|place| path(1.0 - place))
        }
    }
}

/// The rim over a triangle of which one corner, the apex, faces the camera and the others do not,
/// or the other way around.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub apex: u32,
    /// Whether the apex faces the camera.
    pub faces: bool,
    /// The other corners; the rim passes the side to the first of them first.
    pub base: [u32; 2],
    /// The corner beyond the base, if it does not face as the apex does.
    pub beyond: Option<u32>,
}

/// A closed curve of the rim: a piece from each whole number to the next.
pub(super) struct Path<'a> {
    seen: Seen<'a>,
    pieces: Vec<Piece>,
    /// The sides `[front, back]` on which the pieces begin, and where the rim passes them.
    starts: Vec<([u32; 2], f64)>,
}

impl<'a> Path<'a> {
    /// The curve of pieces of which each ends on the side where the next begins, and these sides,
    /// `[front, back]`.
    pub fn new(seen: Seen<'a>, pieces: Vec<Piece>, sides: Vec<[u32; 2]>) -> Self {
        let start = |side| (side, seen.facing.crossing(|share| seen.on_side(side, share)));
        let starts = sides.into_par_iter().map(start).collect();
        Self { seen, pieces, starts }
    }

    /// The points at which the pieces begin.
    pub fn starts(&self) -> Vec<Vector3<f64>> {
        self.starts.iter().map(|(side, share)| self.seen.on_side(*side, *share)).collect()
    }

    /// How far from a piece's apex to its base the rim passes the two sides.
    fn reaches(&self, number: usize) -> [f64; 2] {
        [number, (number + 1) % self.starts.len()].map(|start| {
            let (_, share) = self.starts[start];
            if self.pieces[number].faces { share } else { 1.0 - share }
        })
    }

    /// How many pieces there are.
    pub fn len(&self) -> usize {
        self.pieces.len()
    }

    /// The point of the rim at a place from 0 to the number of pieces.
    ///
    /// It is looked for on the way from the apex of a triangle to its base and, where all of that
    /// faces as the apex does, beyond.
    pub fn at(&self, place: f64) -> Vector3<f64> {
        let number = (place as usize).min(self.pieces.len() - 1);
        let Piece { apex, faces, base: [a, b], beyond } = self.pieces[number];
        let share = on_base(self.reaches(number), place - number as f64);
        let point = |corner: u32, weight: f64| {
            let rest = 1.0 - weight;
            self.seen.sheet.point([corner, a, b], [weight, rest * (1.0 - share), rest * share])
        };
        let inwards = |reach: f64| point(apex, 1.0 - reach);
        let foot = inwards(1.0);
        if self.seen.faces(&foot) != faces {
            return inwards(self.seen.crossing(faces, inwards));
        }
        let Some(beyond) = beyond else { return foot };
        let outwards = |reach: f64| point(beyond, reach);
        outwards(self.seen.crossing(faces, outwards))
    }
}

/// The share of a base at which a line from the apex meets it, if it passes that share of the chord
/// between places on the sides.
fn on_base([first, last]: [f64; 2], share: f64) -> f64 {
    let [before, after] = [(1.0 - share) * first, share * last];
    if before + after > 0.0 { after / (before + after) } else { share }
}
