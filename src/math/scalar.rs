//! The numbers that a geometric formula can be evaluated in.

use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

use super::{Interval, Univariate, superellipse_norm};

/// Numbers that formulas are written in once: [`f64`], its [`Interval`]s, and
/// [`Dual`](super::Dual) numbers of both.
pub trait Scalar:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// A number that does not vary.
    fn constant(value: f64) -> Self;

    /// `1 / x`.
    fn recip(self) -> Self;

    /// `|x|`.
    fn abs(self) -> Self;

    /// The nearest number of `[lo, hi]`.
    fn clamp(self, lo: f64, hi: f64) -> Self;

    /// By how much it lies beyond `[lo, hi]`: negative below, 0 within.
    fn excess(self, lo: f64, hi: f64) -> Self;

    /// The greater of two numbers.
    fn max(self, other: Self) -> Self;

    /// The lesser of two numbers.
    fn min(self, other: Self) -> Self {
        -((-self).max(-other))
    }

    /// The power of a magnitude, of an exponent above 0.
    fn power(self, exponent: f64) -> Self;

    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);

    /// The angle of the point `(x, y)`, y being this, in radians from -pi to pi.
    fn atan2(self, x: Self) -> Self;

    /// A function of the number.
    fn through(self, function: &dyn Univariate) -> Self;

    /// The norm `(u^(2/e) + v^(2/e))^(e/2)` of two magnitudes.
    fn superellipse_norm(u: Self, v: Self, e: f64) -> Self;
}

impl Scalar for f64 {
    fn constant(value: f64) -> Self {
        value
    }

    fn recip(self) -> Self {
        self.recip()
    }

    fn abs(self) -> Self {
        self.abs()
    }

    fn clamp(self, lo: f64, hi: f64) -> Self {
        self.clamp(lo, hi)
    }

    fn excess(self, lo: f64, hi: f64) -> Self {
        self - self.clamp(lo, hi)
    }

    fn max(self, other: Self) -> Self {
        self.max(other)
    }

    fn power(self, exponent: f64) -> Self {
        self.powf(exponent)
    }

    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }

    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }

    fn through(self, function: &dyn Univariate) -> Self {
        function.value(self)
    }

    fn superellipse_norm(u: Self, v: Self, e: f64) -> Self {
        superellipse_norm(u, v, e)
    }
}

impl Scalar for Interval {
    fn constant(value: f64) -> Self {
        Self::point(value)
    }

    fn recip(self) -> Self {
        self.recip()
    }

    fn abs(self) -> Self {
        self.abs()
    }

    fn clamp(self, lo: f64, hi: f64) -> Self {
        self.clamp(lo, hi)
    }

    fn excess(self, lo: f64, hi: f64) -> Self {
        self.excess(lo, hi)
    }

    fn max(self, other: Self) -> Self {
        self.max(other)
    }

    fn power(self, exponent: f64) -> Self {
        self.power(exponent)
    }

    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }

    fn through(self, function: &dyn Univariate) -> Self {
        function.value_range(self)
    }

    fn superellipse_norm(u: Self, v: Self, e: f64) -> Self {
        Self::superellipse_norm(u, v, e)
    }
}
