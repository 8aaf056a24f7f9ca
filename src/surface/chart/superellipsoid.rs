//! The superellipsoid over a polyhedron inscribed in it, projected from the centre.

use nalgebra::Vector3;

use super::super::grading::{Grading, lattice_lines};
use super::super::lattice::CubeLattice;
use super::{Chart, Lattice, Square};
use crate::shape::{Superellipsoid, superellipse_norm};

impl Chart for Superellipsoid {
    fn size(&self) -> [f64; 3] {
        self.size()
    }

    fn unit_point(&self, place: &Vector3<f64>) -> Vector3<f64> {
        self.with_size([1.0; 3]).radial_projection(place)
    }

    /// The lattice of a cube whose edges become edges of the solid.
    fn lattice(&self, n: usize, grading: Grading) -> Lattice {
        let [e1, e2] = self.exponents();
        let across = lattice_lines(n, &[e1, e2], grading);
        let along = lattice_lines(n, &[e1], grading);
        let lattice = CubeLattice::new(n);
        let places = lattice
            .points()
            .map(|[i, j, k]| flattened_cube_point([across[i], across[j], along[k]], e2))
            .map(|x| self.unit_point(&x));
        let numbers = |corners: [[usize; 3]; 4]| corners.map(|corner| lattice.number(corner));
        let squares = lattice.squares().map(|square| match along_crease(square, n) {
            Some(corners) => Square::Creased(numbers(corners)),
            None => Square::Plain(numbers(square)),
        });
        Lattice::new(self, places.collect(), squares)
    }
}

/// A point of the cube's surface, moved so that squares about the z axis become superellipses
/// of exponent e2: edges of the cube become edges of the solid.
pub(crate) fn flattened_cube_point([x, y, z]: [f64; 3], e2: f64) -> Vector3<f64> {
    let side = x.abs().max(y.abs());
    let shrink = if side == 0.0 { 1.0 } else { side / superellipse_norm(x.abs(), y.abs(), e2) };
    Vector3::new(x * shrink, y * shrink, z)
}

/// The corners of a square from one on, if that and the third are where a lid is bent along
/// `|x/a1| = |y/a2|`.
fn along_crease(square: [[usize; 3]; 4], n: usize) -> Option<[[usize; 3]; 4]> {
    let is_on_lid = square.iter().all(|&[_, _, k]| k == square[0][2] && (k == 0 || k == n));
    let is_on_crease = |&[i, j, _]: &[usize; 3]| i == j || i + j == n;
    let [a, b, c, d] = square;
    match [[a, c], [b, d]].map(|diagonal| diagonal.iter().all(is_on_crease)) {
        [true, _] if is_on_lid => Some([a, b, c, d]),
        [_, true] if is_on_lid => Some([b, c, d, a]),
        _ => None,
    }
}
