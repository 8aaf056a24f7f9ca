//! The rows of a block of points, by columns: the arithmetic of [`radial_row`] in short loops
//! over scratch columns, each of which the compiler turns into vector code.
//!
//! [`radial_row`]: crate::recover::radial::radial_row

use super::gram::{BLOCK, Rows};
use super::point::{Point, greater};
use super::view::ModelView;
use crate::math::elementary::{exp, ln, mul_add};
use crate::shape::{LOG_FLOOR, TINY};

type Column = [f64; BLOCK];

/// Columns of intermediate values, in the order in which they come about. The equatorial pair
/// is `|x|/a1, |y|/a2`; its norm against `|z|/a3` is the meridional pair.
pub(super) struct Scratch {
    /// The points in the model's frame.
    pub(super) x: [Column; 3],
    /// The greater of the equatorial pair.
    pub(super) equator: Column,
    /// `|z| / a3`.
    pub(super) axial: Column,
    /// First least over greatest of the pair, then the logarithm of that ratio's power.
    pub(super) equator_log_power: Column,
    /// That power.
    pub(super) equator_power: Column,
    /// Logarithm of one plus that power.
    pub(super) equator_log_sum: Column,
    /// First the equatorial norm over the axial magnitude, then its logarithm.
    pub(super) meridian_log_ratio: Column,
    /// The greatest of the three magnitudes on the side, equatorial or axial, that is greater.
    pub(super) greatest: Column,
    /// Logarithm of that side's norm over its greatest magnitude.
    pub(super) greatest_log_norm: Column,
    /// Logarithm of that ratio's (or its reciprocal's) power.
    pub(super) meridian_log_power: Column,
    /// That power.
    pub(super) meridian_power: Column,
    /// Logarithm of one plus that power.
    pub(super) meridian_log_sum: Column,
    /// One over the gauge.
    pub(super) inverse_gauge: Column,
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
pub(super) fn write_rows<const FMA: bool, const GEOMETRIC: bool>(
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
    assemble::<GEOMETRIC>(view, scratch, rows);
    let count = points[0].len();
    if count < BLOCK {
        for column in rows.columns.iter_mut() {
            column[count..].fill(0.0);
        }
        rows.radial_squares[count..].fill(0.0);
        rows.geometric_squares[count..].fill(0.0);
    }
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

/// The residuals and their derivatives, from what the loops before have left.
#[inline(always)]
fn assemble<const GEOMETRIC: bool>(view: &ModelView, scratch: &Scratch, rows: &mut Rows) {
    for i in 0..BLOCK {
        let point = Point::at(view, scratch, i);
        let radial = point.radial_row();
        let square_stretch = point.square_stretch();
        let radial_square = point.distance * point.distance;
        rows.radial_squares[i] = radial_square;
        rows.geometric_squares[i] = radial_square / square_stretch;
        let row = if GEOMETRIC {
            point.geometric_row(view, scratch, i, &radial, square_stretch)
        } else {
            radial
        };
        for (column, value) in rows.columns.iter_mut().zip(row) {
            column[i] = value;
        }
    }
}
