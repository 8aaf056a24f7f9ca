//! Method 6: the explicit equation by tables of both powers.

use super::Method;
use super::square::{CORNER_SHARE, Square};

/// `z = (1 - t)^(e/2)` looked up by `t = x^(2/e) + y^(2/e)`, whose terms are looked up by x and
/// y: three look-ups and an addition of whole numbers a point, and no function.
///
/// x and y stand at the steps of their table, so that only their powers are rounded, to steps of
/// the table of z. Exponents are equal, as in FB81: else z changes with t too unevenly for a
/// table of even steps.
#[derive(Debug, Clone)]
pub struct PowerTables {
    coordinates: Vec<f64>,
    /// `x_i^(2/e)` in steps of the other table.
    powers: Vec<u32>,
    /// z at every step.
    heights: Box<[f64; Self::ENTRIES + 1]>,
}

impl PowerTables {
    /// Steps of t from 0 to the square's far corner: FB81's number.
    pub const ENTRIES: usize = 1000;

    /// The method for equal exponents `e` above 0 and so many steps.
    pub fn new(e: f64, steps: usize) -> Self {
        let square = Square::new([e, e], steps);
        let step = CORNER_SHARE / Self::ENTRIES as f64;
        let power = |x: &f64| (x.powf(square.inner) / step).round() as u32;
        let height = |entry: usize| (1.0 - step * entry as f64).powf(square.outer);
        Self {
            powers: square.coordinates.iter().map(power).collect(),
            heights: Box::new(std::array::from_fn(height)),
            coordinates: square.coordinates,
        }
    }

    #[inline(always)]
    fn height(&self, power: u32) -> f64 {
        self.heights[(power as usize).min(Self::ENTRIES)]
    }
}

impl Method for PowerTables {
    fn steps(&self) -> usize {
        self.coordinates.len()
    }

    fn point(&self, i: usize, j: usize) -> [f64; 3] {
        let height = self.height(self.powers[i] + self.powers[j]);
        [self.coordinates[i], self.coordinates[j], height]
    }

    #[inline(always)]
    fn row_for<const FMA: bool>(&self, j: usize, [xs, ys, zs]: [&mut [f64]; 3]) {
        let row_power = self.powers[j];
        xs.copy_from_slice(&self.coordinates);
        ys.fill(self.coordinates[j]);
        for (z, power) in zs.iter_mut().zip(&self.powers) {
            *z = self.height(power + row_power);
        }
    }
}
