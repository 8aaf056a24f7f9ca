//! The six methods of FB81, a file each, on the unit superellipsoid's first octant.
//!
//! 1. [`RawParametric`]: sines, cosines and their powers, anew for every point;
//! 2. [`Explicit`]: z of x and y, exactly;
//! 3. [`Series`]: z of x and y by three terms of the binomial series;
//! 4. [`LogTable`]: the same, with a table of the coordinates' logarithms;
//! 5. [`SphericalProduct`]: two products of coordinates of superellipses that were calculated
//!    before;
//! 6. [`PowerTables`]: z of x and y by tables of both powers.
//!
//! The paper treats equal exponents, `z = (1 - x^n - y^n)^(1/n)` with `n = 2/e`; here they may
//! differ (JLS Eq. 2.70, its outer exponent corrected).

mod explicit;
mod log_table;
mod power_tables;
mod raw_parametric;
mod series;
mod spherical_product;
mod square;

pub use explicit::Explicit;
pub use log_table::LogTable;
pub use power_tables::PowerTables;
pub use raw_parametric::RawParametric;
pub use series::Series;
pub use spherical_product::SphericalProduct;

use crate::machine::Products;
use crate::machine::vectorized::{self, Kernel};

/// A way to calculate points of the unit superellipsoid in its first octant.
///
/// Points are numbered `(i, j)`, by steps along two parameters, both below
/// [`steps`](Self::steps).
pub trait Method {
    /// Steps along each parameter.
    fn steps(&self) -> usize;

    /// The point `(i, j)`. Domain: `i`, `j` below the number of steps.
    fn point(&self, i: usize, j: usize) -> [f64; 3];

    /// The points `(0, j)`, `(1, j)`, .. into columns x, y and z of as many values each as there
    /// are steps, in loops that the compiler vectorises. `FMA` says whether the target fuses
    /// `a b + c`.
    fn row_for<const FMA: bool>(&self, j: usize, columns: [&mut [f64]; 3]);

    /// [`row_for`](Self::row_for), by the best path that the processor has.
    fn row(&self, j: usize, columns: [&mut [f64]; 3])
    where
        Self: Sized,
    {
        vectorized::run(Row { method: self, j, columns });
    }
}

struct Row<'a, M> {
    method: &'a M,
    j: usize,
    columns: [&'a mut [f64]; 3],
}

impl<M: Method> Kernel for Row<'_, M> {
    type Output = ();

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) {
        self.method.row_for::<FMA>(self.j, self.columns);
    }
}

#[cfg(test)]
mod tests;
