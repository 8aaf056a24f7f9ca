//! The fused pass: rows of the radial problem and their Gram matrix, block by block, in vector
//! code chosen at run time.
//!
//! One generic body is compiled for each instruction set. `radial_row` is its reference: the
//! tests hold every path against it.

mod block;
mod dispatch;
mod elementary;
mod gram;
mod view;

pub(crate) use gram::{COLUMNS, Gram};
pub(crate) use view::{ModelView, Residual};

use rayon::prelude::*;

/// Points whose rows are summed in one go: fixed, so that the sum does not depend on how many
/// threads share the work.
const CHUNK: usize = 64 * gram::BLOCK;

/// Columns x, y, z of equally many points.
pub(crate) type PointColumns<'a> = [&'a [f64]; 3];

/// The Gram matrix `[r J]' [r J]` of the radial problem over all points.
///
/// Memory does not depend on the number of points but for 1 kB a chunk; nor do the bytes of
/// the result on `parallel`.
pub(crate) fn gram(view: &ModelView, points: PointColumns, parallel: bool) -> Gram {
    let count = points[0].len();
    let chunk = |index: usize| {
        let range = index * CHUNK..count.min((index + 1) * CHUNK);
        dispatch::gram(view, points.map(|column| &column[range.clone()]))
    };
    let chunks = count.div_ceil(CHUNK);
    if !parallel || chunks < 2 {
        return sum((0..chunks).map(chunk));
    }
    let partial: Vec<Gram> = (0..chunks).into_par_iter().map(chunk).collect();
    sum(partial)
}

fn sum(grams: impl IntoIterator<Item = Gram>) -> Gram {
    grams.into_iter().fold(Gram::zero(), |mut total, gram| {
        total.add(&gram);
        total
    })
}

#[cfg(test)]
mod tests;
