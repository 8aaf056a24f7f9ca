//! The volume of a solid, between bounds.

use rayon::prelude::*;

use super::primitive::Primitive;
use super::tree::Tree;
use crate::math::Interval;
use crate::shape::{LevelSet, Solid};

/// Halvings of the bounding box after which the bounds are left as they are: cells are then a
/// 512th of each side.
const MOST_HALVINGS: u32 = 27;

/// A lower and an upper bound on the volume of a solid, no further apart than `tolerance` times
/// the upper one, or as near as cells of a 512th of the bounding box come: one or two per cent.
///
/// Boxes of which the level's enclosure tells that all or nothing is inside are counted, all
/// others halved.
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
    let mut open = vec![[0, 1, 2].map(|i| Interval::new(min[i], max[i]))];
    let mut inside = 0.0;
    for halving in 0..=MOST_HALVINGS {
        let judged: Vec<Verdict> = open.par_iter().map(|cell| judge(solid, cell)).collect();
        inside += sum_of(&open, &judged, Verdict::Inside);
        let unknown = sum_of(&open, &judged, Verdict::Boundary);
        if unknown <= tolerance * (inside + unknown) || halving == MOST_HALVINGS {
            return [inside, inside + unknown];
        }
        let boundary =
            open.iter().zip(&judged).filter(|(_, verdict)| **verdict == Verdict::Boundary);
        open = boundary.flat_map(|(cell, _)| halves(cell)).collect();
    }
    [inside, inside]
}

/// What an enclosure tells of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Verdict {
    Inside,
    Outside,
    Boundary,
}

fn judge(solid: &impl LevelSet, cell: &[Interval; 3]) -> Verdict {
    let level = solid.level(*cell);
    if level.hi() < 1.0 {
        Verdict::Inside
    } else if level.lo() > 1.0 {
        Verdict::Outside
    } else {
        Verdict::Boundary
    }
}

fn sum_of(cells: &[[Interval; 3]], judged: &[Verdict], verdict: Verdict) -> f64 {
    let chosen = cells.iter().zip(judged).filter(|(_, found)| **found == verdict);
    chosen.map(|(cell, _)| cell.iter().map(|side| side.width()).product::<f64>()).sum()
}

/// Two halves, across the longest side.
fn halves(cell: &[Interval; 3]) -> [[Interval; 3]; 2] {
    let longest = (1..3).fold(0, |a, b| if cell[b].width() > cell[a].width() { b } else { a });
    cell[longest].halves().map(|half| {
        let mut halved = *cell;
        halved[longest] = half;
        halved
    })
}
