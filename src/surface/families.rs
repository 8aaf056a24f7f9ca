//! Closed meshes of shapes of any family.

pub(super) mod bowls;

use nalgebra::Vector3;

use super::grading::{Grading, lattice_lines, profile_lines};
use super::lattice::CubeLattice;
use super::mesh::Mesh;
use super::tessellate::{Resolution, flattened_cube_point, split, tessellate};
use crate::shape::{
    Shape, Solid, SuperhyperboloidOneSheet, Supertoroid, ThreeExponent, superellipse_norm,
};

/// A closed mesh of a shape's boundary, the caps of a clip included, in the model's frame: its
/// vertices on the boundary, its triangles counter-clockwise as seen from outside.
///
/// A superellipsoid's is that of [`tessellate`]. A tower has `12 n^2` triangles at a resolution n,
/// two bowls `8 n^2`, a torus `32 n^2`.
pub fn tessellate_shape(shape: &Shape, resolution: Resolution) -> Mesh {
    let n = resolution.segments();
    match shape {
        Shape::Superellipsoid(shape) => tessellate(shape, resolution),
        Shape::SuperhyperboloidOneSheet(tower) => of_tower(tower, n),
        Shape::SuperhyperboloidTwoSheets(bowls) => bowls::mesh(bowls, n),
        Shape::Supertoroid(torus) => of_torus(torus, n),
        Shape::ThreeExponent(solid) => of_three_exponents(solid, n),
    }
}

/// The lattice of a cube whose lids are the caps: levels of z are superellipses.
fn of_tower(tower: &SuperhyperboloidOneSheet, n: usize) -> Mesh {
    let [_, e2] = tower.exponents();
    let across = lattice_lines(n, &[e2], Grading::Even);
    let heights = profile_lines(n, tower.top(), |w| tower.radius(w));
    let place = |[i, j, k]: [usize; 3]| {
        let level = flattened_cube_point([across[i], across[j], 0.0], e2);
        let w = heights[k];
        level * tower.radius(w.abs()) + Vector3::new(0.0, 0.0, w)
    };
    of_lattice(n, place, tower.size())
}

/// The lattice of a cube, projected from the centre.
fn of_three_exponents(solid: &ThreeExponent, n: usize) -> Mesh {
    let lines = lattice_lines(n, &solid.exponents().map(|n| 2.0 / n), Grading::Even);
    let size = Vector3::from(solid.size());
    let place = |cell: [usize; 3]| {
        let x = Vector3::from(cell.map(|i| lines[i])).component_mul(&size);
        let surface = x * (1.0 - solid.radial_distance(&x) / x.norm());
        surface.component_div(&size)
    };
    of_lattice(n, place, solid.size())
}

/// The mesh of a cube's lattice whose points are placed on a shape of semi-axes one.
fn of_lattice(n: usize, place: impl Fn([usize; 3]) -> Vector3<f64>, size: [f64; 3]) -> Mesh {
    let lattice = CubeLattice::new(n);
    let unit: Vec<Vector3<f64>> = lattice.points().map(place).collect();
    let squares = lattice.squares().map(|square| square.map(|corner| lattice.number(corner)));
    stretched(unit, squares, size)
}

/// Squares around the tube and around the ring, `4 n` each.
fn of_torus(torus: &Supertoroid, n: usize) -> Mesh {
    let [tube, ring] = torus.exponents().map(|e| loop_points(n, e));
    let unit: Vec<Vector3<f64>> = ring
        .iter()
        .flat_map(|[x, y]| {
            tube.iter().map(move |[across, up]| {
                let radius = torus.ring() + across;
                Vector3::new(radius * x, radius * y, *up)
            })
        })
        .collect();
    let around = 4 * n;
    let number = move |i: usize, j: usize| (i % around) * around + j % around;
    let squares = (0..around).flat_map(move |i| {
        (0..around)
            .map(move |j| [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)])
    });
    stretched(unit, squares, torus.size())
}

/// `4 n` points counter-clockwise around the unit superellipse.
fn loop_points(n: usize, e: f64) -> Vec<[f64; 2]> {
    let lines = lattice_lines(n, &[e], Grading::Even);
    let on_side = |side: usize, t: f64| match side {
        0 => [1.0, t],
        1 => [-t, 1.0],
        2 => [-1.0, -t],
        _ => [t, -1.0],
    };
    let project = |[x, y]: [f64; 2]| {
        let norm = superellipse_norm(x.abs(), y.abs(), e);
        [x / norm, y / norm]
    };
    (0..4).flat_map(|side| lines[..n].iter().map(move |&t| on_side(side, t))).map(project).collect()
}

/// The mesh of quadrilaterals on a shape of semi-axes one, cut there and stretched.
fn stretched(
    unit: Vec<Vector3<f64>>,
    squares: impl Iterator<Item = [usize; 4]>,
    size: [f64; 3],
) -> Mesh {
    let triangles = squares.flat_map(|square| split(square, &unit)).collect();
    let size = Vector3::from(size);
    Mesh::new(unit.iter().map(|x| x.component_mul(&size)).collect(), triangles)
}

#[cfg(test)]
mod tests;
