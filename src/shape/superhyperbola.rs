//! The superhyperbola (B81 Fig. 6).

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector2;

use super::curve::{Curve, CurvePoint, Jet};
use crate::error::ModelError;

/// The plane curve `|x/a|^(2/e) - |y/b|^(2/e) = 1` with semi-axes a, b in the model's unit: two
/// branches, open towards x. Domain: any positive exponent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Superhyperbola {
    size: [f64; 2],
    exponent: f64,
}

impl Superhyperbola {
    /// A superhyperbola of semi-axes `[a, b]` and an exponent e.
    ///
    /// # Errors
    /// If one of them is not a positive, finite number.
    pub fn new(size: [f64; 2], exponent: f64) -> Result<Self, ModelError> {
        super::validated_size(&size)?;
        super::validated_exponents(&[exponent])?;
        Ok(Self { size, exponent })
    }

    /// A superhyperbola of semi-axes and an exponent known to be valid.
    pub(crate) fn of(size: [f64; 2], exponent: f64) -> Self {
        Self { size, exponent }
    }

    /// Semi-axes `[a, b]`.
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// The exponent e.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// The curve's function `|x/a|^(2/e) - |y/b|^(2/e)`: 1 on the curve.
    pub fn implicit(&self, x: &Vector2<f64>) -> f64 {
        let [u, v] = [x.x / self.size[0], x.y / self.size[1]].map(f64::abs);
        let power = 2.0 / self.exponent;
        u.powf(power) - v.powf(power)
    }
}

impl Curve for Superhyperbola {
    /// That of the branch of positive x; half a turn leads to the other.
    fn range(&self) -> [f64; 2] {
        [-FRAC_PI_2, FRAC_PI_2]
    }

    /// The point `(a sec^e, b tan^e)` (B81).
    fn at(&self, theta: f64) -> CurvePoint {
        let [sec, tan] = Jet::sec_tan(theta);
        let [a, b] = self.size;
        CurvePoint::of_components([sec.power(self.exponent, a), tan.power(self.exponent, b)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_branches_satisfy_the_equation() {
        for e in [0.1, 0.5, 1.0, 2.0, 3.0] {
            let curve = Superhyperbola::new([2.0, 0.3], e).unwrap();
            for theta in [-1.2, -0.3, 0.0, 0.4, 1.0] {
                let [first, second] =
                    [theta, theta + 2.0 * FRAC_PI_2].map(|t| curve.at(t).position);
                assert!(first.x >= 2.0 && second.x <= -2.0);
                for x in [first, second] {
                    let powers = (x.x / 2.0).abs().powf(2.0 / e);
                    assert!((curve.implicit(&x) - 1.0).abs() < 1e-12 * powers, "{e} {theta}");
                }
            }
        }
    }
}
