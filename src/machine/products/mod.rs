//! Sums of products of columns, in the registers of each instruction set.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
#[cfg(target_arch = "x86_64")]
mod path;

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Avx2;
#[cfg(target_arch = "x86_64")]
pub(super) use avx512::Avx512;

/// Columns on either side of a tile: nine sums and the columns fit the registers.
pub(crate) const TILE: usize = 3;

/// The products of each of the columns `left..left + TILE` with each of `right..right + TILE`,
/// each summed over a column, whose length is a multiple of eight.
///
/// An explicit part of each path, since compilers make good vector code of it only by luck.
pub(crate) trait Products {
    fn tile<const LENGTH: usize>(
        columns: &[[f64; LENGTH]],
        left: usize,
        right: usize,
    ) -> [[f64; TILE]; TILE];
}

/// The products in plain Rust, with two partial sums side by side.
pub(super) struct Portable;

impl Products for Portable {
    #[inline(always)]
    fn tile<const LENGTH: usize>(
        columns: &[[f64; LENGTH]],
        left: usize,
        right: usize,
    ) -> [[f64; TILE]; TILE] {
        let product = |i: usize, j: usize| {
            let [even, odd] = pairs(&columns[left + i])
                .zip(pairs(&columns[right + j]))
                .fold([0.0; 2], |[even, odd], (a, b)| [even + a[0] * b[0], odd + a[1] * b[1]]);
            even + odd
        };
        std::array::from_fn(|i| std::array::from_fn(|j| product(i, j)))
    }
}

fn pairs(column: &[f64]) -> impl Iterator<Item = &[f64; 2]> {
    column.as_chunks::<2>().0.iter()
}
