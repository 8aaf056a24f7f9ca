//! Points along half a branch of a superhyperbola.

use super::Parameterization;
use super::equal_distance::evenly_spread;
use crate::shape::superellipse_norm;

/// Chords of the table from which equal distances are read.
const TABLE_STEPS: usize = 4096;

impl Parameterization {
    /// Values of y in units of b, in `n` steps from 0 to `top`, along the branch `x > 0` of
    /// `(x/a)^(2/e) - (y/b)^(2/e) = 1`.
    ///
    /// The coordinate that changes faster is y, for exponents up to 2.
    pub(super) fn half_branch(self, [a, b]: [f64; 2], e: f64, top: f64, n: usize) -> Vec<f64> {
        let share = |i: usize| i as f64 / n as f64;
        let across = |y: f64| superellipse_norm(1.0, y, e);
        let inner: Vec<f64> = match self {
            Self::Trigonometric => {
                let greatest = top.powf(e.recip()).atan();
                (1..n).map(|i| (greatest * share(i)).tan().powf(e)).collect()
            }
            Self::Explicit => (1..n).map(|i| top * share(i)).collect(),
            Self::AngleCentre => {
                let steepest = (b * top).atan2(a * across(top));
                let slope = |i: usize| (steepest * share(i)).tan() * a / b;
                // On the ray y = slope x, (1 - slope^(2/e)) x^(2/e) = 1.
                (1..n)
                    .map(slope)
                    .map(|s| s * (-(2.0 / e * s.ln()).exp_m1()).powf(-0.5 * e))
                    .collect()
            }
            Self::EqualDistance => {
                let point = |share: f64| [a * across(top * share), b * top * share];
                evenly_spread(point, TABLE_STEPS, n).map(|share| top * share).collect()
            }
        };
        std::iter::once(0.0).chain(inner).chain(std::iter::once(top)).collect()
    }
}
