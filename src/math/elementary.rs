//! Branch-free logarithm and exponential that the compiler turns into vector code.
//!
//! `FMA` says whether the target fuses `a b + c`: where it does not, `mul_add` would be a slow
//! library call.

use super::lane::Lane;

/// `a b + c`, fused where the target can.
#[inline(always)]
pub(crate) fn mul_add<const FMA: bool, L: Lane>(a: L, b: L, c: L) -> L {
    if FMA { a.fused(b, c) } else { a * b + c }
}

/// Coefficients of a polynomial in ascending order, by Horner's rule.
#[inline(always)]
fn polynomial<const FMA: bool, L: Lane>(x: L, coefficients: &[L]) -> L {
    let mut sum = coefficients[coefficients.len() - 1];
    for i in (0..coefficients.len() - 1).rev() {
        sum = mul_add::<FMA, L>(sum, x, coefficients[i]);
    }
    sum
}

/// `exp(x)` for `-700 <= x <= 700`, of `f32` for `-80 <= x <= 80`, to 1 ulp or so.
///
/// `x = n ln 2 + r`; the polynomial `(exp(r) - 1 - r)/r^2`, interpolated at the Chebyshev nodes of
/// `|r| <= ln 2 / 2`, leaves 1.3e-17, of `f32` 9e-9.
#[inline(always)]
pub(crate) fn exp<const FMA: bool, L: Lane>(x: L) -> L {
    let shifted = mul_add::<FMA, L>(x, L::LOG2_E, L::ROUND);
    let n = shifted - L::ROUND;
    let r = mul_add::<FMA, L>(n, -L::LN_2_LOW, mul_add::<FMA, L>(n, -L::LN_2_HIGH, x));
    polynomial::<FMA, L>(r, L::EXP) * L::power_of_two(shifted)
}

/// `ln(a / b)` for normal positive `a` and `b`, to 2 ulp, with a single division.
///
/// `a = 2^k c b` with c in [0.66, 1.5]; `ln c = 2 artanh s` with `s = (c - 1)/(c + 1)`, where
/// `(2 artanh s / s - 2)/s^2` is interpolated in `s^2` at the Chebyshev nodes of `|s| <= 0.2`,
/// which leaves 6e-17, of `f32` 9e-9.
#[inline(always)]
pub(crate) fn ln_ratio<const FMA: bool, L: Lane>(a: L, b: L) -> L {
    let [k, near] = L::binary_ratio(a, b);
    let s = (a - near) / (a + near);
    let ln_c = twice_artanh::<FMA, L>(s, L::ARTANH_OF_FIFTH);
    mul_add::<FMA, L>(k, L::LN_2_HIGH, mul_add::<FMA, L>(k, L::LN_2_LOW, ln_c))
}

/// `ln(1 + x)` and `1/(1 + x)` for `0 <= x <= 1`, to 4 ulp, with a single division.
///
/// `ln(1 + x) = 2 artanh s` with `s = x/(2 + x)`, as in [`ln_ratio`] with `s <= 1/3`, which leaves
/// 5e-18, of `f32` 2e-8.
#[inline(always)]
pub(crate) fn ln_1p_and_inverse<const FMA: bool, L: Lane>(x: L) -> (L, L) {
    let (one, two) = (L::of(1.0) + x, L::of(2.0) + x);
    let inverse = L::of(1.0) / (one * two);
    let s = x * (one * inverse);
    (twice_artanh::<FMA, L>(s, L::ARTANH_OF_THIRD), two * inverse)
}

/// `2 artanh s`, by the coefficients of `(2 artanh s / s - 2)/s^2` in `s^2`.
#[inline(always)]
fn twice_artanh<const FMA: bool, L: Lane>(s: L, coefficients: &[L]) -> L {
    let square = s * s;
    mul_add::<FMA, L>(s * square, polynomial::<FMA, L>(square, coefficients), L::of(2.0) * s)
}

/// `x^p` for normal `x` in (0, 1] and `p >= 0`; where it would underflow it is 1e-300.
#[inline(always)]
pub(crate) fn power<const FMA: bool>(x: f64, p: f64) -> f64 {
    let log_power = p * ln_ratio::<FMA, f64>(x, 1.0);
    exp::<FMA, f64>(if log_power > f64::LOG_FLOOR { log_power } else { f64::LOG_FLOOR })
}

/// `[sin(x), cos(x)]` for `0 <= x <= pi/2`, to 2e-16.
///
/// The Taylor series up to x^17 leave 2e-18 at pi/4, where sine and cosine change places.
#[inline(always)]
pub(crate) fn sin_cos<const FMA: bool>(x: f64) -> [f64; 2] {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
    /// `(-1)^k / (2k + 1)!` from k = 1 on.
    const SINE: [f64; 8] = [
        -1.0 / 6.0,
        1.0 / 120.0,
        -1.0 / 5_040.0,
        1.0 / 362_880.0,
        -1.0 / 39_916_800.0,
        1.0 / 6_227_020_800.0,
        -1.0 / 1_307_674_368_000.0,
        1.0 / 355_687_428_096_000.0,
    ];
    /// `(-1)^k / (2k)!` from k = 1 on.
    const COSINE: [f64; 8] = [
        -1.0 / 2.0,
        1.0 / 24.0,
        -1.0 / 720.0,
        1.0 / 40_320.0,
        -1.0 / 3_628_800.0,
        1.0 / 479_001_600.0,
        -1.0 / 87_178_291_200.0,
        1.0 / 20_922_789_888_000.0,
    ];
    let is_steep = x > FRAC_PI_4;
    let angle = if is_steep { FRAC_PI_2 - x } else { x };
    let square = angle * angle;
    let sine = angle + angle * square * polynomial::<FMA, f64>(square, &SINE);
    let cosine = 1.0 + square * polynomial::<FMA, f64>(square, &COSINE);
    if is_steep { [cosine, sine] } else { [sine, cosine] }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(low: f64, high: f64) -> impl Iterator<Item = f64> {
        (0..=100_000).map(move |i| low + (high - low) * f64::from(i) / 100_000.0)
    }

    fn check<const FMA: bool>() {
        for x in grid(-690.0, 690.0).chain(grid(-1.0, 1.0)) {
            let expected = x.exp();
            assert!((exp::<FMA, _>(x) - expected).abs() <= 5e-16 * expected, "exp({x})");
        }
        for power in grid(-300.0, 300.0) {
            let x = 10.0_f64.powf(power);
            let expected = x.ln();
            let tolerance = 4e-16 * expected.abs();
            assert!((ln_ratio::<FMA, _>(x, 1.0) - expected).abs() <= tolerance, "ln({x})");
            assert!((ln_ratio::<FMA, _>(1.0, x) + expected).abs() <= tolerance, "-ln({x})");
        }
        for x in grid(0.4, 2.5) {
            // The closer to one, the more digits of x - 1 are exact.
            let expected = (x - 1.0).ln_1p();
            let error = ln_ratio::<FMA, _>(3.0 * x, 3.0) - expected;
            assert!(error.abs() <= 4e-16 * expected.abs().max(1.0), "ln({x})");
            let error = ln_ratio::<FMA, _>(x, 1.0) - expected;
            assert!(error.abs() <= 5e-16 * expected.abs(), "ln({x})");
        }
        for x in grid(0.0, 1.0) {
            let (ln_1p, inverse) = ln_1p_and_inverse::<FMA, _>(x);
            assert!((ln_1p - x.ln_1p()).abs() <= 8e-16 * x.ln_1p(), "ln(1 + {x})");
            assert!((inverse * (1.0 + x) - 1.0).abs() <= 8e-16, "1/(1 + {x})");
        }
        for tiny in [0.0, 1e-300, 1e-100, 1e-17] {
            assert_eq!(ln_1p_and_inverse::<FMA, _>(tiny), (tiny, 1.0));
        }
        assert_eq!(ln_ratio::<FMA, _>(7.0, 7.0), 0.0);
        for x in grid(0.0, std::f64::consts::FRAC_PI_2) {
            let [sine, cosine] = sin_cos::<FMA>(x);
            assert!((sine - x.sin()).abs() <= 3e-16 && (cosine - x.cos()).abs() <= 3e-16, "{x}");
        }
        for x in grid(1e-4, 1.0) {
            for p in [0.025, 1.0, 4.0, 40.0] {
                let expected = x.powf(p).max(1e-299);
                // The exponent of the power, up to 690, is rounded.
                let found = power::<FMA>(x, p).max(1e-299);
                assert!((found - expected).abs() <= 3e-13 * expected, "{x} ^ {p}");
            }
        }
        assert_eq!(power::<FMA>(1e-300, 40.0), exp::<FMA, _>(-690.0));
        assert_eq!(exp::<FMA, _>(0.0), 1.0);
    }

    /// Exact arguments of `f32`, against `f64`.
    fn check_single<const FMA: bool>() {
        let single = |x: f64| x as f32;
        for x in grid(-80.0, 80.0).chain(grid(-1.0, 1.0)).map(single) {
            let expected = f64::from(x).exp();
            let error = f64::from(exp::<FMA, _>(x)) - expected;
            assert!(error.abs() <= 2e-7 * expected, "exp({x})");
        }
        let ratios = grid(-30.0, 30.0).map(|power| 10.0_f64.powf(power)).chain(grid(0.4, 2.5));
        for x in ratios.map(single) {
            let expected = f64::from(x).ln();
            for (a, b, expected) in [(x, 1.0, expected), (1.0, x, -expected)] {
                let error = f64::from(ln_ratio::<FMA, _>(a, b)) - expected;
                assert!(error.abs() <= 3e-7 * expected.abs(), "ln({a} / {b})");
            }
        }
        for x in grid(0.0, 1.0).map(single) {
            let (ln_1p, inverse) = ln_1p_and_inverse::<FMA, _>(x);
            let expected = f64::from(x).ln_1p();
            assert!((f64::from(ln_1p) - expected).abs() <= 4e-7 * expected, "ln(1 + {x})");
            assert!((f64::from(inverse) * f64::from(1.0 + x) - 1.0).abs() <= 4e-7, "1/(1 + {x})");
        }
        assert_eq!(ln_ratio::<FMA, _>(7.0_f32, 7.0), 0.0);
        assert_eq!(exp::<FMA, _>(0.0_f32), 1.0);
    }

    #[test]
    fn unfused_forms_agree_with_the_standard_library() {
        check::<false>();
        check_single::<false>();
    }

    #[test]
    fn fused_forms_agree_with_the_standard_library() {
        check::<true>();
        check_single::<true>();
    }
}
