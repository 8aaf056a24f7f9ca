//! The root of a function between two places.

/// Evaluations after which a bracket is taken as it is; bisection alone needs fewer.
const EVALUATIONS: usize = 120;

/// Where an increasing function turns from negative to positive, or the end of the interval that
/// it points to; by Chandrupatla's (1997) choice between bisection and inverse quadratic
/// interpolation, some ten evaluations.
///
/// An end where the function vanishes does not count, but what is beside it.
pub(crate) fn increasing_root(f: impl Fn(f64) -> f64, [low, high]: [f64; 2]) -> f64 {
    let beside = |end: f64, other: f64| {
        let value = f(end);
        if value == 0.0 {
            let place = end + 1e-9 * (other - end);
            (place, f(place))
        } else {
            (end, value)
        }
    };
    let (from, to) = (beside(low, high), beside(high, low));
    if from.1 >= 0.0 {
        return low;
    }
    if to.1 <= 0.0 {
        return high;
    }
    bracketed(f, from, to)
}

/// The root between two places of opposite signs, each with its value.
fn bracketed(f: impl Fn(f64) -> f64, mut b: (f64, f64), mut a: (f64, f64)) -> f64 {
    let mut share = 0.5;
    for _ in 0..EVALUATIONS {
        let place = a.0 + share * (b.0 - a.0);
        let next = (place, f(place));
        let c = if next.1.is_sign_negative() == a.1.is_sign_negative() {
            a
        } else {
            let dropped = b;
            b = a;
            dropped
        };
        a = next;
        let best = if b.1.abs() < a.1.abs() { b } else { a };
        let tolerance = 2.0 * f64::EPSILON * best.0.abs() + f64::MIN_POSITIVE;
        let least_share = tolerance / (b.0 - a.0).abs();
        // Written so that a bracket of no width ends it too.
        let is_open = least_share < 0.5 && best.1 != 0.0;
        if !is_open {
            return best.0;
        }
        share = interpolated(a, b, c).unwrap_or(0.5).clamp(least_share, 1.0 - least_share);
    }
    a.0
}

/// The share of the way from a to b at which the inverse parabola through three places vanishes,
/// if it is a trustworthy one.
fn interpolated(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> Option<f64> {
    let xi = (a.0 - b.0) / (c.0 - b.0);
    let phi = (a.1 - b.1) / (c.1 - b.1);
    let is_trustworthy = phi * phi < xi && (1.0 - phi).powi(2) < 1.0 - xi;
    let share = || {
        a.1 / (b.1 - a.1) * c.1 / (b.1 - c.1)
            + (c.0 - a.0) / (b.0 - a.0) * a.1 / (c.1 - a.1) * b.1 / (c.1 - b.1)
    };
    is_trustworthy.then(share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::signed_power;
    use std::cell::Cell;

    #[test]
    fn roots_are_found_in_few_evaluations() {
        for (exponent, expected, most) in
            [(2.0, 0.7, 14), (9.0, 0.1, 40), (1.0 / 3.0, 0.3, 80), (1.0, 1e-12, 20)]
        {
            let count = Cell::new(0);
            let counted = |x: f64| {
                count.set(count.get() + 1);
                signed_power(x, exponent) - signed_power(expected, exponent)
            };
            let root = increasing_root(counted, [0.0, 1.0]);
            assert!((root / expected - 1.0).abs() < 1e-14, "{root} {expected}");
            assert!(count.get() <= most, "{} evaluations for {expected}", count.get());
        }
    }

    #[test]
    fn without_a_root_it_is_the_end_that_the_function_points_to() {
        assert_eq!(increasing_root(|x| x + 1.0, [0.0, 1.0]), 0.0);
        assert_eq!(increasing_root(|x| x - 2.0, [0.0, 1.0]), 1.0);
        // It vanishes at an end, and turns beside it.
        assert_eq!(increasing_root(|x| x, [0.0, 1.0]), 0.0);
        assert_eq!(increasing_root(|x| x - 1.0, [0.0, 1.0]), 1.0);
        let root = increasing_root(|x| x * (x - 0.5), [0.0, 1.0]);
        assert!((root - 0.5).abs() < 1e-15);
    }
}
