//! Elementary functions of intervals.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::Interval;
use crate::math::superellipse_norm;

/// Relative error that is allowed the C library's functions: they are good to 2^-52.
const LIBRARY_ERROR: f64 = 2.0 * f64::EPSILON;

/// Relative error of the norm of a superellipse: its few functions, and a logarithm whose error
/// is multiplied only where its power is small.
const NORM_ERROR: f64 = 16.0 * f64::EPSILON;

impl Interval {
    /// The reciprocals; all numbers, where zero is among them.
    pub fn recip(self) -> Self {
        if self.contains(0.0) {
            return Self::ENTIRE;
        }
        let ends = Self::new(self.lo.recip(), self.hi.recip());
        Self::outward(ends.lo, ends.hi)
    }

    /// The magnitudes.
    pub fn abs(self) -> Self {
        if self.lo >= 0.0 {
            self
        } else if self.hi <= 0.0 {
            -self
        } else {
            Self { lo: 0.0, hi: (-self.lo).max(self.hi) }
        }
    }

    /// The slopes of `|x|`: -1, 1 or all between.
    pub fn sign(self) -> Self {
        if self.lo > 0.0 {
            Self::point(1.0)
        } else if self.hi < 0.0 {
            Self::point(-1.0)
        } else {
            Self::new(-1.0, 1.0)
        }
    }

    /// The numbers moved to the nearest of `[lo, hi]`.
    pub fn clamp(self, lo: f64, hi: f64) -> Self {
        Self { lo: self.lo.max(lo).min(hi), hi: self.hi.min(hi).max(lo) }
    }

    /// The slopes of that: 0 outside, 1 inside, or all between.
    pub fn clamp_slope(self, lo: f64, hi: f64) -> Self {
        if self.hi < lo || self.lo > hi {
            Self::ZERO
        } else if lo < self.lo && self.hi < hi {
            Self::point(1.0)
        } else {
            Self::new(0.0, 1.0)
        }
    }

    /// By how much the numbers lie beyond `[lo, hi]`: they ascend.
    pub fn excess(self, lo: f64, hi: f64) -> Self {
        let beyond = |x: f64| x - x.clamp(lo, hi);
        let (least, greatest) = (beyond(self.lo), beyond(self.hi));
        let rounded = Self::outward(least, greatest);
        // Within, nothing was rounded.
        let lo = if least == 0.0 { 0.0 } else { rounded.lo };
        Self { lo, hi: if greatest == 0.0 { 0.0 } else { rounded.hi } }
    }

    /// The greater of numbers of both.
    pub fn max(self, other: Self) -> Self {
        Self { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The powers of magnitudes: they ascend for exponents above 0, and descend below.
    pub fn power(self, exponent: f64) -> Self {
        let power = |x: f64| x.max(0.0).powf(exponent);
        Self::new(power(self.lo), power(self.hi)).widened_relatively(LIBRARY_ERROR)
    }

    /// The sines.
    pub fn sin(self) -> Self {
        self.wave(f64::sin, FRAC_PI_2)
    }

    /// The cosines.
    pub fn cos(self) -> Self {
        self.wave(f64::cos, 0.0)
    }

    /// The values of a sine or cosine that is 1 at `crest`, and -1 half a turn further.
    fn wave(self, function: fn(f64) -> f64, crest: f64) -> Self {
        // Written so that infinite ends end here too.
        let is_short = self.width() < TAU;
        if !is_short {
            return Self::new(-1.0, 1.0);
        }
        let ends = Self::new(function(self.lo), function(self.hi));
        let mut range = ends.widened_relatively(LIBRARY_ERROR);
        if self.may_hold_one_of(crest) {
            range.hi = 1.0;
        }
        if self.may_hold_one_of(crest + PI) {
            range.lo = -1.0;
        }
        range
    }

    /// Whether `offset` plus a whole number of turns is in it, or next to it by rounding.
    fn may_hold_one_of(self, offset: f64) -> bool {
        let turns = |angle: f64| (angle - offset) / TAU;
        let slack = 4.0 * f64::EPSILON * (1.0 + turns(self.lo).abs().max(turns(self.hi).abs()));
        (turns(self.lo) - slack).ceil() <= turns(self.hi) + slack
    }

    /// The angles of the points `(x, y)`, y being this, from -pi to pi; all of them, where the
    /// points surround the origin or lie on both sides of the negative x axis.
    pub fn atan2(self, x: Self) -> Self {
        let y = self;
        if x.lo <= 0.0 && y.contains(0.0) {
            return Self::new(-PI, PI).widened_relatively(LIBRARY_ERROR);
        }
        let corners = [(y.lo, x.lo), (y.lo, x.hi), (y.hi, x.lo), (y.hi, x.hi)];
        Self::hull_of(corners.map(|(y, x)| y.atan2(x))).widened_relatively(LIBRARY_ERROR)
    }

    /// The norms `(u^(2/e) + v^(2/e))^(e/2)` of magnitudes u and v: they ascend in both.
    pub fn superellipse_norm(u: Self, v: Self, e: f64) -> Self {
        let lo = superellipse_norm(u.lo.max(0.0), v.lo.max(0.0), e);
        Self { lo, hi: superellipse_norm(u.hi, v.hi, e) }.widened_relatively(NORM_ERROR)
    }

    /// Its slopes along u, `(u/p)^(2/e - 1)`: they ascend in u and descend in v for `e < 2`, and
    /// the other way round beyond.
    pub fn superellipse_norm_slope(u: Self, v: Self, e: f64) -> Self {
        let power = 2.0 / e - 1.0;
        let ends = [norm_slope(u.lo.max(0.0), v.hi, e), norm_slope(u.hi, v.lo.max(0.0), e)];
        let ends = Self::new(ends[0], ends[1]);
        ends.widened_relatively((1.0 + power.abs()) * NORM_ERROR)
    }
}

/// `(u/p)^(2/e - 1)`, with the limit that is greatest where both are zero.
pub(in crate::math) fn norm_slope(u: f64, v: f64, e: f64) -> f64 {
    let power = 2.0 / e - 1.0;
    if u == 0.0 && v == 0.0 || u.is_infinite() {
        return if power >= 0.0 { 1.0 } else { f64::INFINITY };
    }
    (u / superellipse_norm(u, v, e)).powf(power)
}
