//! The support function of the solid of three exponents.

use nalgebra::Vector3;

use super::{ThreeExponent, log_shift};
use crate::math::maximum;

impl ThreeExponent {
    /// The greatest `sum b U^(1/n)` of shares U that add up to 1, b being the components of the
    /// direction times the semi-axes.
    ///
    /// Terms of `n > 1` are concave in U. Of the others, convex, at most one has a share at the
    /// greatest sum.
    pub(super) fn greatest_projection(&self, direction: &Vector3<f64>) -> f64 {
        let mut concave = Vec::with_capacity(3);
        let mut convex = Vec::with_capacity(3);
        for axis in 0..3 {
            let weight = direction[axis].abs() * self.size[axis];
            let n = self.exponents[axis];
            match (weight > 0.0, n > 1.0) {
                (false, _) => {}
                (true, true) => concave.push((weight, n)),
                (true, false) => convex.push((weight, n)),
            }
        }
        let with_one = |&(weight, n): &(f64, f64)| {
            let sum = |share: f64| weight * share.powf(1.0 / n) + of_concave(&concave, 1.0 - share);
            maximum(sum, [0.0, 1.0])
        };
        convex.iter().map(with_one).fold(of_concave(&concave, 1.0), f64::max)
    }
}

/// The greatest `sum b U^(1/n)`, all `n > 1`, of shares U that add up to `total`: all terms grow at
/// the same rate, `b/n U^(1/n - 1) = exp(-shift)`.
fn of_concave(terms: &[(f64, f64)], total: f64) -> f64 {
    if terms.is_empty() || total <= 0.0 {
        return 0.0;
    }
    let rates: Vec<(f64, f64)> =
        terms.iter().map(|&(b, n)| (n / (n - 1.0), (b / n).ln())).collect();
    let shift = log_shift(&rates, total.ln());
    let term = |(&(b, n), &(conjugate, log_rate)): (&(f64, f64), &(f64, f64))| {
        b * (conjugate / n * (shift + log_rate)).exp()
    };
    terms.iter().zip(&rates).map(term).sum()
}
