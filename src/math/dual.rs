//! Numbers that carry their derivative along.

use std::ops::{Add, Mul, Neg, Sub};

use super::{Interval, Scalar, Univariate};

/// A function of one variable over a range of it: enclosures of its values and of its slopes.
///
/// Where the function has a kink, its slopes on both sides and all between are held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual {
    /// The values.
    pub value: Interval,
    /// The slopes.
    pub slope: Interval,
}

impl Dual {
    /// The variable itself, over a range.
    pub fn variable(range: Interval) -> Self {
        Self { value: range, slope: Interval::point(1.0) }
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Add<f64> for Dual {
    type Output = Self;

    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl Mul<f64> for Dual {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, slope: self.slope * factor }
    }
}

impl Scalar for Dual {
    fn constant(value: f64) -> Self {
        Self { value: Interval::point(value), slope: Interval::ZERO }
    }

    fn recip(self) -> Self {
        let value = self.value.recip();
        Self { value, slope: -(self.slope * value * value) }
    }

    fn abs(self) -> Self {
        Self { value: self.value.abs(), slope: self.slope * self.value.sign() }
    }

    fn clamp(self, lo: f64, hi: f64) -> Self {
        let slope = self.slope * self.value.clamp_slope(lo, hi);
        Self { value: self.value.clamp(lo, hi), slope }
    }

    fn excess(self, lo: f64, hi: f64) -> Self {
        let slope = self.slope * (-self.value.clamp_slope(lo, hi) + 1.0);
        Self { value: self.value.excess(lo, hi), slope }
    }

    fn max(self, other: Self) -> Self {
        let slope = if self.value.lo() > other.value.hi() {
            self.slope
        } else if other.value.lo() > self.value.hi() {
            other.slope
        } else {
            self.slope.hull(other.slope)
        };
        Self { value: self.value.max(other.value), slope }
    }

    fn power(self, exponent: f64) -> Self {
        let slope = self.value.power(exponent - 1.0) * exponent;
        Self { value: self.value.power(exponent), slope: self.slope * slope }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = (self.value.sin(), self.value.cos());
        (
            Self { value: sin, slope: self.slope * cos },
            Self { value: cos, slope: -(self.slope * sin) },
        )
    }

    fn atan2(self, x: Self) -> Self {
        let squares = self.value.abs() * self.value.abs() + x.value.abs() * x.value.abs();
        let turning = self.slope * x.value - self.value * x.slope;
        Self { value: self.value.atan2(x.value), slope: turning * squares.recip() }
    }

    fn through(self, function: &dyn Univariate) -> Self {
        Self {
            value: function.value_range(self.value),
            slope: self.slope * function.slope_range(self.value),
        }
    }

    fn superellipse_norm(u: Self, v: Self, e: f64) -> Self {
        Self {
            value: Interval::superellipse_norm(u.value, v.value, e),
            slope: u.slope * Interval::superellipse_norm_slope(u.value, v.value, e)
                + v.slope * Interval::superellipse_norm_slope(v.value, u.value, e),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Functions of one variable through every operation.
    fn curves<S: Scalar>(t: S) -> Vec<S> {
        let (sin, cos) = t.sin_cos();
        vec![
            t * t + 2.0 - t * sin,
            -(cos * 3.0) * t.abs(),
            (t * t + 1.0).recip(),
            t.clamp(-0.3, 0.4) * t,
            t.excess(-0.3, 0.4) * t,
            t.max(cos),
            t.abs().power(2.7),
            (t + 2.0).power(0.4),
            (t + 0.2).atan2(cos + 0.5),
            S::superellipse_norm(t.abs(), (cos * 0.7).abs(), 0.3),
            S::superellipse_norm((t * t).abs(), S::constant(0.2), 1.7),
        ]
    }

    #[test]
    fn slopes_hold_every_difference_quotient() {
        for start in [-1.0, -0.5, -0.1, 0.05, 0.35, 0.9] {
            for width in [1e-3, 0.1, 0.5] {
                let range = Interval::new(start, start + width);
                let enclosures = curves(Dual::variable(range));
                let at = |share: f64| curves(start + width * share);
                for (before, after) in [(0.0, 1.0), (0.1, 0.3), (0.6, 0.7)] {
                    let pairs = at(before).into_iter().zip(at(after)).zip(&enclosures);
                    for (case, ((low, high), enclosure)) in pairs.enumerate() {
                        assert!(enclosure.value.contains(low) && enclosure.value.contains(high));
                        let quotient = (high - low) / (width * (after - before));
                        let slope = enclosure.slope.widened(1e-11); // rounding of the quotient
                        assert!(slope.contains(quotient), "{case} {range:?} {quotient} {slope:?}");
                    }
                }
            }
        }
    }
}
