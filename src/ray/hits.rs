//! Where a ray passes a level set: all crossings, none of them missed.

use super::along::{Along, Verdict};
use super::half_line::Ray;
use crate::math::Interval;
use crate::shape::LevelSet;

/// Share of the searched stretch below which crossings are not told apart.
const FINEST: f64 = 1e-12;

/// Most pieces that a ray is cut into; only one that runs within a face for a long stretch
/// needs as many.
const MOST_PIECES: usize = 4000;

/// The crossings of level 1 along a stretch of a ray, in ascending order; as they are asked for.
///
/// A stretch over which the enclosure of the level does not hold 1 has none; one over which the
/// level's slope does not vanish has at most one; others are halved. For a deformed shape this
/// traces the undeformed one along the curved ray (B84 section 4). A ray that only touches does
/// not cross.
#[derive(Debug)]
pub(super) struct Crossings<'a, S> {
    along: Along<'a, S>,
    /// What is left to look at, the first at the end.
    left: Vec<Interval>,
    finest: f64,
    pieces: usize,
}

impl<'a, S: LevelSet> Crossings<'a, S> {
    pub fn new(solid: &'a S, ray: Ray, [from, to]: [f64; 2]) -> Self {
        let finest = FINEST * (to - from).max(f64::EPSILON * to.abs());
        let along = Along { solid, ray };
        Self { along, left: vec![Interval::new(from, to)], finest, pieces: 0 }
    }

    /// The one crossing in a range, if its ends differ in side.
    fn crossing(&self, range: Interval) -> Option<f64> {
        let [starts_inside, ends_inside] =
            [range.lo(), range.hi()].map(|end| self.along.is_inside(end));
        (starts_inside != ends_inside)
            .then(|| self.along.crossing([range.lo(), range.hi()], starts_inside, range.middle()))
    }
}

impl<S: LevelSet> Iterator for Crossings<'_, S> {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        while let Some(range) = self.left.pop() {
            self.pieces += 1;
            let is_last = range.width() <= self.finest || self.pieces > MOST_PIECES;
            match self.along.judge(range) {
                Verdict::Apart => {}
                Verdict::Unknown if !is_last => {
                    let [first, second] = range.halves();
                    self.left.extend([second, first]);
                }
                Verdict::Monotone | Verdict::Unknown => {
                    let crossing = self.crossing(range);
                    if crossing.is_some() {
                        return crossing;
                    }
                }
            }
        }
        None
    }
}
