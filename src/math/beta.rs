//! The Beta function (JLS Eq. 2.53).

/// Beta function `B(x, y) = Γ(x) Γ(y) / Γ(x + y)` for positive `x`, `y` (JLS Eq. 2.53).
///
/// Evaluated through log-Gamma, so that small arguments do not overflow.
pub fn beta(x: f64, y: f64) -> f64 {
    (libm::lgamma(x) + libm::lgamma(y) - libm::lgamma(x + y)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Rounding of three log-Gammas of size up to about 10.
    const TOLERANCE: f64 = 1e-14;

    #[test]
    fn closed_forms() {
        for (x, y, expected) in [
            (0.5, 0.5, PI),
            (1.0, 1.0, 1.0),
            (2.0, 3.0, 1.0 / 12.0),
            (0.5, 1.5, PI / 2.0),
            (1e-3, 1.0, 1e3),
        ] {
            assert!((beta(x, y) / expected - 1.0).abs() < TOLERANCE, "B({x}, {y})");
        }
    }

    #[test]
    fn recurrence_and_symmetry() {
        for x in [0.025, 0.3, 1.0, 2.7] {
            for y in [0.05, 0.8, 3.1] {
                let split = beta(x + 1.0, y) + beta(x, y + 1.0);
                assert!((split / beta(x, y) - 1.0).abs() < TOLERANCE);
                assert_eq!(beta(x, y), beta(y, x));
            }
        }
    }
}
