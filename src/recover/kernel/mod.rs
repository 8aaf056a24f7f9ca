//! The fused pass: rows of the radial problem and their Gram matrix, block by block, in vector
//! code chosen at run time.
//!
//! One generic body is compiled for each instruction set and precision. `radial_row` is its
//! reference: the tests hold every path against it.

mod block;
mod feet;
mod gram;
mod passes;
mod point;
mod view;

pub(crate) use feet::Spread;
pub(crate) use gram::{COLUMNS, Gram};
pub(crate) use view::{ModelView, Residual};

use feet::{Feet, FeetOf};
use passes::{DistancesOf, GramOf, NormalsOf};
use rayon::prelude::*;

use crate::cloud::PointColumns;
use crate::machine::vectorized;

/// Points whose rows are summed in one go: fixed, so that the sum does not depend on how many
/// threads share the work.
const CHUNK: usize = 64 * gram::BLOCK;

/// The Gram matrix `[r J]' [r J]` of the problem over all points, each row multiplied by its factor
/// where there are factors. A view with a spread has the rows of the points' feet.
///
/// Memory does not depend on the number of points but for 1 kB a chunk; nor do the bytes of
/// the result on `parallel`.
pub(crate) fn gram(
    view: &ModelView,
    points: PointColumns,
    factors: Option<&[f64]>,
    parallel: bool,
) -> Gram {
    let count = points[0].len();
    let chunk = |index: usize| {
        let range = index * CHUNK..count.min((index + 1) * CHUNK);
        let factors = factors.map(|factors| &factors[range.clone()]);
        let points = points.map(|column| &column[range.clone()]);
        match &view.spread {
            None => vectorized::run(GramOf { view, points, factors }),
            Some(spread) => gram_of_feet(view, spread, points, factors),
        }
    };
    let chunks = count.div_ceil(CHUNK);
    if chunks == 1 {
        return chunk(0);
    }
    if !parallel {
        return sum((0..chunks).map(chunk));
    }
    let partial: Vec<Gram> = (0..chunks).into_par_iter().map(chunk).collect();
    sum(partial)
}

fn gram_of_feet(
    view: &ModelView,
    spread: &Spread,
    points: PointColumns,
    factors: Option<&[f64]>,
) -> Gram {
    let Feet { points, factors: mut own } = vectorized::run(FeetOf { view, spread, points });
    if let Some(factors) = factors {
        own.iter_mut().zip(factors).for_each(|(own, factor)| *own *= factor);
    }
    let points = points.each_ref().map(|column| &column[..]);
    vectorized::run(GramOf { view: &view.in_model_frame(), points, factors: Some(&own) })
}

/// The signed first-order geometric distance of each point, in normalised units.
pub(crate) fn geometric_distances(
    view: &ModelView,
    points: PointColumns,
    parallel: bool,
) -> Vec<f64> {
    let mut distances = vec![0.0; points[0].len()];
    let fill = |(index, distances): (usize, &mut [f64])| {
        let range = index * CHUNK..index * CHUNK + distances.len();
        let points = points.map(|column| &column[range.clone()]);
        vectorized::run(DistancesOf { view, points, distances });
    };
    if parallel {
        distances.par_chunks_mut(CHUNK).enumerate().for_each(fill);
    } else {
        distances.chunks_mut(CHUNK).enumerate().for_each(fill);
    }
    distances
}

/// The unit normal of the gauge's level at each point, in the model's frame.
pub(crate) fn normals(view: &ModelView, points: PointColumns) -> Vec<[f64; 3]> {
    vectorized::run(NormalsOf { view, points })
}

fn sum(grams: impl IntoIterator<Item = Gram>) -> Gram {
    grams.into_iter().fold(Gram::zero(), |mut total, gram| {
        total.add(&gram);
        total
    })
}

#[cfg(test)]
mod tests;
