//! What a pass sums up: the Gram matrix of residual and Jacobian columns, `[r J]' [r J]`, all
//! that Levenberg-Marquardt needs to know of the rows; and the squared geometric distances.

use crate::machine::{Products, TILE};
use crate::math::lane_sum;
use crate::recover::radial::PARAMETERS;

/// Rows evaluated at a time: their columns stay in the first-level cache.
pub(super) const BLOCK: usize = 64;

/// Columns: the residual, then its derivatives.
pub(crate) const COLUMNS: usize = PARAMETERS + 1;

/// A block of rows, stored by column.
pub(super) struct Rows {
    /// The residual and its derivatives.
    pub columns: Columns,
    /// The squared radial distance.
    pub radial_squares: [f64; BLOCK],
    /// The squared first-order geometric distance.
    pub geometric_squares: [f64; BLOCK],
}

pub(super) type Columns = [[f64; BLOCK]; COLUMNS];

impl Rows {
    pub fn new() -> Self {
        let zero = [0.0; BLOCK];
        Self { columns: [zero; COLUMNS], radial_squares: zero, geometric_squares: zero }
    }

    /// Multiplies each of the first rows by its factor.
    #[inline(always)]
    pub fn multiply(&mut self, factors: &[f64]) {
        for column in self.columns.iter_mut() {
            column.iter_mut().zip(factors).for_each(|(entry, factor)| *entry *= factor);
        }
        for squares in [&mut self.radial_squares, &mut self.geometric_squares] {
            squares.iter_mut().zip(factors).for_each(|(square, factor)| *square *= factor * factor);
        }
    }
}

/// `[r J]' [r J]` over some rows, and what else is summed over them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Gram {
    /// The matrix: symmetric, upper triangle in use.
    pub matrix: [[f64; COLUMNS]; COLUMNS],
    /// Sum of squared radial distances.
    pub radial_squares: f64,
    /// Sum of squared first-order geometric distances.
    pub geometric_squares: f64,
    /// What evidence besides the points adds to that sum.
    pub evidence_squares: f64,
}

impl Gram {
    /// That of no rows.
    pub fn zero() -> Self {
        Self {
            matrix: [[0.0; COLUMNS]; COLUMNS],
            radial_squares: 0.0,
            geometric_squares: 0.0,
            evidence_squares: 0.0,
        }
    }

    /// Adds the Gram matrix of other rows.
    pub fn add(&mut self, other: &Self) {
        for (row, other_row) in self.matrix.iter_mut().zip(&other.matrix) {
            for (entry, other_entry) in row.iter_mut().zip(other_row) {
                *entry += other_entry;
            }
        }
        self.radial_squares += other.radial_squares;
        self.geometric_squares += other.geometric_squares;
        self.evidence_squares += other.evidence_squares;
    }

    /// Sum of squared residuals.
    pub fn residual_squares(&self) -> f64 {
        self.matrix[0][0]
    }

    /// Sum of squared geometric distances, with what evidence adds: by this models are ranked.
    pub fn loss_squares(&self) -> f64 {
        self.geometric_squares + self.evidence_squares
    }

    /// Adds the Gram matrix of other rows that are evidence.
    pub fn add_evidence(&mut self, other: &Self) {
        let Self { radial_squares, geometric_squares, .. } = *self;
        self.add(other);
        self.evidence_squares += other.residual_squares();
        (self.radial_squares, self.geometric_squares) = (radial_squares, geometric_squares);
    }

    /// Adds a row that is evidence.
    pub fn add_row(&mut self, residual: f64, gradient: &[f64; PARAMETERS]) {
        self.matrix[0][0] += residual * residual;
        self.evidence_squares += residual * residual;
        for (entry, slope) in self.matrix[0][1..].iter_mut().zip(gradient) {
            *entry += residual * slope;
        }
        self.add_curvature(gradient);
    }

    /// Adds the product of a gradient with itself to `J'J`.
    pub fn add_curvature(&mut self, gradient: &[f64; PARAMETERS]) {
        for i in 0..PARAMETERS {
            for j in i..PARAMETERS {
                self.matrix[i + 1][j + 1] += gradient[i] * gradient[j];
            }
        }
    }

    /// Multiplies each residual by the root of a factor that depends on the parameters, given its
    /// logarithm's derivatives: `r -> f^(1/2) r`, `J -> f^(1/2) (J + r grad (ln f) / 2)`.
    pub fn multiply_cost(&mut self, factor: f64, log_gradient: &[f64; PARAMETERS]) {
        let [first, ..] = self.matrix;
        let half = log_gradient.map(|slope| 0.5 * slope);
        for (i, half_i) in half.iter().enumerate() {
            for (j, half_j) in half.iter().enumerate().skip(i) {
                self.matrix[i + 1][j + 1] +=
                    first[i + 1] * half_j + first[j + 1] * half_i + first[0] * half_i * half_j;
            }
            self.matrix[0][i + 1] += first[0] * half_i;
        }
        self.matrix.iter_mut().flatten().for_each(|entry| *entry *= factor);
    }

    /// Adds the rows of a block, tile by tile.
    #[inline(always)]
    pub(super) fn add_block<P: Products>(&mut self, rows: &Rows) {
        for row in (0..COLUMNS).step_by(TILE) {
            for column in (row..COLUMNS).step_by(TILE) {
                let sums = P::tile(&rows.columns, row, column);
                for (entries, sums) in self.matrix[row..].iter_mut().zip(sums) {
                    for (entry, sum) in entries[column..].iter_mut().zip(sums) {
                        *entry += sum;
                    }
                }
            }
        }
        self.radial_squares += lane_sum(&rows.radial_squares);
        self.geometric_squares += lane_sum(&rows.geometric_squares);
    }
}
