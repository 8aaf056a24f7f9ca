//! Rows of the solid of three exponents, which is no spherical product: its sections at constant
//! height are not scaled copies of each other, but each is a curve of two exponents.

use nalgebra::Vector3;

use super::{Parameterization, angle_centre, around, equal_distance, explicit, trigonometric};
use crate::shape::ThreeExponent;

/// Points from `(a, 0)` to `(0, b)` along `(x/a)^(2/e1) + (y/b)^(2/e2) = 1`, of semi-axes, exponents
/// and a number of steps.
type Quarter = fn([f64; 2], [f64; 2], usize) -> Vec<[f64; 2]>;

impl Parameterization {
    /// Rows from pole to pole, as those of a superellipsoid, which they are where the exponents are
    /// equal.
    pub(super) fn three_exponent(self, shape: &ThreeExponent, n: usize) -> Vec<Vec<Vector3<f64>>> {
        match self {
            Self::Trigonometric => sections(shape, n, trigonometric::quarter),
            Self::AngleCentre => angle_centre::rows(n, |ray| ray * shape.radial_factor(ray)),
            Self::Explicit => sections(shape, n, explicit::quarter),
            Self::EqualDistance => sections(shape, n, equal_distance::quarter),
        }
    }
}

/// Rows of constant height. Their heights are those of points along the meridian of the longer of
/// the semi-axes a1 and a2, widened as that of a superellipsoid is, towards the equator's corner.
fn sections(shape: &ThreeExponent, n: usize, quarter: Quarter) -> Vec<Vec<Vector3<f64>>> {
    let [a1, a2, a3] = shape.size();
    let [n1, n2, n3] = shape.exponents();
    let longer = if a1 >= a2 { n1 } else { n2 };
    let width = a1.hypot(a2);
    let row = |[radius, z]: [f64; 2]| {
        let [x, y] = [n1, n2].map(|n| (radius / width).powf(longer / n));
        let section = quarter([a1 * x, a2 * y], [2.0 / n1, 2.0 / n2], n);
        around(&section).map(|[x, y]| Vector3::new(x, y, z)).collect()
    };
    let north: Vec<Vec<_>> =
        quarter([width, a3], [2.0 / longer, 2.0 / n3], n).into_iter().map(row).collect();
    let mirrored =
        |row: &Vec<Vector3<f64>>| row.iter().map(|x| Vector3::new(x.x, x.y, -x.z)).collect();
    let south: Vec<Vec<_>> = north.iter().skip(1).rev().map(mirrored).collect();
    south.into_iter().chain(north).collect()
}
