//! Equal steps of the angle whose sine and cosine are raised to the exponent.

use std::f64::consts::FRAC_PI_2;

/// Points from `(a, 0)` to `(0, b)`. The angle is taken from the nearer axis, so that both ends
/// are on their axes.
pub(super) fn quarter([a, b]: [f64; 2], e: f64, n: usize) -> Vec<[f64; 2]> {
    let sine = |i: usize| (FRAC_PI_2 * i as f64 / n as f64).sin();
    let cosine = |i: usize| (FRAC_PI_2 * i as f64 / n as f64).cos();
    let point = |i: usize| {
        let j = n - i;
        let [cos, sin] = if i < j { [cosine(i), sine(i)] } else { [sine(j), cosine(j)] };
        [a * cos.powf(e), b * sin.powf(e)]
    };
    (0..=n).map(point).collect()
}
