//! The space around a solid in cells that tell where its surface may be.

use std::sync::OnceLock;

use nalgebra::Vector3;

use crate::math::{Dual, Interval};
use crate::shape::LevelSet;

/// Halvings of the cage's sides after which cells are cut no more.
const MOST_HALVINGS: u32 = 8;

/// Share of a level's change across a cell by which it may differ from a linear function there,
/// for the cell to be cut no more.
const FLATNESS: f64 = 0.2;

/// Share of the cage's sides by which cells reach beyond their sides: points that rounding
/// takes out of them.
const MARGIN: f64 = 1e-9;

/// A box that is cut into eight cells, these into eight and so on, where its solid's surface is.
///
/// A cell is judged when it is first asked for, so that only what rays come by is ever cut.
#[derive(Debug, Clone)]
pub(super) struct Cage {
    extent: Extent,
    margin: Vector3<f64>,
    root: Cell,
}

/// A cell that may not have been judged yet.
#[derive(Debug, Clone, Default)]
pub(super) struct Cell(OnceLock<Content>);

/// What is known of a cell.
#[derive(Debug, Clone)]
pub(super) enum Content {
    /// The surface is not in it.
    Apart,
    /// The surface may be in it, and the level is about linear.
    Surface(Box<Tangent>),
    /// The surface may be in it: its eight parts tell more.
    Cut(Box<[Cell; 8]>),
}

/// A linear function that a level differs from by a bounded error throughout a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tangent {
    /// The level less 1 in the cell's middle.
    pub excess: f64,
    /// The slopes of the linear function.
    pub gradient: Vector3<f64>,
    /// By how much the level's own slopes may differ from them.
    pub spread: Vector3<f64>,
    /// By how much the level may differ from the function.
    pub error: f64,
}

/// Where a cell is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    pub middle: Vector3<f64>,
    pub half: Vector3<f64>,
    halvings: u32,
}

impl Extent {
    /// That of one of the eight parts: bit i of its number tells the half along axis i.
    pub fn part(&self, number: usize) -> Self {
        let half = 0.5 * self.half;
        let towards = |axis: usize| if number >> axis & 1 == 0 { -half[axis] } else { half[axis] };
        let middle = Vector3::from_fn(|axis, _| self.middle[axis] + towards(axis));
        Self { middle, half, halvings: self.halvings + 1 }
    }
}

impl Cage {
    /// The cage of a box `[min, max]`.
    pub fn new([min, max]: &[Vector3<f64>; 2]) -> Self {
        let extent = Extent { middle: 0.5 * (min + max), half: 0.5 * (max - min), halvings: 0 };
        Self { extent, margin: MARGIN * extent.half, root: Cell::default() }
    }

    /// The outermost cell, and where it is.
    pub fn root(&self) -> (&Cell, Extent) {
        (&self.root, self.extent)
    }

    /// What is known of a cell of a solid's space.
    pub fn content<'a>(
        &self,
        cell: &'a Cell,
        extent: &Extent,
        solid: &impl LevelSet,
    ) -> &'a Content {
        cell.0.get_or_init(|| self.judged(extent, solid))
    }

    fn judged(&self, extent: &Extent, solid: &impl LevelSet) -> Content {
        let half = extent.half + self.margin;
        let sides: [Interval; 3] = std::array::from_fn(|i| {
            Interval::new(extent.middle[i] - half[i], extent.middle[i] + half[i])
        });
        if !solid.level(sides).contains(1.0) {
            return Content::Apart;
        }
        let tangent = Tangent::over(solid, extent.middle, half, sides);
        let change = tangent.gradient.abs().dot(&half);
        if tangent.excess.abs() > change + tangent.error {
            Content::Apart
        } else if tangent.error <= FLATNESS * change || extent.halvings == MOST_HALVINGS {
            Content::Surface(Box::new(tangent))
        } else {
            Content::Cut(Box::default())
        }
    }
}

impl Tangent {
    /// The level over a box, by the mean value theorem from its middle.
    fn over(
        solid: &impl LevelSet,
        middle: Vector3<f64>,
        half: Vector3<f64>,
        sides: [Interval; 3],
    ) -> Self {
        let slopes = [0, 1, 2].map(|axis| solid.level(Dual::along(axis, sides)).slope);
        let excess = solid.level([middle.x, middle.y, middle.z].map(Interval::point)) + -1.0;
        let gradient = Vector3::from(slopes.map(Interval::middle));
        let spread = Vector3::from_fn(|i, _| {
            (slopes[i].hi() - gradient[i]).max(gradient[i] - slopes[i].lo()).next_up()
        });
        // The sums are rounded, too.
        let rounding = 1e-13 * (1.0 + excess.middle().abs() + gradient.abs().dot(&half));
        let error = spread.dot(&half) + excess.width() + rounding;
        // Slopes without bound tell nothing.
        let is_known = error.is_finite() && gradient.iter().all(|slope| slope.is_finite());
        if is_known {
            Self { excess: excess.middle(), gradient, spread, error }
        } else {
            let unbounded = Vector3::from_element(f64::INFINITY);
            let gradient = Vector3::zeros();
            Self { excess: 0.0, gradient, spread: unbounded, error: f64::INFINITY }
        }
    }
}
