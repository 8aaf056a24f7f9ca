//! Rows of points of every family.

use nalgebra::Vector3;

use super::{Parameterization, around, rows};
use crate::shape::{Shape, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid};

impl Parameterization {
    /// Points of a shape in the model's frame, in rows that run around z, or towards it around x;
    /// all rows have the same number of points, and there are none for `n = 0`.
    ///
    /// - Of a superellipsoid those of [`superellipsoid`](Self::superellipsoid). Of the solid of
    ///   three exponents likewise, though it is no spherical product: its rows are curves of two
    ///   exponents, on which the parameterisations have the same meaning, explicit points being cut
    ///   at the diagonal of the row's box; the heights are those of the meridian of the longer of
    ///   a1 and a2.
    /// - Of a supertoroid `4 n` rows around its tube, beginning on its outside, of `4 n` points from
    ///   the x axis on around z.
    /// - Of a superhyperboloid of one sheet `2 n + 1` rows from the lower rim to the upper one, of
    ///   `4 n` points from the x axis on around z.
    /// - Of a superhyperboloid of two sheets `2 n + 1` rows of the first sheet, then those of the
    ///   second, which are the first's after half a turn about z. A row is at one height and leads
    ///   from rim to rim in `2 n + 1` points, counter-clockwise about z; the lowest and the highest
    ///   row are the points at which the rim is lowest and highest, once for every point of the row.
    ///
    /// The meridians of these two, and the rows of two sheets, are superhyperbolas, of which y or z
    /// changes faster; points at equal angles are so at the centre of the curve.
    pub fn shape(self, shape: &Shape, n: usize) -> Vec<Vec<Vector3<f64>>> {
        match shape {
            _ if n == 0 => Vec::new(),
            Shape::Superellipsoid(shape) => self.superellipsoid(shape, n),
            Shape::Supertoroid(torus) => self.supertoroid(torus, n),
            Shape::SuperhyperboloidOneSheet(tower) => self.tower(tower, n),
            Shape::SuperhyperboloidTwoSheets(bowls) => self.bowls(bowls, n),
            Shape::ThreeExponent(shape) => self.three_exponent(shape, n),
        }
    }

    fn supertoroid(self, torus: &Supertoroid, n: usize) -> Vec<Vec<Vector3<f64>>> {
        let [a1, a2, a3] = torus.size();
        let [e1, e2] = torus.exponents();
        // Distances along the tube are those of its widest copy.
        let width = a1.hypot(a2);
        let tube = around(&self.quarter([width, a3], e1, n))
            .map(|[across, z]| [torus.ring() + across / width, z])
            .collect::<Vec<_>>();
        let ring: Vec<[f64; 2]> = around(&self.quarter([a1, a2], e2, n)).collect();
        rows(&tube, &ring)
    }

    fn tower(self, tower: &SuperhyperboloidOneSheet, n: usize) -> Vec<Vec<Vector3<f64>>> {
        let [a1, a2, a3] = tower.size();
        let [e1, e2] = tower.exponents();
        let upper = self.half_branch([a1.hypot(a2), a3], e1, tower.top(), n);
        let meridian: Vec<[f64; 2]> =
            mirrored(&upper).map(|w| [tower.radius(w.abs()), a3 * w]).collect();
        let equator: Vec<[f64; 2]> = around(&self.quarter([a1, a2], e2, n)).collect();
        rows(&meridian, &equator)
    }

    fn bowls(self, bowls: &SuperhyperboloidTwoSheets, n: usize) -> Vec<Vec<Vector3<f64>>> {
        let [a1, _, a3] = bowls.size();
        let [_, highest] = bowls.greatest_vw();
        let upper = self.half_branch([a1, a3], bowls.exponents()[0], highest, n);
        let first: Vec<Vec<_>> =
            mirrored(&upper).map(|w| self.row_of_bowl(bowls, w, highest, n)).collect();
        let turned = |row: &Vec<Vector3<f64>>| {
            row.iter().map(|x| Vector3::new(-x.x, -x.y, x.z)).collect::<Vec<_>>()
        };
        let second: Vec<Vec<_>> = first.iter().map(turned).collect();
        first.into_iter().chain(second).collect()
    }

    /// The row at the height `w a3` of the bowl towards x, from rim to rim.
    fn row_of_bowl(
        self,
        bowls: &SuperhyperboloidTwoSheets,
        w: f64,
        highest: f64,
        n: usize,
    ) -> Vec<Vector3<f64>> {
        let [a1, a2, a3] = bowls.size();
        let waist = bowls.waist(w.abs());
        // At its highest, rounding would leave the rim a width.
        let reach = if w.abs() < highest { bowls.greatest_v(w.abs()) / waist } else { 0.0 };
        let half = self.half_branch([a1, a2], bowls.exponents()[1], reach, n);
        let point = |v: f64| {
            Vector3::new(a1 * bowls.height(waist * v.abs(), w.abs()), a2 * waist * v, a3 * w)
        };
        mirrored(&half).map(point).collect()
    }
}

/// Numbers that begin with 0, after their opposites.
fn mirrored(half: &[f64]) -> impl Iterator<Item = f64> {
    half.iter().skip(1).rev().map(|v| -v).chain(half.iter().copied())
}

#[cfg(test)]
mod tests;
