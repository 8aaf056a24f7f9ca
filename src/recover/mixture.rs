//! Points of the surface among strays: a mixture of normal distances from the model, and of
//! points anywhere in the cloud's box.
//!
//! A point of the surface has a normal geometric distance and lies anywhere on the area A, a
//! stray anywhere in the volume V: densities `N(d; 0, s^2) / A` and `1 / V`.

use std::f64::consts::TAU;

use crate::model::Model;
use crate::shape::Superellipsoid;

/// Least standard deviation, in normalised units: beside it the arithmetic's own errors show.
const LEAST_DEVIATION: f64 = 1e-7;

/// Bounds of the share of strays while it is estimated: neither part may vanish for good.
const SHARE_BOUNDS: [f64; 2] = [1e-6, 0.95];

/// The parameters of the mixture, in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mixture {
    /// Variance of the surface points' distances.
    pub variance: f64,
    /// Share of strays among the points.
    pub stray_share: f64,
    /// Volume that the strays fill.
    pub volume: f64,
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
    /// mixture's own part of the maximisation.
    pub fn expect(&self, model: &Model, squares: &[f64]) -> Expectation {
        let variance = self.variance.max(LEAST_DEVIATION * LEAST_DEVIATION);
        let area = approximate_area(&model.shape);
        let surface = (1.0 - self.stray_share) / (area * (TAU * variance).sqrt());
        let stray = self.stray_share / self.volume;
        let mut log_likelihood = 0.0;
        let weights: Vec<f64> = squares
            .iter()
            .map(|square| {
                let near = surface * (-0.5 * square / variance).exp();
                log_likelihood += (near + stray).ln();
                near / (near + stray)
            })
            .collect();
        let count = squares.len() as f64;
        let near: f64 = weights.iter().sum();
        let spread: f64 = weights.iter().zip(squares).map(|(w, square)| w * square).sum();
        let [low, high] = SHARE_BOUNDS;
        let next = Self {
            variance: spread / near.max(f64::MIN_POSITIVE),
            stray_share: (1.0 - near / count).clamp(low, high),
            ..*self
        };
        Expectation { weights, log_likelihood: log_likelihood / count, next }
    }
}

/// The surface's area, to about a fifth: that of the ellipsoid (K. Thomsen's formula), scaled as
/// the volumes' ratio to the power 2/3. A prior needs no better.
fn approximate_area(shape: &Superellipsoid) -> f64 {
    const POWER: f64 = 1.6075;
    let [a, b, c] = shape.size();
    let mean = ((a * b).powf(POWER) + (a * c).powf(POWER) + (b * c).powf(POWER)).powf(1.0 / POWER);
    let ellipsoid = 2.0 * TAU * mean / 3.0_f64.powf(1.0 / POWER);
    let volume_ratio = shape.volume() / (2.0 * TAU / 3.0 * a * b * c);
    ellipsoid * volume_ratio.powf(2.0 / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;

    fn sphere() -> Model {
        let shape = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        Model { shape, pose: Pose::identity() }
    }

    #[test]
    fn areas_of_sphere_cube_and_octahedron_are_right_to_a_fifth() {
        let area = |e| approximate_area(&Superellipsoid::new([2.0; 3], [e; 2]).unwrap());
        for (e, exact) in [(1.0, 2.0 * TAU * 4.0), (0.01, 96.0), (2.0, 16.0 * 3.0_f64.sqrt())] {
            assert!((area(e) / exact - 1.0).abs() < 0.2, "{e}: {} {exact}", area(e));
        }
        assert!((area(1.0) / (2.0 * TAU * 4.0) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn points_near_the_surface_and_far_from_it_are_told_apart_and_their_noise_is_found() {
        // Two hundred distances of variance 1e-4, one hundred far off.
        let near = (0..200).map(|i| if i % 2 == 0 { 1e-4 } else { 1.000_001e-4 });
        let far = (0..100).map(|i| 0.25 + 0.01 * f64::from(i));
        let squares: Vec<f64> = near.chain(far).collect();
        let mut mixture = Mixture { variance: 0.01, stray_share: 0.5, volume: 64.0 };
        for _ in 0..20 {
            mixture = mixture.expect(&sphere(), &squares).next;
        }
        assert!((mixture.variance / 1e-4 - 1.0).abs() < 0.01, "{mixture:?}");
        assert!((mixture.stray_share - 1.0 / 3.0).abs() < 0.02, "{mixture:?}");
    }

    #[test]
    fn each_step_makes_the_points_more_likely() {
        let squares: Vec<f64> = (0..100).map(|i| 1e-4 * f64::from(i * i)).collect();
        let mut mixture = Mixture { variance: 1.0, stray_share: 0.5, volume: 64.0 };
        let mut before = f64::NEG_INFINITY;
        for _ in 0..30 {
            let expectation = mixture.expect(&sphere(), &squares);
            assert!(expectation.log_likelihood >= before - 1e-12);
            before = expectation.log_likelihood;
            mixture = expectation.next;
        }
    }
}
