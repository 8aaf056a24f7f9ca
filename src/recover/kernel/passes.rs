//! The passes over points, block by block, compiled for each instruction set, and once for each
//! precision and residual.

use super::block::{Scratch, write_powers, write_rows};
use super::gram::{BLOCK, Gram, Rows};
use super::point::Point;
use super::view::ModelView;
use crate::machine::Products;
use crate::machine::vectorized::Kernel;
use crate::math::lane::Lane;
use crate::recover::options::Precision;

/// The Gram matrix over the points; each row multiplied by its factor, where there are any.
pub(super) struct GramOf<'a> {
    pub view: &'a ModelView,
    pub points: [&'a [f64]; 3],
    pub factors: Option<&'a [f64]>,
}

impl Kernel for GramOf<'_> {
    type Output = Gram;

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) -> Gram {
        match (self.view.precision, self.view.is_geometric) {
            (Precision::Single, true) => self.sum::<f32, P, FMA, true>(),
            (Precision::Single, false) => self.sum::<f32, P, FMA, false>(),
            (Precision::Double, true) => self.sum::<f64, P, FMA, true>(),
            (Precision::Double, false) => self.sum::<f64, P, FMA, false>(),
        }
    }
}

impl GramOf<'_> {
    #[inline(always)]
    fn sum<L: Lane, P: Products, const FMA: bool, const GEOMETRIC: bool>(self) -> Gram {
        let Self { view, points: [xs, ys, zs], factors } = self;
        let mut scratch = Scratch::<L>::new();
        let mut rows = Rows::new();
        let mut total = Gram::zero();
        let count = xs.len();
        for start in (0..count).step_by(BLOCK) {
            let end = count.min(start + BLOCK);
            let block = [&xs[start..end], &ys[start..end], &zs[start..end]];
            write_rows::<L, FMA, GEOMETRIC>(view, block, &mut scratch, &mut rows);
            if let Some(factors) = factors {
                rows.multiply(&factors[start..end]);
            }
            total.add_block::<P>(&rows);
        }
        total
    }
}

/// The signed geometric distance of each point, to be written to `distances`.
pub(super) struct DistancesOf<'a> {
    pub view: &'a ModelView,
    pub points: [&'a [f64]; 3],
    pub distances: &'a mut [f64],
}

impl Kernel for DistancesOf<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) {
        let Self { view, points: [xs, ys, zs], distances } = self;
        let mut scratch = Scratch::<f64>::new();
        for (index, distances) in distances.chunks_mut(BLOCK).enumerate() {
            let (start, end) = (index * BLOCK, index * BLOCK + distances.len());
            let block = [&xs[start..end], &ys[start..end], &zs[start..end]];
            write_powers::<f64, FMA>(view, block, &mut scratch);
            for (i, distance) in distances.iter_mut().enumerate() {
                *distance = Point::at(view, &scratch, i).geometric_distance();
            }
        }
    }
}

/// The unit normal of the gauge's level at each point, in the model's frame.
pub(super) struct NormalsOf<'a> {
    pub view: &'a ModelView,
    pub points: [&'a [f64]; 3],
}

impl Kernel for NormalsOf<'_> {
    type Output = Vec<[f64; 3]>;

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) -> Self::Output {
        let Self { view, points: [xs, ys, zs] } = self;
        let mut scratch = Scratch::<f64>::new();
        let mut normals = vec![[0.0; 3]; xs.len()];
        for (index, normals) in normals.chunks_mut(BLOCK).enumerate() {
            let (start, end) = (index * BLOCK, index * BLOCK + normals.len());
            let block = [&xs[start..end], &ys[start..end], &zs[start..end]];
            write_powers::<f64, FMA>(view, block, &mut scratch);
            for (i, normal) in normals.iter_mut().enumerate() {
                *normal = Point::at(view, &scratch, i).normal();
            }
        }
        normals
    }
}
