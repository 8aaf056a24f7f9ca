//! The rows of one point of a block: the arithmetic of [`radial_row`] and [`geometric_row`] from
//! the powers and logarithms that the block's loops have left.
//!
//! [`radial_row`]: crate::recover::radial::radial_row
//! [`geometric_row`]: crate::recover::geometric::geometric_row

use super::block::Scratch;
use super::gram::COLUMNS;
use super::view::ModelView;
use crate::math::lane::{Lane, greater};

/// What the rows of one point are made of.
pub(super) struct Point<L> {
    x: [L; 3],
    /// `1 / |x_i|`, of coordinates that are not told from zero that of the least that are.
    inverse: [L; 3],
    /// `1 / |x|`.
    inverse_radius: L,
    /// Distance of the surface along the ray.
    surface: L,
    /// The signed radial distance.
    pub(super) distance: L,
    /// Derivatives of the radial distance by the point.
    n: [L; 3],
    /// `|x| alpha_i / |x_i|`: the gradient of H on the surface, times its distance.
    q: [L; 3],
    /// `d ln H / d ln |x_i|`.
    alpha: [L; 3],
    /// Share of the equatorial in the meridional sum.
    equatorial: L,
    /// Shares of x and y in the equatorial sum.
    shares: [L; 2],
    /// Entropies of the meridional and the equatorial shares.
    entropies: [L; 2],
    is_equatorial: bool,
    is_x_greatest: bool,
}

impl<L: Lane> Point<L> {
    #[inline(always)]
    pub(super) fn at(view: &ModelView, scratch: &Scratch<L>, i: usize) -> Self {
        let [a, b, c] = view.size.map(L::of);
        let [ia, ib, _] = view.inverse_size.map(L::of);
        let x = [scratch.x[0][i], scratch.x[1][i], scratch.x[2][i]];
        let mx = greater(x[0].abs(), L::TINY * a);
        let my = greater(x[1].abs(), L::TINY * b);
        let mz = greater(x[2].abs(), L::TINY * c);

        let equator_greatest = scratch.equator_share[i];
        let equator_least = scratch.equator_power[i] * equator_greatest;
        let meridian_greatest = scratch.meridian_share[i];
        let meridian_least = scratch.meridian_power[i] * meridian_greatest;
        let is_x_greatest = mx * ia > my * ib;
        let share_x = if is_x_greatest { equator_greatest } else { equator_least };
        let share_y = if is_x_greatest { equator_least } else { equator_greatest };
        let is_equatorial = scratch.meridian_log_ratio[i] >= L::default();
        let equatorial = if is_equatorial { meridian_greatest } else { meridian_least };
        let axial = if is_equatorial { meridian_least } else { meridian_greatest };
        let alpha = [equatorial * share_x, equatorial * share_y, axial];
        let meridian_entropy =
            scratch.meridian_log_sum[i] - meridian_least * scratch.meridian_log_power[i];
        let equator_entropy =
            scratch.equator_log_sum[i] - equator_least * scratch.equator_log_power[i];

        let radius = (mx * mx + my * my + mz * mz).sqrt();
        let surface = radius * scratch.inverse_gauge[i];
        // Two divisions for four reciprocals.
        let (of_x_and_y, of_z_and_radius) = (L::of(1.0) / (mx * my), L::of(1.0) / (mz * radius));
        let inverse = [my * of_x_and_y, mx * of_x_and_y, radius * of_z_and_radius];
        let inverse_radius = mz * of_z_and_radius;
        let stretch = (L::of(1.0) - scratch.inverse_gauge[i]) * inverse_radius;
        let slopes = [alpha[0] * inverse[0], alpha[1] * inverse[1], alpha[2] * inverse[2]];
        let n = [
            x[0] * stretch + with_sign_of(x[0], surface * slopes[0]),
            x[1] * stretch + with_sign_of(x[1], surface * slopes[1]),
            x[2] * stretch + with_sign_of(x[2], surface * slopes[2]),
        ];
        Self {
            x,
            inverse,
            inverse_radius,
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
    pub(super) fn radial_row(&self) -> [L; COLUMNS] {
        let (half, moment) = (L::of(0.5), cross(self.n, self.x));
        [
            self.distance,
            -self.surface * self.alpha[0],
            -self.surface * self.alpha[1],
            -self.surface * self.alpha[2],
            half * self.surface * self.entropies[0],
            half * self.surface * self.equatorial * self.entropies[1],
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
    pub(super) fn square_stretch(&self) -> L {
        self.q[0] * self.q[0] + self.q[1] * self.q[1] + self.q[2] * self.q[2]
    }

    /// The signed first-order geometric distance.
    #[inline(always)]
    pub(super) fn geometric_distance(&self) -> L {
        self.distance / self.square_stretch().sqrt()
    }

    /// The unit normal of the gauge's level through the point, in the model's frame.
    #[inline(always)]
    pub(super) fn normal(&self) -> [L; 3] {
        let inverse = L::of(1.0) / self.square_stretch().sqrt();
        let [x, y, z] = self.x;
        [
            with_sign_of(x, self.q[0] * inverse),
            with_sign_of(y, self.q[1] * inverse),
            with_sign_of(z, self.q[2] * inverse),
        ]
    }

    /// The geometric distance and its derivatives, as in `geometric_row`.
    #[inline(always)]
    pub(super) fn geometric_row(
        &self,
        view: &ModelView,
        scratch: &Scratch<L>,
        i: usize,
        radial: &[L; COLUMNS],
        square_stretch: L,
    ) -> [L; COLUMNS] {
        let [e1, e2] = view.exponents;
        let [x, y, z] = self.x;
        let inverse_square = L::of(1.0) / square_stretch;
        let beta = [
            self.q[0] * self.q[0] * inverse_square,
            self.q[1] * self.q[1] * inverse_square,
            self.q[2] * self.q[2] * inverse_square,
        ];
        let meridian_odds = negated_if(scratch.meridian_log_power[i], self.is_equatorial);
        let equator_odds = negated_if(scratch.equator_log_power[i], self.is_x_greatest);
        let a = self.alpha[2] - beta[2];
        let b = beta[0] * self.shares[1] - beta[1] * self.shares[0];
        let (meridian, equator) = (a * L::of(2.0 / e1), b * L::of(2.0 / e2));
        let by_size =
            [meridian * self.shares[0] + equator, meridian * self.shares[1] - equator, -meridian];
        let flattening = self.inverse_radius * self.inverse_radius;
        let slopes = [
            (by_size[0] - beta[0]) * self.inverse[0],
            (by_size[1] - beta[1]) * self.inverse[1],
            (by_size[2] - beta[2]) * self.inverse[2],
        ];
        let n = [
            x * flattening + with_sign_of(x, slopes[0]),
            y * flattening + with_sign_of(y, slopes[1]),
            z * flattening + with_sign_of(z, slopes[2]),
        ];
        let moment = cross(n, self.x);
        let log_gradient = [
            L::default(),
            -by_size[0],
            -by_size[1],
            -by_size[2],
            -a * meridian_odds * L::of(1.0 / e1),
            L::of(0.5) * meridian * self.entropies[1] - b * equator_odds * L::of(1.0 / e2),
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

/// `value` times the sign of `x`; zero at zero.
#[inline(always)]
fn with_sign_of<L: Lane>(x: L, value: L) -> L {
    let signed = value * L::of(1.0).copysign(x);
    if x == L::default() { L::default() } else { signed }
}

#[inline(always)]
fn negated_if<L: Lane>(value: L, condition: bool) -> L {
    let negated = -value;
    if condition { negated } else { value }
}

#[inline(always)]
fn cross<L: Lane>(a: [L; 3], b: [L; 3]) -> [L; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
