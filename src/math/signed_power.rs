//! The signed power of JLS section 2.5.

/// `sign(x) |x|^p`, the power meant wherever a sine or cosine is raised to an exponent (JLS 2.5).
///
/// Zero stays zero for `p > 0`.
#[inline]
pub fn signed_power(x: f64, p: f64) -> f64 {
    x.abs().powf(p).copysign(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_odd_and_inverted_by_the_reciprocal_power() {
        for x in [-3.5, -1.0, -1e-3, 1e-3, 0.5, 2.0] {
            for p in [0.05, 0.5, 1.0, 2.0, 3.0] {
                assert_eq!(signed_power(-x, p), -signed_power(x, p));
                let back = signed_power(signed_power(x, p), 1.0 / p);
                assert!((back - x).abs() <= 1e-13 * x.abs(), "{x} {p} {back}");
            }
        }
        assert_eq!(signed_power(0.0, 0.3), 0.0);
    }
}
