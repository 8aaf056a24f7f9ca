use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::shape::{LevelSet, Solid};
use crate::surface::families::examples;

/// A place anywhere on a triangle.
fn random_place(rng: &mut ChaCha8Rng, [a, b, c]: [Vector3<f64>; 3]) -> Vector3<f64> {
    let [u, v]: [f64; 2] = [rng.random(), rng.random()];
    let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
    a * (1.0 - u - v) + b * u + c * v
}

#[test]
fn places_of_the_coarsest_polyhedron_go_to_the_boundary() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for (shape, _) in examples() {
        let lattice = shape.lattice(2, Grading::Even);
        let size = Vector3::from(Chart::size(&shape));
        for triangle in &lattice.triangles {
            for _ in 0..20 {
                let corners = triangle.map(|i| lattice.places[i as usize]);
                let unit_point = shape.unit_point(&random_place(&mut rng, corners));
                // A few powers and products; that of three exponents is F itself, up to 20 times
                // as steep.
                let level = shape.level(unit_point.component_mul(&size).into());
                assert!((level - 1.0).abs() < 1e-12, "{shape:?} {unit_point} {level}");
            }
        }
    }
}

/// Were a part of the boundary without a place, or with two, then its area and volume would be
/// missing or count twice.
#[test]
fn polyhedra_cover_the_boundary_once() {
    for (shape, _) in examples() {
        let mut lattice = shape.lattice(2, Grading::Even);
        for _ in 0..5 {
            lattice = quartered(&shape, &lattice);
        }
        let mesh = lattice.mesh(Chart::size(&shape));
        let [volume, area] = [mesh.volume() / shape.volume(), mesh.area() / shape.surface_area()];
        // Chords of a 64th of the sides, which cut small edges off.
        assert!((volume - 1.0).abs() < 1e-2, "{shape:?} {volume}");
        assert!((area - 1.0).abs() < 2e-2, "{shape:?} {area}");
    }
}

/// Triangles cut into four each, without shared vertices.
fn quartered(shape: &Shape, lattice: &Lattice) -> Lattice {
    let corners = lattice.triangles.iter().map(|t| t.map(|i| lattice.places[i as usize]));
    let quarters = corners.flat_map(|[a, b, c]| {
        let [d, e, f] = [0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)];
        [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
    });
    let places: Vec<_> = quarters.flatten().collect();
    let unit_points = places.iter().map(|place| shape.unit_point(place)).collect();
    let triangles = (0..places.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Lattice { places, unit_points, triangles }
}
