//! The mesh of a superhyperboloid of two sheets: two bowls, each closed by its cap.

use nalgebra::Vector3;

use super::super::grading::{Grading, lattice_lines};
use super::super::mesh::Mesh;
use super::stretched;
use crate::math::increasing_root;
use crate::shape::SuperhyperboloidTwoSheets;

/// A square lattice of `n` cells a side, laid on a bowl and once more on its cap: both have the
/// square's boundary, the rim, in common.
pub(super) fn mesh(bowls: &SuperhyperboloidTwoSheets, n: usize) -> Mesh {
    let lines = lattice_lines(n, &[1.0], Grading::Even);
    let places: Vec<[f64; 2]> = (0..=n)
        .flat_map(|j| (0..=n).map(move |i| [i, j]))
        .map(|[i, j]| place(bowls, [lines[i], lines[j]]))
        .collect();
    let on_bowl = places.iter().map(|&[v, w]| Vector3::new(bowls.height(v.abs(), w.abs()), v, w));
    let inner = (0..places.len()).filter(|&i| !is_rim(i, n));
    let on_cap = inner.clone().map(|i| Vector3::new(bowls.top(), places[i][0], places[i][1]));
    let bowl: Vec<Vector3<f64>> = on_bowl.chain(on_cap).collect();

    // The cap's number of a place: its own, or that of the rim.
    let mut cap_numbers: Vec<usize> = (0..places.len()).collect();
    inner.enumerate().for_each(|(k, i)| cap_numbers[i] = places.len() + k);

    let count = bowl.len();
    let mirrored = bowl.iter().map(|x| Vector3::new(-x.x, x.y, x.z));
    let unit: Vec<Vector3<f64>> = bowl.iter().copied().chain(mirrored).collect();
    let squares = cells(n).flat_map(|cell| {
        let cap = cell.map(|i| cap_numbers[i]);
        // As seen from the apex a cell runs clockwise.
        let [outside, opposite] = [cell, cap].map(|[a, b, c, d]| [d, c, b, a]);
        [outside, cap, cell.map(|i| i + count), opposite.map(|i| i + count)]
    });
    let squares: Vec<[usize; 4]> = squares.collect();
    stretched(unit, squares.into_iter(), bowls.size())
}

/// The corners of every cell, counter-clockwise in the plane of v and w.
fn cells(n: usize) -> impl Iterator<Item = [usize; 4]> {
    let number = move |i: usize, j: usize| j * (n + 1) + i;
    (0..n * n).map(move |cell| {
        let (i, j) = (cell % n, cell / n);
        [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)]
    })
}

fn is_rim(place: usize, n: usize) -> bool {
    let (i, j) = (place % (n + 1), place / (n + 1));
    i == 0 || i == n || j == 0 || j == n
}

/// The `[v, w]` of a point of the square `[-1, 1]^2`: as far towards the rim as it is towards the
/// square's boundary.
pub(crate) fn place(bowls: &SuperhyperboloidTwoSheets, [p, q]: [f64; 2]) -> [f64; 2] {
    let share = p.abs().max(q.abs());
    if share == 0.0 {
        return [0.0; 2];
    }
    let [towards_v, towards_w] = [p.abs() / share, q.abs() / share];
    let excess = |r: f64| bowls.height(r * towards_v, r * towards_w) - bowls.top();
    // The surface is at least as high as v and w are far from the apex.
    let rim = increasing_root(excess, [0.0, bowls.top()]);
    [rim * p, rim * q]
}
