//! Points of the surface among strays: a mixture of normal distances from the model, and of
//! points anywhere in the cloud's box.
//!
//! A point of the surface has a normal geometric distance and lies anywhere on the area A that is
//! seen, a stray anywhere in the volume V: densities `N(d; 0, s^2) / A` and `1 / V`. What a
//! point's neighbours say ([`Clutter`](super::clutter::Clutter)) multiplies the ratio of both.

use std::f64::consts::TAU;

use crate::machine::{Products, vectorized};
use crate::math::elementary::{exp, ln_ratio};
use crate::math::lane::{Lane, greater};
use crate::math::{lane_dot, lane_sum};

/// Least standard deviation, in normalised units: beside it the arithmetic's own errors show.
const LEAST_DEVIATION: f64 = 1e-7;

/// Bounds of the share of strays while it is estimated: neither part may vanish for good.
const SHARE_BOUNDS: [f64; 2] = [1e-6, 0.95];

/// Where the two kinds of points lie, in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Room {
    /// Area on which the points of the surface lie.
    pub area: f64,
    /// Volume that the strays fill.
    pub volume: f64,
}

/// The parameters of the mixture, in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mixture {
    /// Variance of the surface points' distances.
    pub variance: f64,
    /// Share of strays among the points.
    pub stray_share: f64,
    /// Where both lie.
    pub room: Room,
}

/// What the points say of a mixture around one model.
#[derive(Debug, Clone)]
pub(crate) struct Expectation {
    /// Probability of each point to be one of the surface.
    pub weights: Vec<f64>,
    /// Mean logarithm of the points' density.
    pub log_likelihood: f64,
    /// The mixture that the weights make most likely.
    pub next: Mixture,
}

impl Mixture {
    /// The expectation (the E step) around a model that has these squared distances, and the
    /// mixture's own part of the maximisation. `odds` are what neighbours say of each point.
    pub fn expect(&self, squares: &[f64], odds: Option<&[f64]>) -> Expectation {
        let (weights, logs) = vectorized::run(Densities { mixture: self, squares, odds });
        let log_likelihood = lane_sum(&logs) / squares.len() as f64;
        let next = self.most_likely(&weights, squares);
        Expectation { weights, log_likelihood, next }
    }

    /// The mean logarithm of the points' density once this mixture has settled, in so many rounds,
    /// around a model that stays as it is.
    pub fn settled_log_likelihood(mut self, squares: &[f64], rounds: usize) -> f64 {
        for _ in 0..rounds {
            self = self.expect(squares, None).next;
        }
        self.expect(squares, None).log_likelihood
    }

    /// The mixture's part of the maximisation (the M step).
    fn most_likely(&self, weights: &[f64], squares: &[f64]) -> Self {
        let near = lane_sum(weights);
        let spread = lane_dot(weights, squares);
        let [low, high] = SHARE_BOUNDS;
        Self {
            variance: spread / near.max(f64::MIN_POSITIVE),
            stray_share: (1.0 - near / squares.len() as f64).clamp(low, high),
            ..*self
        }
    }
}

/// The density of each point.
struct Densities<'a> {
    mixture: &'a Mixture,
    squares: &'a [f64],
    odds: Option<&'a [f64]>,
}

impl vectorized::Kernel for Densities<'_> {
    /// The surface's share of each point's density, and the logarithm of both parts together.
    type Output = (Vec<f64>, Vec<f64>);

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) -> Self::Output {
        let Mixture { variance, stray_share, room } = *self.mixture;
        let variance = variance.max(LEAST_DEVIATION * LEAST_DEVIATION);
        let surface = (1.0 - stray_share) / (room.area * (TAU * variance).sqrt());
        let stray = stray_share / room.volume;
        let count = self.squares.len();
        let (mut weights, mut logs) = (vec![surface; count], vec![0.0; count]);
        if let Some(odds) = self.odds {
            weights.iter_mut().zip(odds).for_each(|(weight, odds)| *weight *= odds);
        }
        let columns = weights.iter_mut().zip(&mut logs).zip(self.squares);
        for ((weight, log), square) in columns {
            let exponent = greater(-0.5 * square / variance, f64::LOG_FLOOR);
            let near = *weight * exp::<FMA, f64>(exponent);
            let both = greater(near + stray, f64::MIN_POSITIVE);
            *weight = near / both;
            *log = ln_ratio::<FMA, f64>(both, 1.0);
        }
        (weights, logs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOM: Room = Room { area: 12.0, volume: 64.0 };

    #[test]
    fn points_near_the_surface_and_far_from_it_are_told_apart_and_their_noise_is_found() {
        // Two hundred distances of variance 1e-4, one hundred far off.
        let near = (0..200).map(|i| if i % 2 == 0 { 1e-4 } else { 1.000_001e-4 });
        let far = (0..100).map(|i| 0.25 + 0.01 * f64::from(i));
        let squares: Vec<f64> = near.chain(far).collect();
        let mut mixture = Mixture { variance: 0.01, stray_share: 0.5, room: ROOM };
        for _ in 0..20 {
            mixture = mixture.expect(&squares, None).next;
        }
        assert!((mixture.variance / 1e-4 - 1.0).abs() < 0.01, "{mixture:?}");
        assert!((mixture.stray_share - 1.0 / 3.0).abs() < 0.02, "{mixture:?}");
    }

    #[test]
    fn each_step_makes_the_points_more_likely() {
        let squares: Vec<f64> = (0..100).map(|i| 1e-4 * f64::from(i * i)).collect();
        let mut mixture = Mixture { variance: 1.0, stray_share: 0.5, room: ROOM };
        let mut before = f64::NEG_INFINITY;
        for _ in 0..30 {
            let expectation = mixture.expect(&squares, None);
            // But for rounding.
            assert!(expectation.log_likelihood >= before - 1e-14);
            before = expectation.log_likelihood;
            mixture = expectation.next;
        }
    }

    #[test]
    fn neighbours_decide_where_the_distance_does_not() {
        let mixture = Mixture { variance: 0.01, stray_share: 0.5, room: ROOM };
        let weights = mixture.expect(&[0.02; 2], Some(&[50.0, 0.02])).weights;
        assert!(weights[0] > 0.9 && weights[1] < 0.2, "{weights:?}");
    }

    #[test]
    fn a_perfect_fit_has_no_noise_and_no_strays_and_stays_a_number() {
        let mut mixture = Mixture { variance: 1e-3, stray_share: 0.5, room: ROOM };
        for _ in 0..5 {
            mixture = mixture.expect(&[0.0; 50], None).next;
        }
        assert_eq!((mixture.variance, mixture.stray_share), (0.0, SHARE_BOUNDS[0]));
        assert!(mixture.expect(&[0.0; 50], None).log_likelihood.is_finite());
    }
}
