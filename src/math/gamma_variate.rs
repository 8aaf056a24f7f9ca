//! Random numbers of a gamma distribution.

use rand::{Rng, RngExt};

/// The gamma distribution of a shape parameter `k >= 1` and scale 1 (Marsaglia and Tsang 2000,
/// "A simple method for generating gamma variables").
#[derive(Debug, Clone, Copy)]
pub(crate) struct GammaVariate {
    d: f64,
    c: f64,
}

impl GammaVariate {
    /// The distribution of shape parameter `k >= 1`.
    pub fn new(k: f64) -> Self {
        let d = k - 1.0 / 3.0;
        Self { d, c: 1.0 / (9.0 * d).sqrt() }
    }

    /// Draws a number; about 1.05 tries of one normal and one uniform number each.
    pub fn draw(&self, rng: &mut impl Rng) -> f64 {
        loop {
            let x = standard_normal(rng);
            let v = (1.0 + self.c * x).powi(3);
            let log_u = (1.0 - rng.random::<f64>()).ln();
            if v > 0.0 && log_u < 0.5 * x * x + self.d * (1.0 - v + v.ln()) {
                return self.d * v;
            }
        }
    }
}

/// A number of the standard normal distribution, by Marsaglia's polar method.
fn standard_normal(rng: &mut impl Rng) -> f64 {
    loop {
        let [u, v] = [(); 2].map(|()| 2.0 * rng.random::<f64>() - 1.0);
        let s = u * u + v * v;
        if s > 0.0 && s < 1.0 {
            return u * (-2.0 * s.ln() / s).sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn first_three_cumulants_are_those_of_the_distribution() {
        const COUNT: f64 = 2e5;
        for k in [1.0, 1.025, 1.5, 2.0, 3.0] {
            let mut rng = ChaCha8Rng::seed_from_u64(1);
            let gamma = GammaVariate::new(k);
            let deviations: Vec<f64> =
                (0..COUNT as u32).map(|_| gamma.draw(&mut rng) - k).collect();
            let moment = |p: i32| deviations.iter().map(|d| d.powi(p)).sum::<f64>() / COUNT;
            // Central moments k, k, 2k; five standard errors, from the moments
            // mu4 = 3k^2 + 6k and mu6 = 15k^3 + 130k^2 + 120k.
            let bound = |variance: f64| 5.0 * (variance / COUNT).sqrt();
            assert!(moment(1).abs() < bound(k), "{k}");
            assert!((moment(2) - k).abs() < bound(2.0 * k * k + 6.0 * k), "{k}");
            let mu6 = 15.0 * k.powi(3) + 130.0 * k * k + 120.0 * k;
            assert!((moment(3) - 2.0 * k).abs() < bound(mu6), "{k}");
        }
    }
}
