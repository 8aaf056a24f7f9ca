//! The rows of a block of points, by columns: the arithmetic of [`radial_row`] in short loops
//! over scratch columns, each of which the compiler turns into vector code.
//!
//! [`radial_row`]: crate::recover::radial::radial_row

use super::elementary::{exp, ln, mul_add};
use super::gram::{BLOCK, COLUMNS, Rows};
use super::view::ModelView;
use crate::shape::{LOG_FLOOR, TINY};

type Column = [f64; BLOCK];

/// Columns of intermediate values, in the order in which they come about. The equatorial pair
/// is `|x|/a1, |y|/a2`; its norm against `|z|/a3` is the meridional pair.
pub(super) struct Scratch {
    /// The points in the model's frame.
    x: [Column; 3],
    /// The greater of the equatorial pair.
    equator: Column,
    /// `|z| / a3`.
    axial: Column,
    /// First least over greatest of the pair, then the logarithm of that ratio's power.
    equator_log_power: Column,
    /// That power.
    equator_power: Column,
    /// Logarithm of one plus that power.
    equator_log_sum: Column,
    /// First the equatorial norm over the axial magnitude, then its logarithm.
    meridian_log_ratio: Column,
    /// The greatest of the three magnitudes on the side, equatorial or axial, that is greater.
    greatest: Column,
    /// Logarithm of that side's norm over its greatest magnitude.
    greatest_log_norm: Column,
    /// Logarithm of that ratio's (or its reciprocal's) power.
    meridian_log_power: Column,
    /// That power.
    meridian_power: Column,
    /// Logarithm of one plus that power.
    meridian_log_sum: Column,
    /// One over the gauge.
    inverse_gauge: Column,
}

impl Scratch {
    pub(super) fn new() -> Self {
        let zero = [0.0; BLOCK];
        Self {
            x: [zero; 3],
            equator: zero,
            axial: zero,
            equator_log_power: zero,
            equator_power: zero,
            equator_log_sum: zero,
            meridian_log_ratio: zero,
            greatest: zero,
            greatest_log_norm: zero,
            meridian_log_power: zero,
            meridian_power: zero,
            meridian_log_sum: zero,
            inverse_gauge: zero,
        }
    }
}

/// Writes the rows of at most [`BLOCK`] points; those beyond them are zero.
#[inline(always)]
pub(super) fn write_rows<const FMA: bool>(
    view: &ModelView,
    points: [&[f64]; 3],
    scratch: &mut Scratch,
    rows: &mut Rows,
) {
    place(view, points, scratch);
    equatorial_powers::<FMA>(view, scratch);
    meridional_ratios::<FMA>(view, scratch);
    meridional_sides(view, scratch);
    meridional_powers::<FMA>(view, scratch);
    assemble(view, scratch, rows);
    let count = points[0].len();
    if count < BLOCK {
        for column in rows.columns.iter_mut() {
            column[count..].fill(0.0);
        }
        rows.geometric_squares[count..].fill(0.0);
    }
}

/// The greater of two numbers that are not NaN: one instruction, where `f64::max` takes three.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Points in the model's frame, and the ratios whose logarithms are wanted.
#[inline(always)]
fn place(view: &ModelView, points: [&[f64]; 3], scratch: &mut Scratch) {
    let [px, py, pz] = padded(points);
    let [ia, ib, ic] = view.inverse_size;
    for i in 0..BLOCK {
        let [x, y, z] = view.model_from_cloud([px[i], py[i], pz[i]]);
        scratch.x[0][i] = x;
        scratch.x[1][i] = y;
        scratch.x[2][i] = z;
        let u = greater(x.abs() * ia, TINY);
        let v = greater(y.abs() * ib, TINY);
        let w = greater(z.abs() * ic, TINY);
        let equator = greater(u, v);
        scratch.equator[i] = equator;
        scratch.axial[i] = w;
        scratch.equator_log_power[i] = if u > v { v / u } else { u / v };
        scratch.meridian_log_ratio[i] = equator / w;
    }
}

/// The points' coordinates in whole blocks; the model's own surroundings do not matter to
/// the padding, whose rows are discarded.
#[inline(always)]
fn padded(points: [&[f64]; 3]) -> [Column; 3] {
    points.map(|coordinate| {
        let mut column = [0.0; BLOCK];
        column[..coordinate.len()].copy_from_slice(coordinate);
        column
    })
}

#[inline(always)]
fn equatorial_powers<const FMA: bool>(view: &ModelView, scratch: &mut Scratch) {
    let power = 2.0 / view.exponents[1];
    for i in 0..BLOCK {
        let log_power = greater(power * ln::<FMA>(scratch.equator_log_power[i]), LOG_FLOOR);
        scratch.equator_log_power[i] = log_power;
        scratch.equator_power[i] = exp::<FMA>(log_power);
    }
}

#[inline(always)]
fn meridional_ratios<const FMA: bool>(view: &ModelView, scratch: &mut Scratch) {
    let [e1, e2] = view.exponents;
    for i in 0..BLOCK {
        let log_sum = ln::<FMA>(1.0 + scratch.equator_power[i]);
        let log_ratio = mul_add::<FMA>(0.5 * e2, log_sum, ln::<FMA>(scratch.meridian_log_ratio[i]));
        scratch.equator_log_sum[i] = log_sum;
        scratch.meridian_log_ratio[i] = log_ratio;
        scratch.meridian_log_power[i] = greater(-2.0 / e1 * log_ratio.abs(), LOG_FLOOR);
    }
}

/// Which side of the meridional pair is the greater, and by what its norm is made.
#[inline(always)]
fn meridional_sides(view: &ModelView, scratch: &mut Scratch) {
    let half_e2 = 0.5 * view.exponents[1];
    for i in 0..BLOCK {
        let equatorial = scratch.meridian_log_ratio[i] >= 0.0;
        let (equator, axial) = (scratch.equator[i], scratch.axial[i]);
        let log_norm = half_e2 * scratch.equator_log_sum[i];
        scratch.greatest[i] = if equatorial { equator } else { axial };
        scratch.greatest_log_norm[i] = if equatorial { log_norm } else { 0.0 };
    }
}

#[inline(always)]
fn meridional_powers<const FMA: bool>(view: &ModelView, scratch: &mut Scratch) {
    let e1 = view.exponents[0];
    for i in 0..BLOCK {
        let power = exp::<FMA>(scratch.meridian_log_power[i]);
        let log_sum = ln::<FMA>(1.0 + power);
        scratch.meridian_power[i] = power;
        scratch.meridian_log_sum[i] = log_sum;
        let log_norm = mul_add::<FMA>(0.5 * e1, log_sum, scratch.greatest_log_norm[i]);
        scratch.inverse_gauge[i] = exp::<FMA>(-log_norm) / scratch.greatest[i];
    }
}

/// The residual and its derivatives, from what the loops before have left.
#[inline(always)]
fn assemble(view: &ModelView, scratch: &Scratch, rows: &mut Rows) {
    let [a, b, c] = view.size;
    let [ia, ib, _] = view.inverse_size;
    for i in 0..BLOCK {
        let [x, y, z] = [scratch.x[0][i], scratch.x[1][i], scratch.x[2][i]];
        let mx = greater(x.abs(), TINY * a);
        let my = greater(y.abs(), TINY * b);
        let mz = greater(z.abs(), TINY * c);

        let equator_greatest = 1.0 / (1.0 + scratch.equator_power[i]);
        let equator_least = scratch.equator_power[i] * equator_greatest;
        let meridian_greatest = 1.0 / (1.0 + scratch.meridian_power[i]);
        let meridian_least = scratch.meridian_power[i] * meridian_greatest;
        let x_is_greatest = mx * ia > my * ib;
        let share_x = if x_is_greatest { equator_greatest } else { equator_least };
        let share_y = if x_is_greatest { equator_least } else { equator_greatest };
        let equatorial = scratch.meridian_log_ratio[i] >= 0.0;
        let share_xy = if equatorial { meridian_greatest } else { meridian_least };
        let wz = if equatorial { meridian_least } else { meridian_greatest };
        let wx = share_xy * share_x;
        let wy = share_xy * share_y;
        let s1 = scratch.meridian_log_sum[i] - meridian_least * scratch.meridian_log_power[i];
        let s2 = scratch.equator_log_sum[i] - equator_least * scratch.equator_log_power[i];

        let radius = (mx * mx + my * my + mz * mz).sqrt();
        let surface = radius * scratch.inverse_gauge[i];
        let stretch = (1.0 - scratch.inverse_gauge[i]) / radius;
        let nx = x * (stretch + surface * wx / (mx * mx));
        let ny = y * (stretch + surface * wy / (my * my));
        let nz = z * (stretch + surface * wz / (mz * mz));

        let distance = radius - surface;
        // The derivative along the ray is one, so the gradient is no shorter.
        rows.geometric_squares[i] = distance * distance / (nx * nx + ny * ny + nz * nz);
        let row: [f64; COLUMNS] = [
            distance,
            -surface * wx,
            -surface * wy,
            -surface * wz,
            0.5 * surface * s1,
            0.5 * surface * share_xy * s2,
            ny * z - nz * y,
            nz * x - nx * z,
            nx * y - ny * x,
            -nx,
            -ny,
            -nz,
        ];
        for (column, value) in rows.columns.iter_mut().zip(row) {
            column[i] = value;
        }
    }
}
