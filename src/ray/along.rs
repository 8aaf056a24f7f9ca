//! The level of a solid along a ray.

use super::half_line::Ray;
use crate::math::{Dual, Interval};
use crate::shape::LevelSet;

/// Most steps of Newton's method and halvings for one crossing: halving alone comes to rounding
/// within so many.
const MOST_STEPS: usize = 80;

/// Share of t below which a step of Newton's method is the last: the error after it is of the
/// order of its square.
const LAST_STEP: f64 = 1e-11;

/// A solid's level as a function of a ray's t.
#[derive(Debug)]
pub(super) struct Along<'a, S> {
    pub solid: &'a S,
    pub ray: Ray,
}

/// What is known of the crossings within a range.
pub(super) enum Verdict {
    /// There are none.
    Apart,
    /// There is at most one.
    Monotone,
    /// There may be any number.
    Unknown,
}

impl<S: LevelSet> Along<'_, S> {
    /// Whether the point at t is inside.
    pub fn is_inside(&self, t: f64) -> bool {
        let x: [f64; 3] = self.ray.at(t).into();
        self.solid.level(x) < 1.0
    }

    /// What the enclosures over a range tell.
    pub fn judge(&self, range: Interval) -> Verdict {
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

    /// The crossing within a range at whose ends the levels differ in side, from `t` on by
    /// Newton's method where it stays within the bounds, else by halving.
    pub fn crossing(&self, [mut low, mut high]: [f64; 2], starts_inside: bool, mut t: f64) -> f64 {
        for _ in 0..MOST_STEPS {
            let Dual { value, slope } = self.solid.level(self.ray.over(t));
            if value == 1.0 {
                break;
            }
            let is_inside = value < 1.0;
            if is_inside == starts_inside {
                low = t
            } else {
                high = t
            }
            let newton = t - (value - 1.0) / slope;
            let is_within = low < newton && newton < high;
            let next = if is_within { newton } else { 0.5 * (low + high) };
            let share = if is_within { LAST_STEP } else { f64::EPSILON };
            let has_settled = (next - t).abs() <= share * t.abs();
            t = next;
            if has_settled {
                break;
            }
        }
        t
    }
}
