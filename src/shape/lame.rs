//! The nine kinds of Lame curve (JLS section 2.1.1, after Loria 1910).

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector2;

use super::curve::{Curve, CurvePoint, Jet};
use crate::error::ModelError;

/// The plane curve `(x/a)^m + (y/b)^m = 1` for a rational m (JLS Eq. 2.3), semi-axes a and b in
/// the model's unit.
///
/// A power of a negative number is what it is for that fraction: even where the numerator is,
/// odd where both are odd, none where the denominator is even.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LameCurve {
    size: [f64; 2],
    numerator: i32,
    denominator: u32,
}

/// What a power does with negative numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Parity {
    Even,
    Odd,
    Undefined,
}

impl LameCurve {
    /// The curve of semi-axes `[a, b]` and the exponent `numerator / denominator`.
    ///
    /// # Errors
    /// If a semi-axis is not a positive, finite number, or the fraction is 0 or none.
    pub fn new(size: [f64; 2], numerator: i32, denominator: u32) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        if numerator == 0 || denominator == 0 {
            return Err(ModelError::Fraction { numerator, denominator });
        }
        let divisor = greatest_common_divisor(numerator.unsigned_abs(), denominator);
        let numerator = (i64::from(numerator) / i64::from(divisor)) as i32;
        Ok(Self { size, numerator, denominator: denominator / divisor })
    }

    /// Semi-axes `[a, b]`.
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// The numerator of the exponent in lowest terms.
    pub fn numerator(&self) -> i32 {
        self.numerator
    }

    /// The denominator of the exponent in lowest terms.
    pub fn denominator(&self) -> u32 {
        self.denominator
    }

    /// The exponent m.
    pub fn exponent(&self) -> f64 {
        f64::from(self.numerator) / f64::from(self.denominator)
    }

    /// The number, 1 to 9, of the curve's kind in JLS's list; m = 1, a straight line, counts to
    /// the fifth.
    pub fn kind(&self) -> u8 {
        let is_above_one = self.exponent() >= 1.0;
        match (self.parity(), self.numerator > 0) {
            (Parity::Even, true) => 2 - u8::from(is_above_one),
            (Parity::Undefined, true) => 4 - u8::from(is_above_one),
            (Parity::Odd, true) => 6 - u8::from(is_above_one),
            (Parity::Even, false) => 7,
            (Parity::Undefined, false) => 8,
            (Parity::Odd, false) => 9,
        }
    }

    /// The left side of the equation: 1 on the curve, NaN where a power is not real.
    pub fn implicit(&self, x: &Vector2<f64>) -> f64 {
        let power = |ratio: f64| {
            let magnitude = ratio.abs().powf(self.exponent());
            match self.parity() {
                Parity::Even => magnitude,
                Parity::Odd => magnitude.copysign(ratio),
                Parity::Undefined if ratio < 0.0 => f64::NAN,
                Parity::Undefined => magnitude,
            }
        };
        power(x.x / self.size[0]) + power(x.y / self.size[1])
    }

    /// The curve's arcs, each within one quadrant.
    pub fn arcs(&self) -> Vec<LameArc> {
        let arc = |signs, is_outer| LameArc { curve: *self, signs, is_outer };
        match self.parity() {
            Parity::Undefined => vec![arc([1.0, 1.0], false)],
            Parity::Even => {
                [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|s| arc(s, false)).into()
            }
            Parity::Odd => {
                vec![arc([1.0, 1.0], false), arc([1.0, -1.0], true), arc([-1.0, 1.0], true)]
            }
        }
    }

    fn parity(&self) -> Parity {
        match (self.numerator % 2 == 0, self.denominator.is_multiple_of(2)) {
            (_, true) => Parity::Undefined,
            (true, false) => Parity::Even,
            (false, false) => Parity::Odd,
        }
    }
}

/// The part of a Lame curve within one quadrant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LameArc {
    curve: LameCurve,
    signs: [f64; 2],
    /// Whether one power is negative, so that the other exceeds 1.
    is_outer: bool,
}

impl Curve for LameArc {
    fn range(&self) -> [f64; 2] {
        [0.0, FRAC_PI_2]
    }

    /// Powers `2/m` of cosine and sine, whose squares add up to 1, or of secant and tangent,
    /// whose squares differ by 1.
    fn at(&self, theta: f64) -> CurvePoint {
        let [a, b] = self.curve.size;
        let [sign_x, sign_y] = self.signs;
        let e = 2.0 / self.curve.exponent();
        let components = match (self.is_outer, sign_x > 0.0) {
            (false, _) => Jet::cos_sin(theta),
            (true, true) => Jet::sec_tan(theta),
            (true, false) => {
                let [sec, tan] = Jet::sec_tan(theta);
                [tan, sec]
            }
        };
        let [x, y] = components;
        CurvePoint::of_components([x.power(e, sign_x * a), y.power(e, sign_y * b)])
    }
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An exponent of each of JLS's nine kinds, and the arcs that Fig. 2.3 shows.
    const KINDS: [(u8, i32, u32, usize); 9] = [
        (1, 8, 3, 4),
        (2, 2, 3, 4),
        (3, 5, 2, 1),
        (4, 1, 2, 1),
        (5, 3, 1, 3),
        (6, 1, 3, 3),
        (7, -2, 1, 4),
        (8, -3, 2, 1),
        (9, -1, 1, 3),
    ];

    #[test]
    fn all_nine_kinds_satisfy_their_equation_in_their_quadrants() {
        for (kind, numerator, denominator, arcs) in KINDS {
            let curve = LameCurve::new([2.0, 0.3], 2 * numerator, 2 * denominator).unwrap();
            assert_eq!((curve.kind(), curve.arcs().len()), (kind, arcs));
            for arc in curve.arcs() {
                for theta in [0.1, 0.5, 1.0, 1.4] {
                    let x = arc.at(theta).position;
                    assert!(x.x * arc.signs[0] > 0.0 && x.y * arc.signs[1] > 0.0);
                    let power = (x.x / 2.0).abs().powf(curve.exponent());
                    let defect = (curve.implicit(&x) - 1.0).abs();
                    assert!(defect < 1e-13 * power.max(1.0), "{kind} {theta} {x}");
                }
            }
        }
    }

    #[test]
    fn derivatives_are_difference_quotients() {
        let h = 1e-5;
        for (kind, numerator, denominator, _) in KINDS {
            for arc in LameCurve::new([2.0, 0.3], numerator, denominator).unwrap().arcs() {
                for theta in [0.3, 0.8, 1.2] {
                    let [before, point, after] = [theta - h, theta, theta + h].map(|t| arc.at(t));
                    let tangent = (after.position - before.position) / (2.0 * h);
                    let second = (after.tangent - before.tangent) / (2.0 * h);
                    let bound = |v: Vector2<f64>| 1e-7 * (1.0 + v.norm());
                    assert!((tangent - point.tangent).norm() < bound(point.tangent), "{kind}");
                    assert!((second - point.second).norm() < bound(point.second), "{kind}");
                }
            }
        }
    }

    #[test]
    fn fractions_that_are_none_are_refused() {
        assert!(LameCurve::new([1.0, 1.0], 0, 1).is_err());
        assert!(LameCurve::new([1.0, 1.0], 1, 0).is_err());
        assert!(LameCurve::new([1.0, -1.0], 2, 1).is_err());
    }
}
