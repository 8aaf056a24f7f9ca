//! A ray's way through the cells around a solid.

use super::along::Along;
use super::cage::{Cage, Cell, Content, Extent, Tangent};
use super::half_line::Ray;
use super::hits::Crossings;
use crate::shape::LevelSet;

/// Share of its distance by which a point of a ray may be off.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The crossings of level 1 along a stretch of a ray, in ascending order; as they are asked for.
///
/// Cells without surface are passed. In the others the level is linear but for a bounded error:
/// that leaves a short stretch of the ray, within which it ascends or descends as a rule; else
/// the stretch is searched as [`Crossings`] does.
#[derive(Debug)]
pub(super) struct Walk<'a, S> {
    along: Along<'a, S>,
    cage: &'a Cage,
    /// Bits that turn the order of a cell's parts into that along the ray.
    order: usize,
    /// Cells ahead, the nearest at the end.
    ahead: Vec<Visit<'a>>,
    /// What is left of a cell that does not tell enough.
    searched: Option<Crossings<'a, S>>,
}

/// A cell, and where along the ray.
#[derive(Debug, Clone, Copy)]
struct Visit<'a> {
    cell: &'a Cell,
    extent: Extent,
    range: [f64; 2],
}

/// What of a stretch of a ray may cross the surface.
struct Stretch {
    range: [f64; 2],
    /// Whether the ends are inside, as far as the linear function tells.
    insides: [Option<bool>; 2],
    /// Where the linear function crosses, if the level ascends or descends throughout.
    expected: Option<f64>,
}

impl<'a, S: LevelSet> Walk<'a, S> {
    /// The crossings of a ray within a range, which lies in the solid's cage.
    pub fn new(solid: &'a S, cage: &'a Cage, ray: Ray, range: [f64; 2]) -> Self {
        let order = (0..3).filter(|&i| ray.direction[i] < 0.0).fold(0, |bits, i| bits | 1 << i);
        let (cell, extent) = cage.root();
        let ahead = vec![Visit { cell, extent, range }];
        Self { along: Along { solid, ray }, cage, order, ahead, searched: None }
    }

    /// Whether the ray's point at t is inside.
    pub fn is_inside(&self, t: f64) -> bool {
        self.along.is_inside(t)
    }

    /// Puts the parts of a cell that the ray passes ahead, the last first.
    fn enter(&mut self, parts: &'a [Cell; 8], Visit { extent, range, .. }: Visit<'a>) {
        let ray = &self.along.ray;
        let middles: [f64; 3] = std::array::from_fn(|i| {
            let way = extent.middle[i] - ray.origin[i];
            // Along a middle plane it is in the first part.
            if ray.direction[i] == 0.0 {
                if way < 0.0 { f64::NEG_INFINITY } else { f64::INFINITY }
            } else {
                way / ray.direction[i]
            }
        });
        for place in (0..8).rev() {
            let mut within = range;
            for (axis, middle) in middles.into_iter().enumerate() {
                if place >> axis & 1 == 0 {
                    within[1] = within[1].min(middle);
                } else {
                    within[0] = within[0].max(middle);
                }
            }
            if within[0] < within[1] {
                let number = place ^ self.order;
                let (cell, extent) = (&parts[number], extent.part(number));
                self.ahead.push(Visit { cell, extent, range: within });
            }
        }
    }

    /// The crossing within a cell, if there is at most one; else a search begins.
    fn crossing(&mut self, tangent: &Tangent, visit: &Visit<'a>) -> Option<f64> {
        let Stretch { range, insides, expected } = stretch(tangent, visit, &self.along.ray)?;
        let Some(expected) = expected else {
            self.searched = Some(Crossings::new(self.along.solid, self.along.ray, range));
            return None;
        };
        let told = |end: usize| insides[end].unwrap_or_else(|| self.along.is_inside(range[end]));
        let [starts_inside, ends_inside] = [told(0), told(1)];
        (starts_inside != ends_inside).then(|| {
            self.along.crossing(range, starts_inside, expected.clamp(range[0], range[1]))
        })
    }
}

impl<S: LevelSet> Iterator for Walk<'_, S> {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        loop {
            if let Some(found) = self.searched.as_mut().and_then(Iterator::next) {
                return Some(found);
            }
            self.searched = None;
            let visit = self.ahead.pop()?;
            match self.cage.content(visit.cell, &visit.extent, self.along.solid) {
                Content::Apart => {}
                Content::Cut(parts) => self.enter(parts, visit),
                Content::Surface(tangent) => {
                    let crossing = self.crossing(tangent, &visit);
                    if crossing.is_some() {
                        return crossing;
                    }
                }
            }
        }
    }
}

/// What of a cell's stretch may cross the surface; nothing, if it cannot.
fn stretch(tangent: &Tangent, visit: &Visit, ray: &Ray) -> Option<Stretch> {
    let [from, to] = visit.range;
    let slope = tangent.gradient.dot(&ray.direction);
    let start = tangent.excess + tangent.gradient.dot(&(ray.at(from) - visit.extent.middle));
    // Points of the ray are rounded.
    let steepness = tangent.gradient.abs().dot(&ray.direction.abs());
    let error = tangent.error + ROUNDING * to.abs() * steepness;
    let way = [-error - start, error - start].map(|level| level / slope);
    let [nearest, furthest] = [from + way[0].min(way[1]), from + way[0].max(way[1])];
    let is_told = slope != 0.0 && error.is_finite();
    if !is_told {
        return Some(Stretch { range: visit.range, insides: [None; 2], expected: None });
    }
    let range = [from.max(nearest), to.min(furthest)];
    let is_monotone = slope.abs() > tangent.spread.dot(&ray.direction.abs());
    let insides = [
        (nearest > from).then_some(slope > 0.0),
        (furthest < to).then_some(slope < 0.0),
    ];
    let expected = is_monotone.then_some(from - start / slope);
    (range[0] <= range[1]).then_some(Stretch { range, insides, expected })
}
