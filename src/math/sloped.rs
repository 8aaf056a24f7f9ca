//! The numbers that slopes can be had in.

use std::cmp::Ordering;

use super::interval::norm_slope;
use super::{Interval, Scalar, Univariate};

/// Numbers in which the slopes of formulas can be had: [`f64`], where a kink has one of its
/// slopes, and [`Interval`]s, where it has all of them.
pub trait Sloped: Scalar {
    /// The slope of `|x|`: -1 or 1, and 0 or all between at a kink.
    fn sign(self) -> Self;

    /// The slope of `clamp`: 1 within `[lo, hi]`, 0 outside.
    fn clamp_slope(self, lo: f64, hi: f64) -> Self;

    /// How two numbers compare; nothing, where they are equal or overlap.
    fn order(self, other: Self) -> Option<Ordering>;

    /// What stands for two slopes of which either may be the one.
    fn between(self, other: Self) -> Self;

    /// The slope of a function.
    fn slope_through(self, function: &dyn Univariate) -> Self;

    /// The slope along u of the norm `(u^(2/e) + v^(2/e))^(e/2)` of two magnitudes.
    fn superellipse_norm_slope(u: Self, v: Self, e: f64) -> Self;
}

impl Sloped for f64 {
    fn sign(self) -> Self {
        if self == 0.0 { 0.0 } else { self.signum() }
    }

    fn clamp_slope(self, lo: f64, hi: f64) -> Self {
        if lo <= self && self <= hi { 1.0 } else { 0.0 }
    }

    fn order(self, other: Self) -> Option<Ordering> {
        self.partial_cmp(&other).filter(|order| order.is_ne())
    }

    fn between(self, other: Self) -> Self {
        0.5 * (self + other)
    }

    fn slope_through(self, function: &dyn Univariate) -> Self {
        function.slope(self)
    }

    fn superellipse_norm_slope(u: Self, v: Self, e: f64) -> Self {
        // Zero times a slope without bound is zero.
        norm_slope(u, v, e).min(f64::MAX)
    }
}

impl Sloped for Interval {
    fn sign(self) -> Self {
        self.sign()
    }

    fn clamp_slope(self, lo: f64, hi: f64) -> Self {
        self.clamp_slope(lo, hi)
    }

    fn order(self, other: Self) -> Option<Ordering> {
        if self.lo() > other.hi() {
            Some(Ordering::Greater)
        } else if other.lo() > self.hi() {
            Some(Ordering::Less)
        } else {
            None
        }
    }

    fn between(self, other: Self) -> Self {
        self.hull(other)
    }

    fn slope_through(self, function: &dyn Univariate) -> Self {
        function.slope_range(self)
    }

    fn superellipse_norm_slope(u: Self, v: Self, e: f64) -> Self {
        Self::superellipse_norm_slope(u, v, e)
    }
}
