//! Vertices by columns, as graphics hardware takes them.

use crate::machine::Products;
use crate::machine::vectorized::{self, Kernel};

/// Points of a surface as columns of x, y and z.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct VertexArray {
    columns: [Vec<f32>; 3],
}

impl VertexArray {
    /// The number of vertices.
    pub fn len(&self) -> usize {
        self.columns[0].len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.columns[0].is_empty()
    }

    /// The coordinates along axis 0, 1 or 2, a value a vertex.
    pub fn column(&self, axis: usize) -> &[f32] {
        &self.columns[axis]
    }

    /// The vertices one by one.
    pub fn points(&self) -> impl ExactSizeIterator<Item = [f32; 3]> {
        (0..self.len()).map(|i| self.columns.each_ref().map(|column| column[i]))
    }

    /// Room for so many vertices; memory is kept for the next writing.
    pub(super) fn resize(&mut self, count: usize) {
        self.columns.iter_mut().for_each(|column| column.resize(count, 0.0));
    }

    #[inline(always)]
    pub(super) fn column_mut(&mut self, axis: usize) -> &mut [f32] {
        &mut self.columns[axis]
    }
}

/// Writes the spherical product of a meridian and an equator (B81), a row of the equator's length
/// for each point of the meridian: two products a vertex (FB81's method 5).
///
/// Both are curves in the shape's unit: for a superellipsoid, `(cos^e1, a3 sin^e1)` and
/// `(a1 cos^e2, a2 sin^e2)` (JLS Eq. 2.10).
pub fn write_product(vertices: &mut VertexArray, meridian: &[[f64; 2]], equator: &[[f64; 2]]) {
    vertices.resize(meridian.len() * equator.len());
    let equator = [0, 1].map(|axis| equator.iter().map(|h| h[axis] as f32).collect::<Vec<_>>());
    vectorized::run(Product { vertices, meridian, equator });
}

struct Product<'a> {
    vertices: &'a mut VertexArray,
    meridian: &'a [[f64; 2]],
    equator: [Vec<f32>; 2],
}

impl Kernel for Product<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) {
        let length = self.equator[0].len();
        let [xs, ys, zs] = &mut self.vertices.columns;
        for (j, &[radius, height]) in self.meridian.iter().enumerate() {
            let row = j * length..(j + 1) * length;
            for (column, equator) in [&mut *xs, &mut *ys].into_iter().zip(&self.equator) {
                for (coordinate, h) in column[row.clone()].iter_mut().zip(equator) {
                    *coordinate = radius as f32 * h;
                }
            }
            zs[row].fill(height as f32);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Superellipsoid;

    #[test]
    fn a_product_of_superellipses_is_their_superellipsoid() {
        let shape = Superellipsoid::new([2.0, 1.0, 0.5], [0.4, 1.3]).unwrap();
        let angles = |n: i32| (0..n).map(move |i| f64::from(i) * 0.1 - 1.5);
        let meridian: Vec<[f64; 2]> =
            angles(31).map(|eta| shape.position(eta, 0.0)).map(|x| [x.x / 2.0, x.z]).collect();
        let equator: Vec<[f64; 2]> =
            angles(40).map(|omega| shape.position(0.0, omega)).map(|x| [x.x, x.y]).collect();
        let mut vertices = VertexArray::default();
        write_product(&mut vertices, &meridian, &equator);
        assert_eq!(vertices.len(), 31 * 40);
        let places = angles(31).flat_map(|eta| angles(40).map(move |omega| (eta, omega)));
        for ((eta, omega), x) in places.zip(vertices.points()) {
            // Coordinates up to 2 of 24 bits, twice rounded.
            let error = shape.position(eta, omega) - nalgebra::Vector3::from(x.map(f64::from));
            assert!(error.amax() < 4e-7, "{eta} {omega} {error}");
        }
    }
}
