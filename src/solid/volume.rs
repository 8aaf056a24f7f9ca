//! The volume of a solid, between bounds.

use rayon::prelude::*;

use super::primitive::Primitive;
use super::tree::Tree;
use crate::math::{Dual, Interval, SHARE_ROUNDING, left_out, share_below};
use crate::shape::{LevelSet, Solid};

/// Cells judged after which the bounds are left as they are.
const MOST_CELLS: usize = 1_000_000;

/// Share of the mean uncertainty of cells from which a cell is halved.
const LEAST_UNCERTAINTY: f64 = 0.5;

/// A lower and an upper bound on the volume of a solid, no further apart than `tolerance` times
/// the upper one, or as near as a million cells come.
///
/// Cells of which the level's enclosure tells that all or nothing is inside are counted. In the
/// others the level is linear but for a bounded error: the surface is between two planes. The
/// most uncertain are halved.
pub fn volume_bounds<S>(solid: &Tree<Primitive<S>>, tolerance: f64) -> [f64; 2]
where
    S: Solid + LevelSet + Sync,
{
    let [min, max] = solid.bounding_box();
    let extent = max - min;
    let is_empty = extent.iter().any(|&side| !(side > 0.0 && side.is_finite()));
    if is_empty {
        return [0.0, 0.0];
    }
    let whole = [0, 1, 2].map(|i| Interval::new(min[i], max[i]));
    let mut open = vec![Cell::judged(solid, whole)];
    let (mut settled, mut judged) = (0.0, 1);
    loop {
        let inside: f64 = settled + open.iter().map(|cell| cell.bounds[0]).sum::<f64>();
        let unknown: f64 = open.iter().map(Cell::uncertainty).sum();
        if unknown <= tolerance * (inside + unknown) || judged >= MOST_CELLS {
            return [inside, inside + unknown];
        }
        let least = LEAST_UNCERTAINTY * unknown / open.len() as f64;
        let (halved, kept): (Vec<Cell>, Vec<Cell>) =
            open.into_iter().partition(|cell| cell.uncertainty() >= least);
        judged += 2 * halved.len();
        let halves = halved.par_iter().flat_map_iter(|cell| cell.halves(solid));
        let halves: Vec<Cell> = halves.collect();
        let (certain, uncertain): (Vec<Cell>, Vec<Cell>) =
            halves.into_iter().partition(|cell| cell.uncertainty() == 0.0);
        settled += certain.iter().map(|cell| cell.bounds[0]).sum::<f64>();
        open = kept;
        open.extend(uncertain);
    }
}

/// A box, and bounds on the volume that is inside.
#[derive(Debug, Clone, Copy)]
struct Cell {
    sides: [Interval; 3],
    bounds: [f64; 2],
    /// The side that most of the uncertainty is due to.
    worst: usize,
}

impl Cell {
    fn judged(solid: &impl LevelSet, sides: [Interval; 3]) -> Self {
        let volume: f64 = sides.iter().map(|side| side.width()).product();
        let level = solid.level(sides);
        let longest =
            (1..3).fold(0, |a, b| if sides[b].width() > sides[a].width() { b } else { a });
        let all = |bounds| Self { sides, bounds, worst: longest };
        if level.hi() < 1.0 {
            return all([volume; 2]);
        }
        if level.lo() > 1.0 {
            return all([0.0; 2]);
        }
        let Some((shares, worst)) = between_planes(solid, &sides) else {
            return all([0.0, volume]);
        };
        Self { sides, bounds: shares.map(|share| share * volume), worst }
    }

    fn uncertainty(&self) -> f64 {
        self.bounds[1] - self.bounds[0]
    }

    fn halves(&self, solid: &impl LevelSet) -> [Self; 2] {
        self.sides[self.worst].halves().map(|half| {
            let mut sides = self.sides;
            sides[self.worst] = half;
            Self::judged(solid, sides)
        })
    }
}

/// Bounds on the share of a box that is inside, by the mean value theorem from its middle, and
/// the side that most of the error is due to; nothing, if slopes have no bound.
fn between_planes(solid: &impl LevelSet, sides: &[Interval; 3]) -> Option<([f64; 2], usize)> {
    let middle = solid.level(sides.map(|side| Interval::point(side.middle())));
    let half = sides.map(|side| 0.5 * side.width());
    let slopes = [0, 1, 2].map(|axis| solid.level(Dual::along(axis, *sides)).slope);
    let change: [f64; 3] = std::array::from_fn(|i| slopes[i].middle() * half[i]);
    let spread: [f64; 3] = std::array::from_fn(|i| 0.5 * slopes[i].width() * half[i]);
    let error = spread.iter().sum::<f64>() + middle.width() + left_out(&change);
    let is_known = error.is_finite() && change.iter().all(|part| part.is_finite());
    if !is_known {
        return None;
    }
    let level = 1.0 - middle.middle();
    let error = error * (1.0 + 1e-9) + 1e-13 * (1.0 + level.abs());
    let least = (share_below(&change, level - error) - SHARE_ROUNDING).max(0.0);
    let most = (share_below(&change, level + error) + SHARE_ROUNDING).min(1.0);
    // Beyond both planes nothing is rounded.
    let reach: f64 = change.iter().map(|part| part.abs()).sum();
    let least = if level - error >= reach { 1.0 } else { least };
    let most = if level + error <= -reach { 0.0 } else { most };
    let worst = (1..3).fold(0, |a, b| if spread[b] > spread[a] { b } else { a });
    Some(([least, most], worst))
}
