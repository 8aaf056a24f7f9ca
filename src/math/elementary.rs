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
/// `x = n ln 2 + r`; the polynomial `(exp(r) - 1 - r)/r^2`, interpolated at the Chebyshev nodes of
/// `|r| <= ln 2 / 2`, leaves 1.3e-17.
#[inline(always)]
pub(crate) fn exp<const FMA: bool>(x: f64) -> f64 {
    const COEFFICIENTS: [f64; 12] = [
        1.0,
        1.0,
        0.500_000_000_000_000_1,
        0.166_666_666_666_666_67,
        0.041_666_666_666_623_82,
        0.008_333_333_333_330_038,
        0.001_388_888_891_736_708,
        0.000_198_412_698_631_715_56,
        2.480_152_105_786_820_5e-5,
        2.755_726_827_690_569_6e-6,
        2.762_020_159_103_155e-7,
        2.510_047_250_569_5e-8,
    ];
    let shifted = mul_add::<FMA>(x, std::f64::consts::LOG2_E, ROUND);
    let n = shifted - ROUND;
    let r = mul_add::<FMA>(n, -LN_2_LOW, mul_add::<FMA>(n, -LN_2_HIGH, x));
    let power = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    polynomial::<FMA, 12>(r, &COEFFICIENTS) * power
}

/// `ln(a / b)` for normal positive `a` and `b`, to 2 ulp, with a single division.
///
/// `a = 2^k c b` with c in [0.66, 1.5], since the bits of a float are nearly its logarithm;
/// `ln c = 2 artanh s` with `s = (c - 1)/(c + 1)`, where `(2 artanh s / s - 2)/s^2` is interpolated
/// in `s^2` at the Chebyshev nodes of `|s| <= 0.2`, which leaves 6e-17.
#[inline(always)]
pub(crate) fn ln_ratio<const FMA: bool>(a: f64, b: f64) -> f64 {
    const ARTANH: [f64; 7] = [
        0.666_666_666_666_669_6,
        0.399_999_999_992_938_7,
        0.285_714_288_498_62,
        0.222_221_811_285_685_3,
        0.181_846_979_862_344_74,
        0.152_815_728_482_594_5,
        0.151_377_308_253_169_33,
    ];
    const HALF: u64 = 1 << 51;
    /// Added to k, which may be negative.
    const BIAS: u64 = 2048;
    /// 2^52 + 2^51 as bits; its low half takes a small integer, to be read as a float.
    const INTEGER_BITS: u64 = ROUND.to_bits();
    let difference = a.to_bits().wrapping_sub(b.to_bits());
    let biased = difference.wrapping_add(HALF).wrapping_add(BIAS << 52) >> 52;
    let k = f64::from_bits(INTEGER_BITS | biased) - (ROUND + BIAS as f64);
    let near = f64::from_bits(b.to_bits().wrapping_add(biased.wrapping_sub(BIAS) << 52));
    let s = (a - near) / (a + near);
    let square = s * s;
    let ln_c = mul_add::<FMA>(s * square, polynomial::<FMA, 7>(square, &ARTANH), 2.0 * s);
    mul_add::<FMA>(k, LN_2_HIGH, mul_add::<FMA>(k, LN_2_LOW, ln_c))
}

/// `ln(1 + x)` and `1/(1 + x)` for `0 <= x <= 1`, to 4 ulp, with a single division.
///
/// `ln(1 + x) = 2 artanh s` with `s = x/(2 + x)`, as in [`ln_ratio`] with `s <= 1/3`, which leaves
/// 5e-18.
#[inline(always)]
pub(crate) fn ln_1p_and_inverse<const FMA: bool>(x: f64) -> (f64, f64) {
    const ARTANH: [f64; 10] = [
        0.666_666_666_666_666_6,
        0.400_000_000_000_145_85,
        0.285_714_285_671_087_55,
        0.222_222_227_174_278_63,
        0.181_817_894_361_328_57,
        0.153_855_700_649_586_24,
        0.133_141_442_096_549_37,
        0.120_010_728_095_907_13,
        0.088_007_384_861_446_74,
        0.161_640_456_119_435_24,
    ];
    let (one, two) = (1.0 + x, 2.0 + x);
    let inverse = 1.0 / (one * two);
    let s = x * (one * inverse);
    let square = s * s;
    let ln_1p = mul_add::<FMA>(s * square, polynomial::<FMA, 10>(square, &ARTANH), 2.0 * s);
    (ln_1p, two * inverse)
}

/// `x^p` for normal `x` in (0, 1] and `p >= 0`; where it would underflow it is 1e-300.
#[inline(always)]
pub(crate) fn power<const FMA: bool>(x: f64, p: f64) -> f64 {
    const LOG_FLOOR: f64 = -690.0;
    let log_power = p * ln_ratio::<FMA>(x, 1.0);
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
            let expected = x.ln();
            let tolerance = 4e-16 * expected.abs();
            assert!((ln_ratio::<FMA>(x, 1.0) - expected).abs() <= tolerance, "ln({x})");
            assert!((ln_ratio::<FMA>(1.0, x) + expected).abs() <= tolerance, "-ln({x})");
        }
        for x in grid(0.4, 2.5) {
            // The closer to one, the more digits of x - 1 are exact.
            let expected = (x - 1.0).ln_1p();
            let error = ln_ratio::<FMA>(3.0 * x, 3.0) - expected;
            assert!(error.abs() <= 4e-16 * expected.abs().max(1.0), "ln({x})");
            let error = ln_ratio::<FMA>(x, 1.0) - expected;
            assert!(error.abs() <= 5e-16 * expected.abs(), "ln({x})");
        }
        for x in grid(0.0, 1.0) {
            let (ln_1p, inverse) = ln_1p_and_inverse::<FMA>(x);
            assert!((ln_1p - x.ln_1p()).abs() <= 8e-16 * x.ln_1p(), "ln(1 + {x})");
            assert!((inverse * (1.0 + x) - 1.0).abs() <= 8e-16, "1/(1 + {x})");
        }
        for tiny in [0.0, 1e-300, 1e-100, 1e-17] {
            assert_eq!(ln_1p_and_inverse::<FMA>(tiny), (tiny, 1.0));
        }
        assert_eq!(ln_ratio::<FMA>(7.0, 7.0), 0.0);
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
