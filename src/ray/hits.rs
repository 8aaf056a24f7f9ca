//! Where a ray passes a level set: all crossings, none of them missed.

use nalgebra::Vector3;

use crate::math::{Dual, Interval};
use crate::shape::LevelSet;

/// Share of the searched stretch below which crossings are not told apart.
const FINEST: f64 = 1e-12;

/// Most pieces that a ray is cut into; only one that runs within a face for a long stretch
/// needs as many.
const MOST_PIECES: usize = 4000;

/// Most steps of Newton's method and halvings for one crossing: halving alone comes to rounding
/// within so many.
const MOST_STEPS: usize = 80;

/// A half-line `origin + t direction`, t in units of the direction's length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Where it begins.
    pub origin: Vector3<f64>,
    /// Where it goes; of any length but 0.
    pub direction: Vector3<f64>,
}

impl Ray {
    /// The point at t.
    pub fn at(&self, t: f64) -> Vector3<f64> {
        self.origin + t * self.direction
    }

    /// The point over a range of t, and its derivative.
    fn over(&self, range: Interval) -> [Dual; 3] {
        let t = Dual::variable(range);
        std::array::from_fn(|i| {
            let part = self.direction[i];
            let moved = range * part + self.origin[i];
            Dual { value: moved, slope: t.slope * part }
        })
    }

    /// The range of t within a box `[min, max]`, if the ray meets it.
    pub(super) fn clipped(&self, [min, max]: &[Vector3<f64>; 2]) -> Option<[f64; 2]> {
        let mut range = [0.0, f64::INFINITY];
        for i in 0..3 {
            let ends = [min[i], max[i]].map(|end| (end - self.origin[i]) / self.direction[i]);
            let is_parallel = self.direction[i] == 0.0;
            if is_parallel {
                if self.origin[i] < min[i] || self.origin[i] > max[i] {
                    return None;
                }
                continue;
            }
            range = [range[0].max(ends[0].min(ends[1])), range[1].min(ends[0].max(ends[1]))];
        }
        (range[0] <= range[1] && range[1].is_finite()).then_some(range)
    }
}

/// The crossings of level 1 along a stretch of a ray, in ascending order; as they are asked for.
///
/// A stretch over which the enclosure of the level does not hold 1 has none; one over which the
/// level's slope does not vanish has at most one; others are halved. For a deformed shape this
/// traces the undeformed one along the curved ray (B84 section 4). A ray that only touches does
/// not cross.
pub(super) struct Crossings<'a, S> {
    solid: &'a S,
    ray: Ray,
    /// What is left to look at, the first at the end.
    left: Vec<Interval>,
    finest: f64,
    pieces: usize,
}

impl<'a, S: LevelSet> Crossings<'a, S> {
    pub fn new(solid: &'a S, ray: Ray, [from, to]: [f64; 2]) -> Self {
        let finest = FINEST * (to - from).max(f64::EPSILON * to.abs());
        Self { solid, ray, left: vec![Interval::new(from, to)], finest, pieces: 0 }
    }

    /// The level less 1.
    fn excess(&self, t: f64) -> f64 {
        let x: [f64; 3] = self.ray.at(t).into();
        let excess = self.solid.level(x) - 1.0;
        if excess.is_nan() { f64::INFINITY } else { excess }
    }

    /// What the enclosures over a range tell.
    fn judge(&self, range: Interval) -> Verdict {
        let level = self.solid.level(self.ray.over(range));
        if !level.value.contains(1.0) {
            return Verdict::Apart;
        }
        // The mean value theorem, from the middle.
        let middle = range.middle();
        let point = self.ray.at(middle);
        let start = self.solid.level([point.x, point.y, point.z].map(Interval::point));
        let mean = start + level.slope * (range + -middle);
        // Rounding of the middle point itself, in its level.
        if !mean.widened_relatively(1e-13).contains(1.0) {
            Verdict::Apart
        } else if level.slope.contains(0.0) {
            Verdict::Unknown
        } else {
            Verdict::Monotone
        }
    }

    /// The crossing within a range at whose ends the levels differ in side, by Newton's method
    /// where it stays within the bounds, else by halving.
    fn refined(&self, range: Interval) -> f64 {
        let [mut low, mut high] = [range.lo(), range.hi()];
        let starts_inside = self.excess(low) < 0.0;
        let mut t = 0.5 * (low + high);
        for _ in 0..MOST_STEPS {
            let excess = self.excess(t);
            if (excess < 0.0) == starts_inside {
                low = t
            } else {
                high = t
            }
            let slope = self.solid.level(self.ray.over(Interval::point(t))).slope.middle();
            let newton = t - excess / slope;
            let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
            let has_settled = (next - t).abs() <= f64::EPSILON * t.abs() || excess == 0.0;
            if has_settled {
                break;
            }
            t = next;
        }
        t
    }

    fn changes_side(&self, range: Interval) -> bool {
        (self.excess(range.lo()) < 0.0) != (self.excess(range.hi()) < 0.0)
    }
}

/// What is known of the crossings within a range.
enum Verdict {
    /// There are none.
    Apart,
    /// There is at most one.
    Monotone,
    /// There may be any number.
    Unknown,
}

impl<S: LevelSet> Iterator for Crossings<'_, S> {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        while let Some(range) = self.left.pop() {
            self.pieces += 1;
            let is_last = range.width() <= self.finest || self.pieces > MOST_PIECES;
            match self.judge(range) {
                Verdict::Apart => {}
                Verdict::Unknown if !is_last => {
                    let [first, second] = range.halves();
                    self.left.extend([second, first]);
                }
                Verdict::Monotone | Verdict::Unknown => {
                    if self.changes_side(range) {
                        return Some(self.refined(range));
                    }
                }
            }
        }
        None
    }
}
