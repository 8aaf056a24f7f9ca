//! The Gram matrix of residual and Jacobian columns, `[r J]' [r J]`: all that
//! Levenberg-Marquardt needs to know of the rows.

use crate::recover::radial::PARAMETERS;

/// Rows evaluated at a time: their columns stay in the first-level cache.
pub(super) const BLOCK: usize = 128;

/// Columns: the residual, then its derivatives.
pub(crate) const COLUMNS: usize = PARAMETERS + 1;

/// Block of rows, stored by column.
pub(super) type Columns = [[f64; BLOCK]; COLUMNS];

/// Columns in one side of a tile: nine sums, which fit the registers with their operands.
pub(super) const TILE: usize = 3;

/// `[r J]' [r J]` over some rows: symmetric, upper triangle in use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Gram(pub [[f64; COLUMNS]; COLUMNS]);

impl Gram {
    /// That of no rows.
    pub fn zero() -> Self {
        Self([[0.0; COLUMNS]; COLUMNS])
    }

    /// Adds the Gram matrix of other rows.
    pub fn add(&mut self, other: &Self) {
        for (row, other_row) in self.0.iter_mut().zip(&other.0) {
            for (entry, other_entry) in row.iter_mut().zip(other_row) {
                *entry += other_entry;
            }
        }
    }

    /// Sum of squared residuals.
    pub fn residual_squares(&self) -> f64 {
        self.0[0][0]
    }

    /// Adds the rows of a block, tile by tile.
    #[inline(always)]
    pub(super) fn add_block<P: TileProducts>(&mut self, columns: &Columns) {
        for row in (0..COLUMNS).step_by(TILE) {
            for column in (row..COLUMNS).step_by(TILE) {
                let sums = P::products(columns, row, column);
                for i in 0..TILE {
                    for j in 0..TILE {
                        self.0[row + i][column + j] += sums[i][j];
                    }
                }
            }
        }
    }
}

/// Products of each of the columns `left..left + TILE` with each of `right..right + TILE`,
/// summed over a block.
///
/// An explicit part of each path, since compilers make good vector code of it only by luck.
pub(super) trait TileProducts {
    fn products(columns: &Columns, left: usize, right: usize) -> [[f64; TILE]; TILE];
}

/// The products in plain Rust, with two partial sums side by side.
pub(super) struct PortableTile;

impl TileProducts for PortableTile {
    #[inline(always)]
    fn products(columns: &Columns, left: usize, right: usize) -> [[f64; TILE]; TILE] {
        let product = |i: usize, j: usize| {
            let [even, odd] = pairs(&columns[left + i])
                .zip(pairs(&columns[right + j]))
                .fold([0.0; 2], |[even, odd], (a, b)| [even + a[0] * b[0], odd + a[1] * b[1]]);
            even + odd
        };
        std::array::from_fn(|i| std::array::from_fn(|j| product(i, j)))
    }
}

fn pairs(column: &[f64; BLOCK]) -> impl Iterator<Item = &[f64; 2]> {
    column.as_chunks::<2>().0.iter()
}
