//! The supertoroid over a frame of square bars: the squares' sides go to quarters of tube and
//! ring.

use nalgebra::Vector3;

use super::super::grading::{Grading, lattice_lines};
use super::{Chart, Lattice, Square};
use crate::shape::{Supertoroid, superellipse_norm};

/// Half of the frame's width to the middle of its bars, which are 2 thick.
const FRAME: f64 = 2.0;

impl Chart for Supertoroid {
    fn size(&self) -> [f64; 3] {
        self.size()
    }

    fn unit_point(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let [tube, ring] = self.exponents();
        let [x, y] = on_superellipse([place.x, place.y], ring);
        let beside = place.x.abs().max(place.y.abs()) - FRAME;
        let [across, up] = on_superellipse([beside, place.z], tube);
        let radius = self.ring() + across;
        Vector3::new(radius * x, radius * y, up)
    }

    /// `4 n` squares around the tube and around the ring.
    fn lattice(&self, n: usize, grading: Grading) -> Lattice {
        let [tube, ring] = self.exponents().map(|e| square_loop(n, e, grading));
        let places = ring.iter().flat_map(|[p, q]| {
            tube.iter().map(move |[across, up]| {
                let width = FRAME + across;
                Vector3::new(width * p, width * q, *up)
            })
        });
        let around = 4 * n;
        let number = move |i: usize, j: usize| (i % around) * around + j % around;
        let squares = (0..around).flat_map(move |i| {
            (0..around).map(move |j| {
                [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)]
            })
        });
        Lattice::new(self, places.collect(), squares.map(Square::Plain))
    }
}

/// The point of the unit superellipse in a direction.
fn on_superellipse([x, y]: [f64; 2], e: f64) -> [f64; 2] {
    let norm = superellipse_norm(x.abs(), y.abs(), e);
    [x / norm, y / norm]
}

/// `4 n` places counter-clockwise around the square of side 2, graded for an exponent.
fn square_loop(n: usize, e: f64, grading: Grading) -> Vec<[f64; 2]> {
    let lines = lattice_lines(n, &[e], grading);
    let on_side = |side: usize, t: f64| match side {
        0 => [1.0, t],
        1 => [-t, 1.0],
        2 => [-1.0, -t],
        _ => [t, -1.0],
    };
    (0..4).flat_map(|side| lines[..n].iter().map(move |&t| on_side(side, t))).collect()
}
