//! Branch-free logarithm and exponential that the compiler turns into vector code.
//!
//! `FMA` says whether the target fuses `a b + c`: where it does not, `mul_add` would be a slow
//! library call.

/// `a b + c`, fused where the target can.
#[inline(always)]
pub(crate) fn mul_add<const FMA: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FMA { a.mul_add(b, c) } else { a * b + c }
}

/// Coefficients of a polynomial in ascending order, by Horner's rule.
#[inline(always)]
fn polynomial<const FMA: bool, const N: usize>(x: f64, coefficients: &[f64; N]) -> f64 {
    let mut sum = coefficients[N - 1];
    for i in (0..N - 1).rev() {
        sum = mul_add::<FMA>(sum, x, coefficients[i]);
    }
    sum
}

/// 1.5 * 2^52: adding it rounds to an integer, which then stands in the lowest bits.
const ROUND: f64 = 6_755_399_441_055_744.0;
const LN_2_HIGH: f64 = 0.693_147_180_369_123_8;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// `exp(x)` for `-700 <= x <= 700`, to 1 ulp or so.
///
/// `x = n ln 2 + r`; the Taylor series of `exp(r)` up to r^13 leaves 5e-18 for `|r| <= ln 2 / 2`.
#[inline(always)]
pub(crate) fn exp<const FMA: bool>(x: f64) -> f64 {
    const TAYLOR: [f64; 14] = [
        1.0,
        1.0,
        1.0 / 2.0,
        1.0 / 6.0,
        1.0 / 24.0,
        1.0 / 120.0,
        1.0 / 720.0,
        1.0 / 5_040.0,
        1.0 / 40_320.0,
        1.0 / 362_880.0,
        1.0 / 3_628_800.0,
        1.0 / 39_916_800.0,
        1.0 / 479_001_600.0,
        1.0 / 6_227_020_800.0,
    ];
    let shifted = mul_add::<FMA>(x, std::f64::consts::LOG2_E, ROUND);
    let n = shifted - ROUND;
    let r = mul_add::<FMA>(n, -LN_2_LOW, mul_add::<FMA>(n, -LN_2_HIGH, x));
    let power = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    polynomial::<FMA, 14>(r, &TAYLOR) * power
}

/// `ln(x)` for normal positive `x`, to 2 ulp or, near `x = 1`, 1e-16.
///
/// `x = 2^k m` with m in [sqrt(1/2), sqrt(2)); `ln m = 2 artanh s` with `s = (m - 1)/(m + 1)`,
/// whose series up to s^21 leaves 2e-18 for `|s| <= 0.1716`.
#[inline(always)]
pub(crate) fn ln<const FMA: bool>(x: f64) -> f64 {
    const ARTANH: [f64; 10] = [
        2.0 / 3.0,
        2.0 / 5.0,
        2.0 / 7.0,
        2.0 / 9.0,
        2.0 / 11.0,
        2.0 / 13.0,
        2.0 / 15.0,
        2.0 / 17.0,
        2.0 / 19.0,
        2.0 / 21.0,
    ];
    /// Bits of sqrt(1/2): taking them off puts the change of k between m's bounds.
    const SQRT_HALF_BITS: u64 = 0x3fe6_a09e_667f_3bcd;
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    /// 2^52 + 2^51 as bits; its low half takes a small integer, to be read as a float.
    const INTEGER_BITS: u64 = ROUND.to_bits();
    let offset = x.to_bits().wrapping_sub(SQRT_HALF_BITS);
    // The exponent may be negative: bias it by 1024 before the shift, take the bias off after.
    let biased = offset.wrapping_add(1024 << 52) >> 52;
    let k = f64::from_bits(INTEGER_BITS | biased) - (ROUND + 1024.0);
    let m = f64::from_bits((offset & MANTISSA).wrapping_add(SQRT_HALF_BITS));
    let f = m - 1.0;
    let s = f / (m + 1.0);
    let square = s * s;
    let tail = polynomial::<FMA, 10>(square, &ARTANH) * square;
    // ln m = 2 s + s tail, with 2 s = f - s f taken apart to keep the leading term exact.
    let ln_m = f - s * (f - tail);
    mul_add::<FMA>(k, LN_2_HIGH, mul_add::<FMA>(k, LN_2_LOW, ln_m))
}

/// `x^p` for normal `x` in (0, 1] and `p >= 0`; where it would underflow it is 1e-300.
#[inline(always)]
pub(crate) fn power<const FMA: bool>(x: f64, p: f64) -> f64 {
    const LOG_FLOOR: f64 = -690.0;
    let log_power = p * ln::<FMA>(x);
    exp::<FMA>(if log_power > LOG_FLOOR { log_power } else { LOG_FLOOR })
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
    let sine = angle + angle * square * polynomial::<FMA, 8>(square, &SINE);
    let cosine = 1.0 + square * polynomial::<FMA, 8>(square, &COSINE);
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
            assert!((exp::<FMA>(x) - expected).abs() <= 5e-16 * expected, "exp({x})");
        }
        for power in grid(-300.0, 300.0) {
            let x = 10.0_f64.powf(power);
            assert!((ln::<FMA>(x) - x.ln()).abs() <= 4e-16 * x.ln().abs().max(1.0), "ln({x})");
        }
        for x in grid(0.5, 2.0) {
            assert!((ln::<FMA>(x) - x.ln()).abs() <= 2e-16, "ln({x})");
        }
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
        assert_eq!(power::<FMA>(1e-300, 40.0), exp::<FMA>(-690.0));
        assert_eq!(ln::<FMA>(1.0), 0.0);
        assert_eq!(exp::<FMA>(0.0), 1.0);
    }

    #[test]
    fn unfused_forms_agree_with_the_standard_library() {
        check::<false>();
    }

    #[test]
    fn fused_forms_agree_with_the_standard_library() {
        check::<true>();
    }
}
