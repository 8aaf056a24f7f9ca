//! The rows of a block of points, by columns: the arithmetic of [`radial_row`] in short loops
//! over scratch columns, each of which the compiler turns into vector code.
//!
//! A loop holds one logarithm or exponential at most: the processor works on as many points at once as
//! it has room for instructions, and waits for the longest chain among them.
//!
//! [`radial_row`]: crate::recover::radial::radial_row

use super::gram::{BLOCK, Rows};
use super::point::Point;
use super::view::ModelView;
use crate::math::elementary::{exp, ln_1p_and_inverse, ln_ratio, mul_add};
use crate::math::lane::{Lane, greater};

type Column<L> = [L; BLOCK];

/// Columns of intermediate values, in the order in which they come about. The equatorial pair
/// is `|x|/a1, |y|/a2`; its norm against `|z|/a3` is the meridional pair.
pub(super) struct Scratch<L> {
    /// The points in the model's frame.
    pub(super) x: [Column<L>; 3],
    /// The greater of the equatorial pair.
    pub(super) equator: Column<L>,
    /// `|z| / a3`.
    pub(super) axial: Column<L>,
    /// First the lesser of the pair, then the logarithm of the power of its ratio to the greater.
    pub(super) equator_log_power: Column<L>,
    /// That power.
    pub(super) equator_power: Column<L>,
    /// Logarithm of one plus that power.
    pub(super) equator_log_sum: Column<L>,
    /// One over one plus that power.
    pub(super) equator_share: Column<L>,
    /// Logarithm of the equatorial norm over the axial magnitude.
    pub(super) meridian_log_ratio: Column<L>,
    /// The greatest of the three magnitudes on the side, equatorial or axial, that is greater.
    pub(super) greatest: Column<L>,
    /// Logarithm of that side's norm over its greatest magnitude.
    pub(super) greatest_log_norm: Column<L>,
    /// Logarithm of that ratio's (or its reciprocal's) power.
    pub(super) meridian_log_power: Column<L>,
    /// That power.
    pub(super) meridian_power: Column<L>,
    /// Logarithm of one plus that power.
    pub(super) meridian_log_sum: Column<L>,
    /// One over one plus that power.
    pub(super) meridian_share: Column<L>,
    /// One over the gauge.
    pub(super) inverse_gauge: Column<L>,
}

impl<L: Lane> Scratch<L> {
    pub(super) fn new() -> Self {
        let zero = [L::default(); BLOCK];
        Self {
            x: [zero; 3],
            equator: zero,
            axial: zero,
            equator_log_power: zero,
            equator_power: zero,
            equator_log_sum: zero,
            equator_share: zero,
            meridian_log_ratio: zero,
            greatest: zero,
            greatest_log_norm: zero,
            meridian_log_power: zero,
            meridian_power: zero,
            meridian_log_sum: zero,
            meridian_share: zero,
            inverse_gauge: zero,
        }
    }
}

/// Writes the rows of at most [`BLOCK`] points; those beyond them are zero.
#[inline(always)]
pub(super) fn write_rows<L: Lane, const FMA: bool, const GEOMETRIC: bool>(
    view: &ModelView,
    points: [&[f64]; 3],
    scratch: &mut Scratch<L>,
    rows: &mut Rows,
) {
    write_powers::<L, FMA>(view, points, scratch);
    assemble::<L, GEOMETRIC>(view, scratch, rows);
    let count = points[0].len();
    if count < BLOCK {
        for column in rows.columns.iter_mut() {
            column[count..].fill(0.0);
        }
        rows.radial_squares[count..].fill(0.0);
        rows.geometric_squares[count..].fill(0.0);
    }
}

/// Writes the powers and logarithms of at most [`BLOCK`] points, of which rows are made.
#[inline(always)]
pub(super) fn write_powers<L: Lane, const FMA: bool>(
    view: &ModelView,
    points: [&[f64]; 3],
    scratch: &mut Scratch<L>,
) {
    match points.map(<&Column<f64>>::try_from) {
        [Ok(x), Ok(y), Ok(z)] => place(view, [x, y, z], scratch),
        _ => place(view, padded(points).each_ref(), scratch),
    }
    equatorial_powers::<L, FMA>(view, scratch);
    meridional_ratios::<L, FMA>(view, scratch);
    meridional_sides(view, scratch);
    meridional_powers::<L, FMA>(view, scratch);
}

/// Points in the model's frame, and the magnitudes whose ratios are wanted.
#[inline(always)]
fn place<L: Lane>(view: &ModelView, [px, py, pz]: [&Column<f64>; 3], scratch: &mut Scratch<L>) {
    let [ia, ib, ic] = view.inverse_size.map(L::of);
    for i in 0..BLOCK {
        let [x, y, z] = view.model_from_cloud([px[i], py[i], pz[i]]);
        let [x, y, z] = [L::of(x), L::of(y), L::of(z)];
        scratch.x[0][i] = x;
        scratch.x[1][i] = y;
        scratch.x[2][i] = z;
        let u = greater(x.abs() * ia, L::TINY);
        let v = greater(y.abs() * ib, L::TINY);
        let w = greater(z.abs() * ic, L::TINY);
        scratch.equator[i] = if u > v { u } else { v };
        scratch.equator_log_power[i] = if u > v { v } else { u };
        scratch.axial[i] = w;
    }
}

/// The coordinates of the last points in a whole block; the model's own surroundings do not matter to
/// the padding, whose rows are discarded.
#[inline(always)]
fn padded(points: [&[f64]; 3]) -> [Column<f64>; 3] {
    points.map(|coordinate| {
        let mut column = [0.0; BLOCK];
        column[..coordinate.len()].copy_from_slice(coordinate);
        column
    })
}

#[inline(always)]
fn equatorial_powers<L: Lane, const FMA: bool>(view: &ModelView, scratch: &mut Scratch<L>) {
    let power = L::of(2.0 / view.exponents[1]);
    for i in 0..BLOCK {
        let log_ratio = ln_ratio::<FMA, L>(scratch.equator_log_power[i], scratch.equator[i]);
        scratch.equator_log_power[i] = greater(power * log_ratio, L::LOG_FLOOR);
    }
    for i in 0..BLOCK {
        scratch.equator_power[i] = exp::<FMA, L>(scratch.equator_log_power[i]);
    }
}

#[inline(always)]
fn meridional_ratios<L: Lane, const FMA: bool>(view: &ModelView, scratch: &mut Scratch<L>) {
    let [e1, e2] = view.exponents;
    let (half_e2, power) = (L::of(0.5 * e2), L::of(-2.0 / e1));
    for i in 0..BLOCK {
        let (log_sum, share) = ln_1p_and_inverse::<FMA, L>(scratch.equator_power[i]);
        scratch.equator_log_sum[i] = log_sum;
        scratch.equator_share[i] = share;
    }
    for i in 0..BLOCK {
        let log_ratio = ln_ratio::<FMA, L>(scratch.equator[i], scratch.axial[i]);
        let log_ratio = mul_add::<FMA, L>(half_e2, scratch.equator_log_sum[i], log_ratio);
        scratch.meridian_log_ratio[i] = log_ratio;
        scratch.meridian_log_power[i] = greater(power * log_ratio.abs(), L::LOG_FLOOR);
    }
}

/// Which side of the meridional pair is the greater, and by what its norm is made.
#[inline(always)]
fn meridional_sides<L: Lane>(view: &ModelView, scratch: &mut Scratch<L>) {
    let half_e2 = L::of(0.5 * view.exponents[1]);
    for i in 0..BLOCK {
        let equatorial = scratch.meridian_log_ratio[i] >= L::default();
        let (equator, axial) = (scratch.equator[i], scratch.axial[i]);
        let log_norm = half_e2 * scratch.equator_log_sum[i];
        scratch.greatest[i] = if equatorial { equator } else { axial };
        scratch.greatest_log_norm[i] = if equatorial { log_norm } else { L::default() };
    }
}

#[inline(always)]
fn meridional_powers<L: Lane, const FMA: bool>(view: &ModelView, scratch: &mut Scratch<L>) {
    let half_e1 = L::of(0.5 * view.exponents[0]);
    for i in 0..BLOCK {
        scratch.meridian_power[i] = exp::<FMA, L>(scratch.meridian_log_power[i]);
    }
    for i in 0..BLOCK {
        let (log_sum, share) = ln_1p_and_inverse::<FMA, L>(scratch.meridian_power[i]);
        scratch.meridian_share[i] = share;
        scratch.meridian_log_sum[i] = log_sum;
    }
    for i in 0..BLOCK {
        let log_norm =
            mul_add::<FMA, L>(half_e1, scratch.meridian_log_sum[i], scratch.greatest_log_norm[i]);
        scratch.inverse_gauge[i] = exp::<FMA, L>(-log_norm) / scratch.greatest[i];
    }
}

/// The residuals and their derivatives, from what the loops before have left.
#[inline(always)]
fn assemble<L: Lane, const GEOMETRIC: bool>(
    view: &ModelView,
    scratch: &Scratch<L>,
    rows: &mut Rows,
) {
    for i in 0..BLOCK {
        let point = Point::at(view, scratch, i);
        let radial = point.radial_row();
        let square_stretch = point.square_stretch();
        let radial_square = point.distance * point.distance;
        rows.radial_squares[i] = radial_square.to_f64();
        rows.geometric_squares[i] = (radial_square / square_stretch).to_f64();
        let row = if GEOMETRIC {
            point.geometric_row(view, scratch, i, &radial, square_stretch)
        } else {
            radial
        };
        for (column, value) in rows.columns.iter_mut().zip(row) {
            column[i] = value.to_f64();
        }
    }
}
