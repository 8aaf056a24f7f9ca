//! Enclosures hold what they enclose.

use super::*;
use crate::math::Scalar;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::PI;

const SAMPLES: usize = 2000;

/// A random interval, some of them thin, and a number of it.
fn draw(rng: &mut ChaCha8Rng) -> (Interval, f64) {
    let scale = 10_f64.powi(rng.random_range(-3..=1));
    let a = scale * (2.0 * rng.random::<f64>() - 1.0);
    let width = if rng.random::<f64>() < 0.2 { 0.0 } else { scale * rng.random::<f64>() };
    let number = a + width * rng.random::<f64>();
    (Interval::new(a, a + width), number.clamp(a, a + width))
}

#[test]
fn results_hold_those_of_every_number() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    for _ in 0..SAMPLES {
        let ((a, x), (b, y)) = (draw(&mut rng), draw(&mut rng));
        let held = [
            (a + b, x + y),
            (a - b, x - y),
            (a * b, x * y),
            (a * 3.7, x * 3.7),
            (a + 3.7, x + 3.7),
            (a.recip(), x.recip()),
            (a.abs(), x.abs()),
            (a.sin(), x.sin()),
            (a.cos(), x.cos()),
            (a.atan2(b), x.atan2(y)),
            (a.clamp(-0.2, 0.4), x.clamp(-0.2, 0.4)),
            (a.excess(-0.2, 0.4), x - x.clamp(-0.2, 0.4)),
        ];
        for (case, (enclosure, value)) in held.into_iter().enumerate() {
            assert!(enclosure.contains(value), "{case}: {a:?} {b:?} {enclosure:?} {value}");
        }
    }
}

#[test]
fn norms_and_their_slopes_are_enclosed_for_every_exponent() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    for e in [0.05, 0.1, 0.5, 1.0, 1.9, 2.0, 3.0] {
        for _ in 0..SAMPLES {
            let [(a, x), (b, y)] = [draw(&mut rng), draw(&mut rng)];
            let ([u, v], [x, y]) = ([a.abs(), b.abs()], [x.abs(), y.abs()]);
            let norm = Scalar::superellipse_norm(x, y, e);
            assert!(Interval::superellipse_norm(u, v, e).contains(norm), "{e} {u:?} {v:?}");
            let slope = (x / norm).powf(2.0 / e - 1.0);
            let slopes = Interval::superellipse_norm_slope(u, v, e);
            assert!(slopes.contains(slope), "{e} {u:?} {v:?} {slope} {slopes:?}");
        }
    }
}

#[test]
fn enclosures_are_tight_where_a_function_is_monotone() {
    let interval = Interval::new(0.3, 0.4);
    for (enclosure, ends) in [
        (interval.sin(), [0.3_f64.sin(), 0.4_f64.sin()]),
        (interval.cos(), [0.4_f64.cos(), 0.3_f64.cos()]),
        (interval.recip(), [2.5, 1.0 / 0.3]),
    ] {
        assert!((enclosure.lo() - ends[0]).abs() < 1e-15);
        assert!((enclosure.hi() - ends[1]).abs() < 1e-15);
    }
    assert_eq!(Interval::new(0.5, 7.0).sin(), Interval::new(-1.0, 1.0));
    let around = Interval::new(-0.1, 0.1).atan2(Interval::new(-1.0, 1.0));
    assert!(around.contains(-PI) && around.contains(PI));
}

#[test]
fn what_is_not_a_number_is_any_number() {
    assert_eq!(Interval::new(f64::NAN, 1.0), Interval::ENTIRE);
    assert_eq!(Interval::ENTIRE - Interval::ENTIRE, Interval::ENTIRE);
    assert_eq!(Interval::new(-1.0, 1.0).recip(), Interval::ENTIRE);
    assert!((Interval::ZERO * Interval::ENTIRE).width() < 1e-300);
    assert_eq!(Interval::ENTIRE.sin(), Interval::new(-1.0, 1.0));
}
