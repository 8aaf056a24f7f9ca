//! How far a deformed shape reaches, with a guarantee.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use nalgebra::Vector3;

use super::Deformed;
use super::region::Region;
use crate::deform::map::Deform;
use crate::math::{Dual, Interval, Scalar};
use crate::shape::{LevelSet, Solid};

/// Share of the reach from the shape's middle by which a bound may be too large.
const TOLERANCE: f64 = 1e-3;

/// Most boxes that are cut for one direction.
const MOST_BOXES: usize = 10_000;

impl<S: Solid + LevelSet> Deformed<S> {
    /// A bound on `n . X` over the solid, no less than the greatest value and, as a rule, by no
    /// more than a thousandth of the solid's size above it; in the unit of length times that of
    /// `n`.
    ///
    /// By branch and bound over boxes of the undeformed surface: no point inside a solid is its
    /// furthest.
    pub fn support(&self, n: &Vector3<f64>) -> f64 {
        if self.chain.stages().is_empty() {
            return self.shape.support(n);
        }
        let whole = Region::around(&self.shape);
        let middle = self.along(n, whole.middle().into());
        let mut reached = f64::NEG_INFINITY;
        let mut heap = BinaryHeap::from([self.bounded(n, whole)]);
        for _ in 0..MOST_BOXES {
            let Some(furthest) = heap.peek() else { return reached };
            let tolerance = TOLERANCE * (reached - middle).abs();
            if reached.is_finite() && furthest.bound - reached <= tolerance {
                break;
            }
            let Some(Candidate { region, .. }) = heap.pop() else { return reached };
            for half in region.halves() {
                let level = self.shape.level(half.sides());
                if level.contains(1.0) {
                    reached = reached.max(self.reach(n, &half));
                    heap.push(self.bounded(n, half));
                }
            }
        }
        heap.peek().map_or(reached, |furthest| furthest.bound.max(reached))
    }

    /// A box along the axes that holds the solid, `[min, max]`: as tight as
    /// [`support`](Self::support).
    pub fn bounding_box(&self) -> [Vector3<f64>; 2] {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        [
            Vector3::from(axes.map(|axis| -self.support(&-axis))),
            Vector3::from(axes.map(|axis| self.support(&axis))),
        ]
    }

    /// How far the middle of a box reaches, if it is inside.
    fn reach(&self, n: &Vector3<f64>, region: &Region) -> f64 {
        let x: [f64; 3] = region.middle().into();
        if self.shape.level(x) <= 1.0 { self.along(n, x) } else { f64::NEG_INFINITY }
    }

    fn bounded(&self, n: &Vector3<f64>, region: Region) -> Candidate {
        let natural = self.along(n, region.sides()).hi();
        Candidate { bound: natural.min(self.bound_of_the_inside(n, &region)), region }
    }

    /// The greatest value of `f = n . F` where the level is at most 1, by the mean value theorem.
    ///
    /// With G and g the slopes of f and of the level over the box, c its middle and any
    /// multiplier m not below 0, `f(x) <= f(c) + (G - m g) . (x - c) + m (1 - level(c))`. Where
    /// f is greatest, the two gradients are parallel: the bound is then of second order.
    fn bound_of_the_inside(&self, n: &Vector3<f64>, region: &Region) -> f64 {
        let middle: [f64; 3] = region.middle().into();
        let point = middle.map(Interval::point);
        let level = |x| self.shape.level(x);
        let [ahead, outwards] =
            [slopes(region.sides(), |x| self.along(n, x)), slopes(region.sides(), level)];
        let offsets: [Interval; 3] = std::array::from_fn(|i| region.sides()[i] + -middle[i]);
        let multiplier = multiplier(&ahead, &outwards, &offsets);
        let above = (-self.shape.level(point) + 1.0) * multiplier;
        let rise = (0..3).map(|i| (ahead[i] - outwards[i] * multiplier) * offsets[i]);
        rise.fold(self.along(n, point) + above, |sum, part| sum + part).hi()
    }

    /// `n . F(x)`.
    fn along<T: Scalar>(&self, n: &Vector3<f64>, x: [T; 3]) -> T {
        let [x, y, z] = self.chain.forward_of(x);
        x * n.x + y * n.y + z * n.z
    }
}

/// The slopes of a function along the three axes, over a box.
fn slopes(sides: [Interval; 3], function: impl Fn([Dual; 3]) -> Dual) -> [Interval; 3] {
    std::array::from_fn(|axis| function(Dual::along(axis, sides)).slope)
}

/// The multiplier that leaves least of the slopes `ahead` when so much of those `outwards` is
/// taken from them, each axis counting by the box's side.
fn multiplier(ahead: &[Interval; 3], outwards: &[Interval; 3], offsets: &[Interval; 3]) -> f64 {
    let weighed =
        |slopes: &[Interval; 3]| Vector3::from_fn(|i, _| slopes[i].middle() * offsets[i].width());
    let (ahead, outwards) = (weighed(ahead), weighed(outwards));
    let multiplier = ahead.dot(&outwards) / outwards.norm_squared();
    if multiplier.is_finite() { multiplier.max(0.0) } else { 0.0 }
}

/// A box, and how far it may reach.
struct Candidate {
    bound: f64,
    region: Region,
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bound.total_cmp(&other.bound)
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Candidate {}
