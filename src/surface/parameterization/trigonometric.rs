//! Equal steps of the angle whose sine and cosine are raised to exponents.

use std::f64::consts::FRAC_PI_2;

/// Points from `(a, 0)` to `(0, b)`, `(a cos^e1, b sin^e2)`. The angle is taken from the nearer axis, so that both ends
/// are on their axes.
pub(super) fn quarter([a, b]: [f64; 2], [e1, e2]: [f64; 2], n: usize) -> Vec<[f64; 2]> {
    let sine = |i: usize| (FRAC_PI_2 * i as f64 / n as f64).sin();
    let cosine = |i: usize| (FRAC_PI_2 * i as f64 / n as f64).cos();
    let point = |i: usize| {
        let j = n - i;
        let [cos, sin] = if i < j { [cosine(i), sine(i)] } else { [sine(j), cosine(j)] };
        [a * cos.powf(e1), b * sin.powf(e2)]
    };
    (0..=n).map(point).collect()
}
