//! How far a surface departs from the triangles of a mesh.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::chart::Lattice;
use super::covering::Covering;

/// Steps along each side of the grid of places at which a triangle is looked at.
const STEPS: u32 = 6;

/// Places between those of the grid, at shares that no period of a twist has.
const BESIDE: [[f64; 2]; 4] = [[0.137, 0.291], [0.531, 0.077], [0.283, 0.619], [0.071, 0.093]];

/// The greatest distance of a surface from the mesh of a lattice on it, as far as the places of a
/// grid on each triangle show it.
pub(super) fn lattice_deviation(surface: &Covering, lattice: &Lattice) -> f64 {
    let of_triangle = |triangle: &[u32; 3]| {
        let at = triangle.map(|i| i as usize);
        let corners = at.map(|i| surface.stretched(&lattice.unit_points[i]));
        deviation(surface, &at.map(|i| lattice.places[i]), &corners)
    };
    lattice.triangles.par_iter().map(of_triangle).reduce(|| 0.0, f64::max)
}

/// The greatest distance from a triangle of the surface's points over a grid, and beside it, on the
/// triangle of the polyhedron that it belongs to. They may be nearer to the triangle's neighbours.
///
/// As the polyhedron covers the surface, and the triangles correspond to each other side by side,
/// no point of the mesh is further from the surface either.
pub(super) fn deviation(
    surface: &Covering,
    [a, b, c]: &[Vector3<f64>; 3],
    corners: &[Vector3<f64>; 3],
) -> f64 {
    let grid = (0..=STEPS).flat_map(|i| (0..=STEPS - i).map(move |j| [i, j]));
    let shares = grid.map(|steps| steps.map(|step| f64::from(step) / f64::from(STEPS)));
    let points =
        shares.chain(BESIDE).map(|[u, v]| surface.point(&(a * (1.0 - u - v) + b * u + c * v)));
    points.map(|x| distance_to_triangle(&x, corners)).fold(0.0, f64::max)
}

/// Euclidean distance of a point from a triangle.
pub(super) fn distance_to_triangle(x: &Vector3<f64>, corners: &[Vector3<f64>; 3]) -> f64 {
    let [a, b, c] = corners;
    let normal = (b - a).cross(&(c - a));
    let sides = [[a, b], [b, c], [c, a]];
    let is_beside =
        |[from, to]: [&Vector3<f64>; 2]| (to - from).cross(&(x - from)).dot(&normal) < 0.0;
    if normal != Vector3::zeros() && !sides.into_iter().any(is_beside) {
        return normal.dot(&(x - a)).abs() / normal.norm();
    }
    sides
        .map(|[from, to]| distance_to_segment(x, from, to))
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

fn distance_to_segment(x: &Vector3<f64>, from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let (side, offset) = (to - from, x - from);
    let length_squared = side.norm_squared();
    let share = if length_squared > 0.0 { offset.dot(&side) / length_squared } else { 0.0 };
    (offset - side * share.clamp(0.0, 1.0)).norm()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deform::Chain;
    use crate::shape::Superellipsoid;
    use crate::surface::grading::Grading;

    #[test]
    fn distances_from_a_triangle_are_those_from_its_plane_sides_and_corners() {
        let triangle = [Vector3::zeros(), Vector3::new(4.0, 0.0, 0.0), Vector3::new(0.0, 4.0, 0.0)];
        for (x, expected) in [
            ([1.0, 1.0, -2.0], 2.0),
            ([2.0, -3.0, 4.0], 5.0),
            ([-2.0, -1.0, 2.0], 3.0),
            ([3.0, 3.0, 0.0], 2.0_f64.sqrt()),
            ([4.0, 0.0, 0.0], 0.0),
        ] {
            assert!((distance_to_triangle(&x.into(), &triangle) - expected).abs() < 1e-15);
        }
        let point = [Vector3::x(); 3];
        assert_eq!(distance_to_triangle(&Vector3::new(4.0, 4.0, 0.0), &point), 5.0);
    }

    #[test]
    fn a_sphere_rises_above_a_facet_by_its_sagitta() {
        let sphere = Superellipsoid::new([2.0; 3], [1.0, 1.0]).unwrap().into();
        let surface = Covering { shape: &sphere, chain: &Chain::default() };
        let lattice = surface.lattice(32, Grading::Even);
        let circumradius = |[a, b, c]: [Vector3<f64>; 3]| {
            let [p, q, r] = [b - a, c - b, a - c].map(|side| side.norm());
            p * q * r / (2.0 * (b - a).cross(&(c - a)).norm())
        };
        let sagitta = |corners| 2.0 - (4.0 - circumradius(corners).powi(2)).sqrt();
        let found = lattice_deviation(&surface, &lattice);
        let expected = surface.mesh(lattice).corners().map(sagitta).fold(0.0, f64::max);
        // The grid misses the circumcentre; facets are right-angled or nearly, some obtuse.
        assert!(found <= expected * (1.0 + 1e-9) && found > 0.85 * expected, "{found} {expected}");
    }
}
