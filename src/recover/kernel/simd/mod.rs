//! One body of a pass, compiled for each instruction set: with the files beside it the part of
//! the fit with `unsafe` code.
//!
//! Invariants:
//! - a function compiled for a target feature is called only where an [`InstructionSet`] names it;
//! - a register is loaded only from a slice or array that is as long as the register is wide.
#![allow(unsafe_code)]

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
#[cfg(target_arch = "x86_64")]
mod path;

use super::block::{Scratch, write_rows};
use super::gram::{BLOCK, Gram, PortableTile, Rows, TileProducts};
use super::view::ModelView;
use crate::math::InstructionSet;
use crate::math::lane::Lane;
use crate::recover::options::Precision;

/// The Gram matrix over the points; each row multiplied by its factor, where there are any.
pub(super) fn gram(
    set: InstructionSet,
    view: &ModelView,
    points: [&[f64]; 3],
    factors: Option<&[f64]>,
) -> Gram {
    match set {
        // SAFETY: an instruction set is named only if the processor has it.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx512 => unsafe { avx512::gram(view, points, factors) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx2 => unsafe { avx2::gram(view, points, factors) },
        _ => gram_blocks::<PortableTile, false>(view, points, factors),
    }
}

/// The signed geometric distance of each point.
pub(super) fn geometric_distances(
    set: InstructionSet,
    view: &ModelView,
    points: [&[f64]; 3],
    distances: &mut [f64],
) {
    match set {
        // SAFETY: an instruction set is named only if the processor has it.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx512 => unsafe { avx512::geometric_distances(view, points, distances) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx2 => unsafe { avx2::geometric_distances(view, points, distances) },
        _ => distances_of::<false>(view, points, distances),
    }
}

/// The body of every path, compiled anew inside each, and once for each precision and residual.
#[inline(always)]
fn gram_blocks<P: TileProducts, const FMA: bool>(
    view: &ModelView,
    points: [&[f64]; 3],
    factors: Option<&[f64]>,
) -> Gram {
    match (view.precision, view.is_geometric) {
        (Precision::Single, true) => gram_of::<f32, P, FMA, true>(view, points, factors),
        (Precision::Single, false) => gram_of::<f32, P, FMA, false>(view, points, factors),
        (Precision::Double, true) => gram_of::<f64, P, FMA, true>(view, points, factors),
        (Precision::Double, false) => gram_of::<f64, P, FMA, false>(view, points, factors),
    }
}

#[inline(always)]
fn gram_of<L: Lane, P: TileProducts, const FMA: bool, const GEOMETRIC: bool>(
    view: &ModelView,
    points: [&[f64]; 3],
    factors: Option<&[f64]>,
) -> Gram {
    let mut scratch = Scratch::<L>::new();
    let mut rows = Rows::new();
    let mut total = Gram::zero();
    let count = points[0].len();
    for start in (0..count).step_by(BLOCK) {
        let end = count.min(start + BLOCK);
        let block = points.map(|column| &column[start..end]);
        write_rows::<L, FMA, GEOMETRIC>(view, block, &mut scratch, &mut rows);
        if let Some(factors) = factors {
            rows.multiply(&factors[start..end]);
        }
        total.add_block::<P>(&rows);
    }
    total
}

#[inline(always)]
fn distances_of<const FMA: bool>(view: &ModelView, points: [&[f64]; 3], distances: &mut [f64]) {
    let mut scratch = Scratch::<f64>::new();
    let mut rows = Rows::new();
    for (index, distances) in distances.chunks_mut(BLOCK).enumerate() {
        let start = index * BLOCK;
        let block = points.map(|column| &column[start..start + distances.len()]);
        write_rows::<f64, FMA, false>(view, block, &mut scratch, &mut rows);
        let squares_and_signs = rows.geometric_squares.iter().zip(&rows.columns[0]);
        for (distance, (square, sign)) in distances.iter_mut().zip(squares_and_signs) {
            *distance = square.sqrt().copysign(*sign);
        }
    }
}
