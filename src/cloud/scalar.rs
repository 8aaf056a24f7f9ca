//! Numbers as binary formats store them.

/// The order of the bytes of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ByteOrder {
    Little,
    Big,
}

/// The type of a stored number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Scalar {
    /// The number of bytes stored.
    pub const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Whether the type is one of whole numbers.
    pub const fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// The number that the first [`size`](Self::size) bytes store.
    ///
    /// Exact but for whole numbers beyond 2^53, which are rounded.
    ///
    /// # Panics
    /// If there are fewer bytes.
    #[inline(always)]
    pub fn decode(self, bytes: &[u8], order: ByteOrder) -> f64 {
        macro_rules! decode {
            ($type:ty) => {
                match order {
                    ByteOrder::Little => <$type>::from_le_bytes(first(bytes)) as f64,
                    ByteOrder::Big => <$type>::from_be_bytes(first(bytes)) as f64,
                }
            };
        }
        match self {
            Self::I8 => decode!(i8),
            Self::U8 => decode!(u8),
            Self::I16 => decode!(i16),
            Self::U16 => decode!(u16),
            Self::I32 => decode!(i32),
            Self::U32 => decode!(u32),
            Self::I64 => decode!(i64),
            Self::U64 => decode!(u64),
            Self::F32 => decode!(f32),
            Self::F64 => decode!(f64),
        }
    }

    /// Appends the number that each of the byte strings begins with, as [`decode`](Self::decode)
    /// gives it, with the type and order looked at once.
    ///
    /// # Panics
    /// If one has too few bytes.
    pub fn append<'b>(
        self,
        strings: impl ExactSizeIterator<Item = &'b [u8]>,
        order: ByteOrder,
        column: &mut Vec<f64>,
    ) {
        macro_rules! append {
            ($kind:ident) => {
                match order {
                    ByteOrder::Little => column
                        .extend(strings.map(|bytes| Self::$kind.decode(bytes, ByteOrder::Little))),
                    ByteOrder::Big => column
                        .extend(strings.map(|bytes| Self::$kind.decode(bytes, ByteOrder::Big))),
                }
            };
        }
        match self {
            Self::I8 => append!(I8),
            Self::U8 => append!(U8),
            Self::I16 => append!(I16),
            Self::U16 => append!(U16),
            Self::I32 => append!(I32),
            Self::U32 => append!(U32),
            Self::I64 => append!(I64),
            Self::U64 => append!(U64),
            Self::F32 => append!(F32),
            Self::F64 => append!(F64),
        }
    }
}

/// The first `N` bytes.
///
/// # Panics
/// If there are fewer bytes.
#[inline]
pub(super) fn first<const N: usize>(bytes: &[u8]) -> [u8; N] {
    let mut array = [0; N];
    array.copy_from_slice(&bytes[..N]);
    array
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extreme_values_are_decoded_exactly_in_both_orders() {
        macro_rules! check {
            ($type:ty, $scalar:expr) => {
                for value in [<$type>::MIN, <$type>::MAX, 1 as $type] {
                    let little = $scalar.decode(&value.to_le_bytes(), ByteOrder::Little);
                    let big = $scalar.decode(&value.to_be_bytes(), ByteOrder::Big);
                    assert_eq!([little, big], [value as f64; 2]);
                    assert_eq!($scalar.size(), size_of::<$type>());
                }
            };
        }
        check!(i8, Scalar::I8);
        check!(u8, Scalar::U8);
        check!(i16, Scalar::I16);
        check!(u16, Scalar::U16);
        check!(i32, Scalar::I32);
        check!(u32, Scalar::U32);
        check!(i64, Scalar::I64);
        check!(u64, Scalar::U64);
        check!(f32, Scalar::F32);
        check!(f64, Scalar::F64);
    }
}
