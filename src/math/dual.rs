//! Numbers that carry their derivative along.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use super::{Interval, Scalar, Sloped, Univariate};

/// A function of one variable, at a place or over a range of them: its value and its slope, or
/// enclosures of both.
///
/// Where the function has a kink, an enclosure holds its slopes on both sides and all between;
/// a number is one of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<N = Interval> {
    /// The values.
    pub value: N,
    /// The slopes.
    pub slope: N,
}

impl<N: Scalar> Dual<N> {
    /// The variable itself, at a place or over a range.
    pub fn variable(value: N) -> Self {
        Self { value, slope: N::constant(1.0) }
    }

    /// A function along one of the axes of space: the coordinates of a point or box as they vary
    /// along the axis.
    pub fn along(axis: usize, x: [N; 3]) -> [Self; 3] {
        let slope = |i: usize| if i == axis { 1.0 } else { 0.0 };
        std::array::from_fn(|i| Self { value: x[i], slope: N::constant(slope(i)) })
    }
}

impl<N: Scalar> Add for Dual<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl<N: Scalar> Sub for Dual<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: self.slope - other.slope }
    }
}

impl<N: Scalar> Mul for Dual<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

impl<N: Scalar> Neg for Dual<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl<N: Scalar> Add<f64> for Dual<N> {
    type Output = Self;

    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl<N: Scalar> Mul<f64> for Dual<N> {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, slope: self.slope * factor }
    }
}

impl<N: Sloped> Scalar for Dual<N> {
    fn constant(value: f64) -> Self {
        Self { value: N::constant(value), slope: N::constant(0.0) }
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
        let slope = match self.value.order(other.value) {
            Some(Ordering::Greater) => self.slope,
            Some(Ordering::Less) => other.slope,
            _ => self.slope.between(other.slope),
        };
        Self { value: self.value.max(other.value), slope }
    }

    fn power(self, exponent: f64) -> Self {
        let slope = self.value.power(exponent - 1.0) * exponent;
        Self { value: self.value.power(exponent), slope: self.slope * slope }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
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
            value: self.value.through(function),
            slope: self.slope * self.value.slope_through(function),
        }
    }

    fn superellipse_norm(u: Self, v: Self, e: f64) -> Self {
        Self {
            value: N::superellipse_norm(u.value, v.value, e),
            slope: u.slope * N::superellipse_norm_slope(u.value, v.value, e)
                + v.slope * N::superellipse_norm_slope(v.value, u.value, e),
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

    #[test]
    fn slopes_at_a_place_are_within_those_of_the_place_as_an_interval() {
        for t in [-1.0, -0.5, -0.1, 0.0, 0.05, 0.35, 0.9] {
            let enclosures = curves(Dual::variable(Interval::point(t)));
            for (found, enclosure) in curves(Dual::variable(t)).into_iter().zip(enclosures) {
                assert!(enclosure.value.widened(1e-14).contains(found.value), "{t}");
                assert!(enclosure.slope.widened(1e-13).contains(found.slope), "{t}");
            }
        }
    }
}
