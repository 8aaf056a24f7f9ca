//! A low-discrepancy sequence in the unit cube, for quasi-Monte Carlo integration.

use rand::{Rng, RngExt};

/// Fractional parts of 2^(1/4), 2^(1/2), 2^(3/4), in units of 2^-64. With 1 they are a basis of
/// a field of algebraic numbers, so no small multiples of them come near an integer together.
const STEPS: [u64; 3] = [0x306f_e0a3_1b71_52de, 0x6a09_e667_f3bc_c908, 0xae89_f995_ad3a_d5e8];

/// The points `frac(s + n alpha)`, n = 1, 2, ..., of a Kronecker sequence (Niederreiter 1992,
/// section 3.2) with a random shift s (Cranley and Patterson 1976), in fixed-point arithmetic
/// that never rounds.
#[derive(Debug, Clone)]
pub(super) struct ShiftedKronecker {
    state: [u64; 3],
}

impl ShiftedKronecker {
    /// The sequence with a shift drawn from `rng`.
    pub fn new(rng: &mut impl Rng) -> Self {
        Self { state: [(); 3].map(|()| rng.random()) }
    }

    /// The next point, coordinates in [0, 1).
    pub fn draw(&mut self) -> [f64; 3] {
        const UNIT: f64 = 1.0 / (1_u64 << 53) as f64;
        std::array::from_fn(|i| {
            self.state[i] = self.state[i].wrapping_add(STEPS[i]);
            (self.state[i] >> 11) as f64 * UNIT
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn steps_are_fractional_parts_of_powers() {
        for (i, step) in STEPS.into_iter().enumerate() {
            let expected = 2.0_f64.powf(0.25 * (i as f64 + 1.0)).fract();
            // The rounding of doubles.
            assert!((step as f64 / 2.0_f64.powi(64) - expected).abs() < 1e-15);
        }
    }

    #[test]
    fn boxes_are_filled_more_evenly_than_by_chance() {
        const COUNT: usize = 10_000;
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for upper in [[0.5, 0.5, 0.5], [0.9, 0.3, 0.7], [0.1, 0.9, 0.9]] {
            let volume: f64 = upper.iter().product();
            let mut squares = 0.0;
            for _ in 0..16 {
                let mut sequence = ShiftedKronecker::new(&mut rng);
                let inside = |x: &[f64; 3]| (0..3).all(|i| x[i] < upper[i]);
                let hits = (0..COUNT).filter(|_| inside(&sequence.draw())).count();
                squares += (hits as f64 / COUNT as f64 - volume).powi(2) / 16.0;
            }
            let by_chance = volume * (1.0 - volume) / COUNT as f64;
            // Less than a third of the error of chance.
            assert!(squares < by_chance / 9.0, "{upper:?}: {squares} {by_chance}");
        }
    }
}
