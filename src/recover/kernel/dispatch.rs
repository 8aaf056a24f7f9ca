//! The choice of instruction set: the only place of the fit with `unsafe` code.
//!
//! Invariant: a function compiled for a target feature is called only after the processor was
//! found to have that feature.
#![allow(unsafe_code)]

use super::block::{Scratch, write_rows};
use super::gram::{BLOCK, Gram, PortableTile, Rows, TileProducts};
use super::view::ModelView;

/// The Gram matrix over the points, by the best path that the processor has; each row multiplied
/// by its factor, where there are any.
pub(super) fn gram(view: &ModelView, points: [&[f64]; 3], factors: Option<&[f64]>) -> Gram {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        // SAFETY: the features that the function is compiled for have just been detected.
        return unsafe { avx2::gram(view, points, factors) };
    }
    gram_portable(view, points, factors)
}

/// The squared geometric distance of each point, by the best path that the processor has.
pub(super) fn geometric_squares(view: &ModelView, points: [&[f64]; 3], squares: &mut [f64]) {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        // SAFETY: the features that the function is compiled for have just been detected.
        return unsafe { avx2::geometric_squares(view, points, squares) };
    }
    squares_of::<false>(view, points, squares);
}

/// The path for any processor.
pub(super) fn gram_portable(
    view: &ModelView,
    points: [&[f64]; 3],
    factors: Option<&[f64]>,
) -> Gram {
    gram_blocks::<PortableTile, false>(view, points, factors)
}

/// The body of every path, compiled anew inside each, and once for each residual.
#[inline(always)]
fn gram_blocks<P: TileProducts, const FMA: bool>(
    view: &ModelView,
    points: [&[f64]; 3],
    factors: Option<&[f64]>,
) -> Gram {
    if view.is_geometric {
        gram_of::<P, FMA, true>(view, points, factors)
    } else {
        gram_of::<P, FMA, false>(view, points, factors)
    }
}

#[inline(always)]
fn gram_of<P: TileProducts, const FMA: bool, const GEOMETRIC: bool>(
    view: &ModelView,
    points: [&[f64]; 3],
    factors: Option<&[f64]>,
) -> Gram {
    let mut scratch = Scratch::new();
    let mut rows = Rows::new();
    let mut total = Gram::zero();
    let count = points[0].len();
    for start in (0..count).step_by(BLOCK) {
        let end = count.min(start + BLOCK);
        let block = points.map(|column| &column[start..end]);
        write_rows::<FMA, GEOMETRIC>(view, block, &mut scratch, &mut rows);
        if let Some(factors) = factors {
            rows.multiply(&factors[start..end]);
        }
        total.add_block::<P>(&rows);
    }
    total
}

#[inline(always)]
fn squares_of<const FMA: bool>(view: &ModelView, points: [&[f64]; 3], squares: &mut [f64]) {
    let mut scratch = Scratch::new();
    let mut rows = Rows::new();
    for (index, squares) in squares.chunks_mut(BLOCK).enumerate() {
        let start = index * BLOCK;
        let block = points.map(|column| &column[start..start + squares.len()]);
        write_rows::<FMA, false>(view, block, &mut scratch, &mut rows);
        squares.copy_from_slice(&rows.geometric_squares[..squares.len()]);
    }
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use std::arch::x86_64::{
        __m256d, _mm256_fmadd_pd, _mm256_loadu_pd, _mm256_setzero_pd, _mm256_storeu_pd,
    };

    use super::{BLOCK, Gram, ModelView, TileProducts, gram_blocks, squares_of};
    use crate::recover::kernel::gram::{Columns, TILE};

    const LANES: usize = 4;

    /// The path for processors with AVX2 and FMA.
    #[target_feature(enable = "avx2,fma")]
    pub(super) fn gram(view: &ModelView, points: [&[f64]; 3], factors: Option<&[f64]>) -> Gram {
        gram_blocks::<Avx2Tile, true>(view, points, factors)
    }

    /// The path for processors with AVX2 and FMA.
    #[target_feature(enable = "avx2,fma")]
    pub(super) fn geometric_squares(view: &ModelView, points: [&[f64]; 3], squares: &mut [f64]) {
        squares_of::<true>(view, points, squares);
    }

    struct Avx2Tile;

    impl TileProducts for Avx2Tile {
        #[inline(always)]
        fn products(columns: &Columns, left: usize, right: usize) -> [[f64; TILE]; TILE] {
            // SAFETY: this type is private to the module and named only in `gram`, which is
            // called only where the features are there.
            unsafe { products(columns, left, right) }
        }
    }

    #[inline]
    #[target_feature(enable = "avx2,fma")]
    fn products(columns: &Columns, left: usize, right: usize) -> [[f64; TILE]; TILE] {
        let mut sums = [[_mm256_setzero_pd(); TILE]; TILE];
        for start in (0..BLOCK).step_by(LANES) {
            let b: [__m256d; TILE] = std::array::from_fn(|j| load(&columns[right + j], start));
            for (i, row) in sums.iter_mut().enumerate() {
                let a = load(&columns[left + i], start);
                for (sum, b) in row.iter_mut().zip(b) {
                    *sum = _mm256_fmadd_pd(a, b, *sum);
                }
            }
        }
        sums.map(|row| row.map(|sum| horizontal_sum(sum)))
    }

    #[inline]
    #[target_feature(enable = "avx2,fma")]
    fn load(column: &[f64; BLOCK], start: usize) -> __m256d {
        let lanes = &column[start..start + LANES];
        // SAFETY: the slice holds as many values as are read; they need no alignment.
        unsafe { _mm256_loadu_pd(lanes.as_ptr()) }
    }

    #[inline]
    #[target_feature(enable = "avx2,fma")]
    fn horizontal_sum(lanes: __m256d) -> f64 {
        let mut values = [0.0; LANES];
        // SAFETY: the array holds as many values as are written; it needs no alignment.
        unsafe { _mm256_storeu_pd(values.as_mut_ptr(), lanes) };
        (values[0] + values[1]) + (values[2] + values[3])
    }
}
