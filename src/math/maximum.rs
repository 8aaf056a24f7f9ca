//! The greatest value of a function of one variable.

use std::f64::consts::PI;

/// Places at which a function is looked at before its greatest value is closed in on.
const LOOKS: usize = 64;

/// Steps of the golden section: brackets shrink by 1e-12.
const STEPS: usize = 60;

/// The greatest value of a continuous function on an interval: exact to rounding where it has one
/// hump, or humps no narrower than a sixtieth of the interval.
pub(crate) fn maximum(f: impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> f64 {
    // Dense towards the ends, where powers bend.
    let place = |i: usize| {
        let share = 0.5 - 0.5 * (PI * i as f64 / LOOKS as f64).cos();
        from + (to - from) * share
    };
    let values: Vec<f64> = (0..=LOOKS).map(|i| f(place(i))).collect();
    let best = (0..=LOOKS).fold(0, |best, i| if values[i] > values[best] { i } else { best });
    let (mut low, mut high) = (place(best.saturating_sub(1)), place((best + 1).min(LOOKS)));
    let mut greatest = values[best];
    let golden = 0.5 * (3.0 - 5.0_f64.sqrt());
    for _ in 0..STEPS {
        let [left, right] = [low + golden * (high - low), high - golden * (high - low)];
        let [at_left, at_right] = [f(left), f(right)];
        greatest = greatest.max(at_left).max(at_right);
        if at_left > at_right { high = right } else { low = left }
    }
    greatest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn humps_ends_and_corners_are_found() {
        for (found, expected) in [
            (maximum(|x| x * (1.0 - x), [0.0, 1.0]), 0.25),
            (maximum(|x| x, [0.0, 3.0]), 3.0),
            (maximum(|x| -(x - 0.3).abs(), [0.0, 1.0]), 0.0),
            (maximum(|x| (1.0 - x.powf(20.0)).powf(0.05) + x, [0.0, 1.0]), 1.931872657847691),
        ] {
            assert!((found - expected).abs() < 1e-10, "{found} {expected}");
        }
    }
}
