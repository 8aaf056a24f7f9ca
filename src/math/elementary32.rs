//! Logarithm and exponential to single precision, in half the work of the double ones, for what
//! is stored as `f32`.

/// `a b + c`, fused where the target can.
#[inline(always)]
pub(crate) fn mul_add<const FMA: bool>(a: f32, b: f32, c: f32) -> f32 {
    if FMA { a.mul_add(b, c) } else { a * b + c }
}

/// Lowest exponent whose power of two is a normal `f32`.
const LEAST_EXPONENT: f32 = -126.0;

/// A positive number `2^k (1 + f)` as `[k, f]`, k whole and `1 + f` in [sqrt(1/2), sqrt(2)).
/// Domain: normal numbers. Of `f64`, so that f keeps its relative precision near 1.
#[inline(always)]
pub(crate) fn parts(x: f64) -> [f32; 2] {
    /// Bits of sqrt(1/2): taking them off puts the change of k between the bounds.
    const SQRT_HALF_BITS: u64 = 0x3fe6_a09e_667f_3bcd;
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    /// 1.5 * 2^52; its low half takes a small integer, to be read as a float.
    const INTEGER: f64 = 6_755_399_441_055_744.0;
    let offset = x.to_bits().wrapping_sub(SQRT_HALF_BITS);
    let biased = offset.wrapping_add(1024 << 52) >> 52;
    let k = f64::from_bits(INTEGER.to_bits() | biased) - (INTEGER + 1024.0);
    let m = f64::from_bits((offset & MANTISSA).wrapping_add(SQRT_HALF_BITS));
    [k as f32, (m - 1.0) as f32]
}

/// [`parts`] of an `f32`.
#[inline(always)]
pub(crate) fn parts32(x: f32) -> [f32; 2] {
    const SQRT_HALF_BITS: i32 = 0x3f35_04f3;
    const MANTISSA: i32 = 0x007f_ffff;
    let offset = (x.to_bits() as i32).wrapping_sub(SQRT_HALF_BITS);
    let m = f32::from_bits((offset & MANTISSA).wrapping_add(SQRT_HALF_BITS) as u32);
    [(offset >> 23) as f32, m - 1.0]
}

/// `log2` of the number of the given [`parts`], to 3e-7 of itself.
///
/// `log2(1 + f) = 2 artanh(s) / ln 2` with `s = f / (f + 2)`, whose series up to s^9 leaves 1e-9.
#[inline(always)]
pub(crate) fn log2<const FMA: bool>([k, f]: [f32; 2]) -> f32 {
    use std::f32::consts::LOG2_E;
    const ARTANH: [f32; 4] =
        [2.0 * LOG2_E / 3.0, 2.0 * LOG2_E / 5.0, 2.0 * LOG2_E / 7.0, 2.0 * LOG2_E / 9.0];
    let s = f / (f + 2.0);
    let square = s * s;
    let mut tail = ARTANH[3];
    for coefficient in [ARTANH[2], ARTANH[1], ARTANH[0]] {
        tail = mul_add::<FMA>(tail, square, coefficient);
    }
    k + mul_add::<FMA>(s * square, tail, 2.0 * LOG2_E * s)
}

/// An exponent's power of two as `2^n + 2^n d`: `[2^n, d]` with n whole and `|d| < 1/2`.
///
/// The Taylor series of `2^r - 1` up to r^7 leaves 6e-9 for `|r| <= 1/2`.
#[inline(always)]
fn exp2_parts<const FMA: bool>(y: f32) -> [f32; 2] {
    /// 1.5 * 2^23: adding it rounds to an integer, which then stands in the lowest bits.
    const ROUND: f32 = 12_582_912.0;
    /// `ln(2)^k / k!` from k = 1 on.
    const TAYLOR: [f32; 7] = [
        std::f32::consts::LN_2,
        0.240_226_5,
        0.055_504_11,
        0.009_618_129,
        0.001_333_355_8,
        0.000_154_035_3,
        0.000_015_252_734,
    ];
    let y = if y > LEAST_EXPONENT { y } else { LEAST_EXPONENT };
    let shifted = y + ROUND;
    let r = y - (shifted - ROUND);
    let mut sum = TAYLOR[6];
    for i in (0..6).rev() {
        sum = mul_add::<FMA>(sum, r, TAYLOR[i]);
    }
    [f32::from_bits(shifted.to_bits().wrapping_add(127) << 23), sum * r]
}

/// `2^y` for `y <= 0`, to 1e-7 of itself; below the least normal number it is that.
#[inline(always)]
pub(crate) fn exp2<const FMA: bool>(y: f32) -> f32 {
    let [power, rest] = exp2_parts::<FMA>(y);
    mul_add::<FMA>(power, rest, power)
}

/// `1 - 2^y` for `y <= 0`, to 2e-7 of itself, also near `y = 0`.
#[inline(always)]
pub(crate) fn one_less_exp2<const FMA: bool>(y: f32) -> f32 {
    let [power, rest] = exp2_parts::<FMA>(y);
    mul_add::<FMA>(-power, rest, 1.0 - power)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const FMA: bool>() {
        for i in 0..=200_000 {
            let share = f64::from(i) / 200_000.0;
            for x in [10.0_f64.powf(-300.0 * share), 1.0 - 0.9 * share, 1.0 - 1e-6 * share] {
                let expected = x.log2();
                let error = (f64::from(log2::<FMA>(parts(x))) - expected).abs();
                assert!(error <= 3e-7 * expected.abs(), "log2({x}): {error}");
            }
            for y in [-125.9 * share, -2.0 * share, -1e-5 * share] {
                let (rounded, expected) = (y as f32, f64::from(y as f32).exp2());
                let error = (f64::from(exp2::<FMA>(rounded)) - expected).abs();
                assert!(error <= 1.5e-7 * expected, "2^{y}: {error}");
                let expected = -(f64::from(rounded) * std::f64::consts::LN_2).exp_m1();
                let error = (f64::from(one_less_exp2::<FMA>(rounded)) - expected).abs();
                assert!(error <= 2e-7 * expected, "1 - 2^{y}: {error}");
            }
        }
        assert_eq!(log2::<FMA>(parts(1.0)), 0.0);
        assert_eq!([exp2::<FMA>(0.0), exp2::<FMA>(f32::NEG_INFINITY)], [1.0, f32::MIN_POSITIVE]);
        for i in 1..=200_000 {
            let x = i as f32 / 100_000.0;
            assert_eq!(parts32(x), parts(f64::from(x)), "{x}");
        }
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
