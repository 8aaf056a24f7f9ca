//! Equal steps of the coordinate that changes faster (FB81).

use crate::shape::log_shift;

/// Points from `(a, 0)` to `(0, b)`: of the unit curve `x^(2/e1) + y^(2/e2) = 1`, equal steps of y up
/// to the diagonal, and of x beyond. An odd `n` is made even.
pub(super) fn quarter([a, b]: [f64; 2], [e1, e2]: [f64; 2], n: usize) -> Vec<[f64; 2]> {
    let half = n.div_ceil(2);
    let diagonal = log_shift(&[e1, e2].map(|e| (2.0 / e, 0.0)), 0.0).exp();
    // The coordinate of exponent `own` at step i, and the other one calculated from it.
    let octant = |i: usize, [own, other]: [f64; 2]| {
        let step = diagonal * i as f64 / half as f64;
        // At the diagonal itself, both coordinates are the same.
        let calculated =
            if i == half { diagonal } else { (1.0 - step.powf(2.0 / own)).powf(0.5 * other) };
        [step, calculated]
    };
    let first = (0..half).map(|i| octant(i, [e2, e1])).map(|[y, x]| [x, y]);
    let second = (0..=half).rev().map(|i| octant(i, [e1, e2]));
    first.chain(second).map(|[x, y]| [a * x, b * y]).collect()
}
