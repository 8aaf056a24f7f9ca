//! The superhyperboloid of two sheets over two pyramids: the square base goes to the cap, the four
//! sides to the bowl.

use nalgebra::Vector3;

use super::super::grading::{Grading, lattice_lines};
use super::{Chart, Lattice, Square};
use crate::math::increasing_root;
use crate::shape::SuperhyperboloidTwoSheets;

/// How far a pyramid's apex and base are from the centre.
const APEX: f64 = 1.0;
const BASE: f64 = 2.0;

/// Places this near to the base are of the cap: rounding moves none further.
const ROUNDING: f64 = 1e-9;

impl Chart for SuperhyperboloidTwoSheets {
    fn size(&self) -> [f64; 3] {
        self.size()
    }

    /// The first coordinate tells bowl from cap, the others are those of a square that the rim
    /// bounds.
    fn unit_point(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let [v, w] = within_rim(self, [place.y, place.z]);
        let height = if self.is_on_cap(place) { self.top() } else { self.height(v.abs(), w.abs()) };
        Vector3::new(height.copysign(place.x), v, w)
    }

    fn is_on_cap(&self, place: &Vector3<f64>) -> bool {
        place.x.abs() > BASE - ROUNDING
    }

    /// A square lattice of `n` cells a side, laid on a bowl and once more on its cap: both have the
    /// square's boundary, the rim, in common.
    fn lattice(&self, n: usize, grading: Grading) -> Lattice {
        let lines = lattice_lines(n, &[1.0], grading);
        let squares: Vec<[f64; 2]> = (0..=n)
            .flat_map(|j| (0..=n).map(move |i| [i, j]))
            .map(|c| c.map(|i| lines[i]))
            .collect();
        let inner = (0..squares.len()).filter(|&i| share(squares[i]) < 1.0);

        let on_bowl = squares.iter().map(|&[p, q]| [APEX + (BASE - APEX) * share([p, q]), p, q]);
        let on_cap = inner.clone().map(|i| [BASE, squares[i][0], squares[i][1]]);
        let pyramid: Vec<Vector3<f64>> = on_bowl.chain(on_cap).map(Vector3::from).collect();

        // The cap's number of a place: its own, or that of the rim.
        let mut cap_numbers: Vec<usize> = (0..squares.len()).collect();
        inner.enumerate().for_each(|(k, i)| cap_numbers[i] = squares.len() + k);

        let count = pyramid.len();
        let mirrored = pyramid.iter().map(|x| Vector3::new(-x.x, x.y, x.z));
        let cells = cells(n).flat_map(|cell| {
            let [cap, mirrored] = [cell.map(|i| cap_numbers[i]), cell.map(|i| i + count)];
            let mirrored_cap = cap.map(|i| i + count);
            // As seen from the apex of positive x a cell runs clockwise.
            [cell.reversed(), cap, mirrored, mirrored_cap.reversed()]
        });
        let places = pyramid.iter().copied().chain(mirrored).collect();
        Lattice::new(self, places, cells)
    }
}

/// How far a place of the square is from its middle towards its boundary.
fn share([p, q]: [f64; 2]) -> f64 {
    p.abs().max(q.abs())
}

/// The `[v, w]` of a place of the square `[-1, 1]^2`: as far towards the rim as it is towards the
/// square's boundary.
pub(crate) fn within_rim(bowls: &SuperhyperboloidTwoSheets, [p, q]: [f64; 2]) -> [f64; 2] {
    let share = share([p, q]);
    if share == 0.0 {
        return [0.0; 2];
    }
    // The square's corners go towards those of the rim's box, where small exponents bend the rim.
    let [greatest_v, greatest_w] = bowls.greatest_vw();
    let [v, w] = [p / share * greatest_v, q / share * greatest_w];
    let excess = |r: f64| bowls.height(r * v.abs(), r * w.abs()) - bowls.top();
    let rim = share * increasing_root(excess, [0.0, 1.0]);
    [rim * v, rim * w]
}

/// Every cell of the square lattice, counter-clockwise in the plane of p and q, and cut along the
/// pyramid's edges where it lies on one.
fn cells(n: usize) -> impl Iterator<Item = Square> {
    let number = move |i: usize, j: usize| j * (n + 1) + i;
    (0..n * n).map(move |cell| {
        let (i, j) = (cell % n, cell / n);
        let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
        match (i == j, i + j + 1 == n) {
            (true, _) => Square::Creased([a, b, c, d]),
            (_, true) => Square::Creased([b, c, d, a]),
            _ => Square::Plain([a, b, c, d]),
        }
    })
}
