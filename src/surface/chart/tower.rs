//! The superhyperboloid of one sheet over a cube whose lids are the caps: levels of z are
//! superellipses.

use nalgebra::Vector3;

use super::super::grading::{Grading, lattice_lines, profile_lines};
use super::super::lattice::CubeLattice;
use super::superellipsoid::flattened_cube_point;
use super::{Chart, Lattice, Square};
use crate::shape::SuperhyperboloidOneSheet;

/// Places this near to the cube's sides are of the wall: rounding moves none further.
const ROUNDING: f64 = 1e-9;

impl Chart for SuperhyperboloidOneSheet {
    fn size(&self) -> [f64; 3] {
        self.size()
    }

    /// Places have z as points do.
    fn unit_point(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let level = flattened_cube_point([place.x, place.y, 0.0], self.exponents()[1]);
        level * self.radius(place.z.abs()) + Vector3::new(0.0, 0.0, place.z)
    }

    fn is_on_cap(&self, place: &Vector3<f64>) -> bool {
        place.x.abs().max(place.y.abs()) < 1.0 - ROUNDING
    }

    fn lattice(&self, n: usize, grading: Grading) -> Lattice {
        let across = lattice_lines(n, &[self.exponents()[1]], grading);
        let heights = profile_lines(n, self.top(), |w| self.radius(w), grading);
        let lattice = CubeLattice::new(n);
        let places =
            lattice.points().map(|[i, j, k]| Vector3::new(across[i], across[j], heights[k]));
        let squares = lattice.squares().map(|square| square.map(|corner| lattice.number(corner)));
        Lattice::new(self, places.collect(), squares.map(Square::Plain))
    }
}
