//! Parameterisations of a superellipse, of a superellipsoid (JLS section 2.5), a file each, and of the
//! other families: where along them points are taken.
//!
//! Points at random, uniform by area, are [`sample_surface`](crate::surface::sample_surface)'s.

mod angle_centre;
mod equal_distance;
mod explicit;
mod families;
mod superhyperbola;
mod three_exponent;
mod trigonometric;

use nalgebra::{Vector2, Vector3};

use crate::shape::{Superellipse, Superellipsoid};

/// How points are spread along a curve, from an axis to the next in `n` steps.
///
/// Of the unit superellipse, whatever its exponent up to 2, the longest of many steps is at most
/// so many times the shortest: 1 for equal distances, 1.42 for explicit points, 2 for equal
/// angles at the centre. The trigonometric one has no such bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameterization {
    /// Equal steps of the angle in `(a cos^e, b sin^e)` (JLS Eqs. 2.9, 2.10): points crowd where
    /// the curve is bent, far more than it is.
    Trigonometric,
    /// Equal steps of the angle at the centre (Löffelmann and Gröller 1994; JLS Eqs. 2.71, 2.72).
    AngleCentre,
    /// Equal steps of the coordinate that changes faster, the other one being calculated from it
    /// (FB81; JLS Eq. 2.70, its outer exponent corrected).
    Explicit,
    /// Equal steps along the curve (Pilu and Fisher 1995).
    EqualDistance,
}

impl Parameterization {
    /// All of them.
    pub const ALL: [Self; 4] =
        [Self::Trigonometric, Self::AngleCentre, Self::Explicit, Self::EqualDistance];

    /// `4 n` points of a superellipse, counter-clockwise from `(a, 0)`, on all four axes; none
    /// for `n = 0`. Explicit points come in pairs of steps: for them `n` is even, or made so.
    pub fn superellipse(self, figure: &Superellipse, n: usize) -> Vec<Vector2<f64>> {
        let quarter = self.quarter(figure.size(), figure.exponent(), n);
        around(&quarter).map(Vector2::from).collect()
    }

    /// Points of a superellipsoid, in the model's frame: `2 n + 1` rows from the south pole to the
    /// north pole, each of `4 n` points from the x axis on around z. Poles come once for every
    /// point of their row. For explicit points `n` is even, or made so.
    ///
    /// They are the spherical product (B81) of such a meridian and such an equator, but for
    /// [`AngleCentre`](Self::AngleCentre), whose angles are those of rays in space.
    pub fn superellipsoid(self, shape: &Superellipsoid, n: usize) -> Vec<Vec<Vector3<f64>>> {
        if self == Self::AngleCentre {
            return angle_centre::rows(n, |ray| shape.radial_projection(ray));
        }
        let [meridian, equator] = self.product(shape, |_| n);
        rows(&meridian, &equator)
    }

    /// The meridian `(m1, a3 m2)` from the south pole to the north pole, and the equator
    /// `(a1 h1, a2 h2)` once around, whose spherical product (B81) is the superellipsoid.
    ///
    /// `steps` gives the number of steps of a quarter from a bound on its length in space.
    /// Distances along the meridian are those of its greatest copy, towards the equator's corner.
    pub(crate) fn product(
        self,
        shape: &Superellipsoid,
        steps: impl Fn(f64) -> usize,
    ) -> [Vec<[f64; 2]>; 2] {
        let [a1, a2, a3] = shape.size();
        let [e1, e2] = shape.exponents();
        let equator = self.quarter([a1, a2], e2, steps(a1 + a2));
        let radius = a1.hypot(a2);
        let meridian = self.quarter([radius, a3], e1, steps(radius + a3));
        let north = meridian.iter().map(|&[r, z]| [r / radius, z]);
        let south = north.clone().skip(1).rev().map(|[scale, z]| [scale, -z]);
        [south.chain(north).collect(), around(&equator).collect()]
    }

    /// `n + 1` points of a superellipse from `(a, 0)` to `(0, b)`.
    fn quarter(self, size: [f64; 2], e: f64, n: usize) -> Vec<[f64; 2]> {
        match self {
            Self::Trigonometric => trigonometric::quarter(size, [e, e], n),
            Self::AngleCentre => angle_centre::quarter(size, e, n),
            Self::Explicit => explicit::quarter(size, [e, e], n),
            Self::EqualDistance => equal_distance::quarter(size, [e, e], n),
        }
    }
}

/// The spherical product (B81) of a meridian of scales and heights with an equator.
fn rows(meridian: &[[f64; 2]], equator: &[[f64; 2]]) -> Vec<Vec<Vector3<f64>>> {
    let row = |&[scale, z]: &[f64; 2]| {
        equator.iter().map(|[x, y]| Vector3::new(scale * x, scale * y, z)).collect()
    };
    meridian.iter().map(row).collect()
}

/// A quarter and its reflections, once around without the end of each.
fn around(quarter: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> + Clone {
    let steps = quarter.len().saturating_sub(1);
    let first = quarter[..steps].iter().copied();
    let last = quarter.iter().skip(1).rev().copied();
    first
        .clone()
        .chain(last.clone().map(|[x, y]| [-x, y]))
        .chain(first.map(|[x, y]| [-x, -y]))
        .chain(last.map(|[x, y]| [x, -y]))
}

#[cfg(test)]
mod tests;
