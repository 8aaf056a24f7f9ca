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
            let row = point.geometric_row(view, scratch, i, &radial, square_stretch);
            saturated(row, view.saturation)
        } else {
            radial
        };
        for (column, value) in rows.columns.iter_mut().zip(row) {
            column[i] = value;
        }
    }
}

/// The row of the saturated residual `g / sqrt(1 + s g^2)`, whose square is the loss of Geman and
/// McClure: quadratic within `1 / sqrt(s)`, bounded by `1 / s`.
#[inline(always)]
fn saturated(row: [f64; COLUMNS], saturation: f64) -> [f64; COLUMNS] {
    let share = 1.0 / (1.0 + saturation * row[0] * row[0]);
    let factor = share.sqrt();
    let slope = factor * share;
    let mut saturated = row.map(|entry| entry * slope);
    saturated[0] = row[0] * factor;
    saturated
}

/// What the rows of one point are made of.
struct Point {
    x: [f64; 3],
    radius: f64,
    /// Distance of the surface along the ray.
    surface: f64,
    /// The signed radial distance.
    distance: f64,
    /// Derivatives of the radial distance by the point.
    n: [f64; 3],
    /// `|x| alpha_i / |x_i|`: the gradient of H on the surface, times its distance.
    q: [f64; 3],
    /// `d ln H / d ln |x_i|`.
    alpha: [f64; 3],
    /// Share of the equatorial in the meridional sum.
    equatorial: f64,
    /// Shares of x and y in the equatorial sum.
    shares: [f64; 2],
    /// Entropies of the meridional and the equatorial shares.
    entropies: [f64; 2],
    is_equatorial: bool,
    is_x_greatest: bool,
}

impl Point {
    #[inline(always)]
    fn at(view: &ModelView, scratch: &Scratch, i: usize) -> Self {
        let [a, b, c] = view.size;
        let [ia, ib, _] = view.inverse_size;
        let x = [scratch.x[0][i], scratch.x[1][i], scratch.x[2][i]];
        let mx = greater(x[0].abs(), TINY * a);
        let my = greater(x[1].abs(), TINY * b);
        let mz = greater(x[2].abs(), TINY * c);

        let equator_greatest = 1.0 / (1.0 + scratch.equator_power[i]);
        let equator_least = scratch.equator_power[i] * equator_greatest;
        let meridian_greatest = 1.0 / (1.0 + scratch.meridian_power[i]);
        let meridian_least = scratch.meridian_power[i] * meridian_greatest;
        let is_x_greatest = mx * ia > my * ib;
        let share_x = if is_x_greatest { equator_greatest } else { equator_least };
        let share_y = if is_x_greatest { equator_least } else { equator_greatest };
        let is_equatorial = scratch.meridian_log_ratio[i] >= 0.0;
        let equatorial = if is_equatorial { meridian_greatest } else { meridian_least };
        let axial = if is_equatorial { meridian_least } else { meridian_greatest };
        let alpha = [equatorial * share_x, equatorial * share_y, axial];
        let meridian_entropy =
            scratch.meridian_log_sum[i] - meridian_least * scratch.meridian_log_power[i];
        let equator_entropy =
            scratch.equator_log_sum[i] - equator_least * scratch.equator_log_power[i];

        let radius = (mx * mx + my * my + mz * mz).sqrt();
        let surface = radius * scratch.inverse_gauge[i];
        let stretch = (1.0 - scratch.inverse_gauge[i]) / radius;
        let slopes = [alpha[0] / mx, alpha[1] / my, alpha[2] / mz];
        let n = [
            x[0] * stretch + signed(surface * slopes[0], x[0]),
            x[1] * stretch + signed(surface * slopes[1], x[1]),
            x[2] * stretch + signed(surface * slopes[2], x[2]),
        ];
        Self {
            x,
            radius,
            surface,
            distance: radius - surface,
            n,
            q: [radius * slopes[0], radius * slopes[1], radius * slopes[2]],
            alpha,
            equatorial,
            shares: [share_x, share_y],
            entropies: [meridian_entropy, equator_entropy],
            is_equatorial,
            is_x_greatest,
        }
    }

    /// The radial distance and its derivatives, as in `radial_row`.
    #[inline(always)]
    fn radial_row(&self) -> [f64; COLUMNS] {
        let moment = cross(self.n, self.x);
        [
            self.distance,
            -self.surface * self.alpha[0],
            -self.surface * self.alpha[1],
            -self.surface * self.alpha[2],
            0.5 * self.surface * self.entropies[0],
            0.5 * self.surface * self.equatorial * self.entropies[1],
            moment[0],
            moment[1],
            moment[2],
            -self.n[0],
            -self.n[1],
            -self.n[2],
        ]
    }

    /// Square of the radial over the geometric distance: at least one.
    #[inline(always)]
    fn square_stretch(&self) -> f64 {
        self.q[0] * self.q[0] + self.q[1] * self.q[1] + self.q[2] * self.q[2]
    }

    /// The geometric distance and its derivatives, as in `geometric_row`.
    #[inline(always)]
    fn geometric_row(
        &self,
        view: &ModelView,
        scratch: &Scratch,
        i: usize,
        radial: &[f64; COLUMNS],
        square_stretch: f64,
    ) -> [f64; COLUMNS] {
        let [e1, e2] = view.exponents;
        let [x, y, z] = self.x;
        let inverse_square = 1.0 / square_stretch;
        let beta = [
            self.q[0] * self.q[0] * inverse_square,
            self.q[1] * self.q[1] * inverse_square,
            self.q[2] * self.q[2] * inverse_square,
        ];
        let meridian_odds = negated_if(scratch.meridian_log_power[i], self.is_equatorial);
        let equator_odds = negated_if(scratch.equator_log_power[i], self.is_x_greatest);
        let a = self.alpha[2] - beta[2];
        let b = beta[0] * self.shares[1] - beta[1] * self.shares[0];
        let (meridian, equator) = (a * (2.0 / e1), b * (2.0 / e2));
        let by_size =
            [meridian * self.shares[0] + equator, meridian * self.shares[1] - equator, -meridian];
        let flattening = 1.0 / (self.radius * self.radius);
        let n = [
            x * flattening + quotient(by_size[0] - beta[0], x),
            y * flattening + quotient(by_size[1] - beta[1], y),
            z * flattening + quotient(by_size[2] - beta[2], z),
        ];
        let moment = cross(n, self.x);
        let log_gradient = [
            0.0,
            -by_size[0],
            -by_size[1],
            -by_size[2],
            -a * meridian_odds * (1.0 / e1),
            0.5 * meridian * self.entropies[1] - b * equator_odds * (1.0 / e2),
            moment[0],
            moment[1],
            moment[2],
            -n[0],
            -n[1],
            -n[2],
        ];
        let inverse = inverse_square.sqrt();
        let mut row = *radial;
        for (entry, slope) in row.iter_mut().zip(log_gradient) {
            *entry = (*entry - self.distance * slope) * inverse;
        }
        row
    }
}

/// A magnitude with the sign of `x`; zero at zero.
#[inline(always)]
fn signed(magnitude: f64, x: f64) -> f64 {
    let signed = magnitude.copysign(x);
    if x == 0.0 { 0.0 } else { signed }
}

/// `a / x`; zero at zero.
#[inline(always)]
fn quotient(a: f64, x: f64) -> f64 {
    let quotient = a / x;
    if x == 0.0 { 0.0 } else { quotient }
}

#[inline(always)]
fn negated_if(value: f64, condition: bool) -> f64 {
    let negated = -value;
    if condition { negated } else { value }
}

#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
