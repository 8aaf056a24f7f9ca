//! The numbers that vector loops run over: doubles, or floats, of which a register holds twice as
//! many.

use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub};

/// The greater of two numbers that are not NaN: one instruction, where `f64::max` takes three.
#[inline(always)]
pub(crate) fn greater<L: Lane>(a: L, b: L) -> L {
    if a > b { a } else { b }
}

/// What loops need of `f64` and `f32`, and what the elementary functions differ in.
pub(crate) trait Lane:
    Copy
    + PartialOrd
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + MulAssign
    + 'static
{
    /// Magnitudes below this are not told from zero: products of two of them, and their squares,
    /// are normal numbers.
    const TINY: Self;
    /// Logarithms of powers below this are not told from it: the power of e, and what is summed
    /// with it, are normal numbers, and nothing beside one.
    const LOG_FLOOR: Self;

    /// 1.5 times the number of which one is the last digit: adding it rounds to an integer, which
    /// then stands in the lowest bits.
    const ROUND: Self;
    const LOG2_E: Self;
    /// `ln 2`, in so few digits that its product with an exponent is exact;
    const LN_2_HIGH: Self;
    /// and what they lack.
    const LN_2_LOW: Self;
    /// Coefficients of the exponential of `|r| <= ln 2 / 2`.
    const EXP: &'static [Self];
    /// Coefficients of `(2 artanh s / s - 2)/s^2` in `s^2`, for `|s| <= 0.2`,
    const ARTANH_OF_FIFTH: &'static [Self];
    /// and for `|s| <= 1/3`.
    const ARTANH_OF_THIRD: &'static [Self];

    /// The nearest number of this type.
    fn of(value: f64) -> Self;
    /// The same number as a double.
    fn to_f64(self) -> f64;
    /// `|x|`.
    fn abs(self) -> Self;
    /// The root of a number that is not negative.
    fn sqrt(self) -> Self;
    /// The magnitude of this with the sign of the other.
    fn copysign(self, sign: Self) -> Self;
    /// `a b + c`, fused.
    fn fused(self, b: Self, c: Self) -> Self;
    /// `2^n`, given `n + ROUND`, where it is a normal number.
    fn power_of_two(shifted: Self) -> Self;
    /// `[k, 2^k b]`, k whole, with the ratio of `a` to the latter in [0.66, 1.5], since the bits of
    /// a float are nearly its logarithm. Domain: normal positive numbers.
    fn binary_ratio(a: Self, b: Self) -> [Self; 2];
}

/// The arithmetic of one type, `$bits` that are `$digits` of the mantissa and others above.
macro_rules! lane {
    ($lane:ty, bits: $bits:ty, digits: $digits:literal, bias: $bias:literal, $($constants:tt)*) => {
        impl Lane for $lane {
            $($constants)*

            #[inline(always)]
            fn of(value: f64) -> Self {
                value as $lane
            }

            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                self.abs()
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                self.copysign(sign)
            }

            #[inline(always)]
            fn fused(self, b: Self, c: Self) -> Self {
                self.mul_add(b, c)
            }

            #[inline(always)]
            fn power_of_two(shifted: Self) -> Self {
                Self::from_bits(shifted.to_bits().wrapping_add($bias) << $digits)
            }

            #[inline(always)]
            fn binary_ratio(a: Self, b: Self) -> [Self; 2] {
                const HALF: $bits = 1 << ($digits - 1);
                /// Added to k, which may be negative.
                const BIAS: $bits = 2 * ($bias + 1);
                /// As bits; its low half takes a small integer, to be read as a float.
                const INTEGER_BITS: $bits = <$lane>::ROUND.to_bits();
                let difference = a.to_bits().wrapping_sub(b.to_bits());
                let biased =
                    difference.wrapping_add(HALF).wrapping_add(BIAS << $digits) >> $digits;
                let k = Self::from_bits(INTEGER_BITS | biased) - (Self::ROUND + BIAS as $lane);
                let shift = biased.wrapping_sub(BIAS) << $digits;
                [k, Self::from_bits(b.to_bits().wrapping_add(shift))]
            }
        }
    };
}

lane! {
    f64, bits: u64, digits: 52, bias: 1023,

    const TINY: Self = 1e-100;
    const LOG_FLOOR: Self = -690.0;
    const ROUND: Self = 6_755_399_441_055_744.0;
    const LOG2_E: Self = std::f64::consts::LOG2_E;
    const LN_2_HIGH: Self = 0.693_147_180_369_123_8;
    const LN_2_LOW: Self = 1.908_214_929_270_587_7e-10;
    const EXP: &'static [Self] = &[
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
    const ARTANH_OF_FIFTH: &'static [Self] = &[
        0.666_666_666_666_669_6,
        0.399_999_999_992_938_7,
        0.285_714_288_498_62,
        0.222_221_811_285_685_3,
        0.181_846_979_862_344_74,
        0.152_815_728_482_594_5,
        0.151_377_308_253_169_33,
    ];
    const ARTANH_OF_THIRD: &'static [Self] = &[
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
}

lane! {
    f32, bits: u32, digits: 23, bias: 127,

    const TINY: Self = 1e-15;
    const LOG_FLOOR: Self = -60.0;
    const ROUND: Self = 12_582_912.0;
    const LOG2_E: Self = std::f32::consts::LOG2_E;
    const LN_2_HIGH: Self = 0.693_359_4;
    const LN_2_LOW: Self = -2.121_944_4e-4;
    const EXP: &'static [Self] =
        &[1.0, 1.0, 0.5, 0.166_665_76, 0.041_666_552, 0.008_363_293, 0.001_392_632_6];
    const ARTANH_OF_FIFTH: &'static [Self] = &[0.666_667_16, 0.399_790_17, 0.299_556_05];
    const ARTANH_OF_THIRD: &'static [Self] = &[0.666_666_4, 0.400_075_6, 0.282_366_2, 0.268_515];
}
