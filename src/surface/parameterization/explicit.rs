//! Equal steps of the coordinate that changes faster (FB81).

/// Points from `(a, 0)` to `(0, b)`: of the unit curve, equal steps of y up to the diagonal, and
/// their reflections in it. An odd `n` is made even.
pub(super) fn quarter([a, b]: [f64; 2], e: f64, n: usize) -> Vec<[f64; 2]> {
    let half = n.div_ceil(2);
    let diagonal = 0.5_f64.powf(0.5 * e);
    let octant = |i: usize| {
        let y = diagonal * i as f64 / half as f64;
        // At the diagonal itself, both coordinates are the same.
        let x = if i == half { diagonal } else { (1.0 - y.powf(2.0 / e)).powf(0.5 * e) };
        [x, y]
    };
    let first = (0..half).map(octant);
    let second = (0..=half).rev().map(octant).map(|[x, y]| [y, x]);
    first.chain(second).map(|[x, y]| [a * x, b * y]).collect()
}
