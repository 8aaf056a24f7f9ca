//! The solid of three exponents over a cube, projected from the centre.

use nalgebra::Vector3;

use super::super::grading::{Grading, lattice_lines};
use super::super::lattice::CubeLattice;
use super::{Chart, Lattice, Square};
use crate::shape::ThreeExponent;

impl Chart for ThreeExponent {
    fn size(&self) -> [f64; 3] {
        self.size()
    }

    fn unit_point(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let x = place.component_mul(&Vector3::from(self.size()));
        place * self.radial_factor(&x)
    }

    fn lattice(&self, n: usize, grading: Grading) -> Lattice {
        let lines = lattice_lines(n, &self.exponents().map(|n| 2.0 / n), grading);
        let lattice = CubeLattice::new(n);
        let places = lattice.points().map(|cell| Vector3::from(cell.map(|i| lines[i])));
        let squares = lattice.squares().map(|square| square.map(|corner| lattice.number(corner)));
        Lattice::new(self, places.collect(), squares.map(Square::Plain))
    }
}
