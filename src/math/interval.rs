//! Interval arithmetic: enclosures of all values that a formula takes over a range.

mod elementary;

pub(super) use elementary::norm_slope;

use std::ops::{Add, Mul, Neg, Sub};

/// A closed interval `[lo, hi]` of real numbers; its ends may be infinite.
///
/// Arithmetic rounds outwards, so that a result holds whatever the formula gives for numbers of
/// its operands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

impl Interval {
    /// All numbers.
    pub const ENTIRE: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Zero alone.
    pub const ZERO: Self = Self { lo: 0.0, hi: 0.0 };

    /// The numbers from the lesser of `a` and `b` to the greater; all, where one is not a number.
    pub fn new(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() {
            return Self::ENTIRE;
        }
        Self { lo: a.min(b), hi: a.max(b) }
    }

    /// A number alone.
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// The least interval that holds all of some numbers; all, where there are none.
    pub fn hull_of(values: impl IntoIterator<Item = f64>) -> Self {
        values.into_iter().map(Self::point).reduce(Self::hull).unwrap_or(Self::ENTIRE)
    }

    /// The least number.
    pub fn lo(self) -> f64 {
        self.lo
    }

    /// The greatest number.
    pub fn hi(self) -> f64 {
        self.hi
    }

    /// How far the ends are apart.
    pub fn width(self) -> f64 {
        self.hi - self.lo
    }

    /// A number halfway between finite ends.
    pub fn middle(self) -> f64 {
        0.5 * self.lo + 0.5 * self.hi
    }

    /// The two halves.
    pub fn halves(self) -> [Self; 2] {
        let middle = self.middle();
        [Self { hi: middle, ..self }, Self { lo: middle, ..self }]
    }

    /// Whether a number is in it.
    pub fn contains(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }

    /// The least interval that holds both.
    pub fn hull(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// What both hold, if there is such a number.
    pub fn intersection(self, other: Self) -> Option<Self> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(Self { lo, hi })
    }

    /// The interval, its ends moved outwards by so much.
    pub fn widened(self, by: f64) -> Self {
        Self::outward(self.lo - by, self.hi + by)
    }

    /// The interval, its ends moved outwards by a share of their magnitudes.
    pub fn widened_relatively(self, share: f64) -> Self {
        Self::outward(self.lo - share * self.lo.abs(), self.hi + share * self.hi.abs())
    }

    /// Ends that were rounded to nearest, moved outwards to where the true ones cannot be beyond.
    fn outward(lo: f64, hi: f64) -> Self {
        let lo = if lo.is_nan() { f64::NEG_INFINITY } else { lo.next_down() };
        let hi = if hi.is_nan() { f64::INFINITY } else { hi.next_up() };
        Self { lo, hi }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::outward(self.lo + other.lo, self.hi + other.hi)
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::outward(self.lo - other.hi, self.hi - other.lo)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let products = [
            product(self.lo, other.lo),
            product(self.lo, other.hi),
            product(self.hi, other.lo),
            product(self.hi, other.hi),
        ];
        let lo = products.into_iter().fold(f64::INFINITY, f64::min);
        let hi = products.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Self::outward(lo, hi)
    }
}

impl Add<f64> for Interval {
    type Output = Self;

    fn add(self, other: f64) -> Self {
        Self::outward(self.lo + other, self.hi + other)
    }
}

impl Mul<f64> for Interval {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        // Zero and one are exact, and frequent in rotations by right angles.
        if factor == 0.0 {
            return Self::ZERO;
        }
        if factor == 1.0 {
            return self;
        }
        let ends = Self::new(self.lo * factor, self.hi * factor);
        Self::outward(ends.lo, ends.hi)
    }
}

/// The product, where zero times an end at infinity is zero: no number there is infinite.
fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

#[cfg(test)]
mod tests;
