//! Meshes of every family, and of deformed shapes, within a tolerance.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::super::families::examples;
use super::tests::{METHODS, least_angle};
use super::*;
use crate::deform::{Bend, Deformation, Line, Taper, Twist};
use crate::shape::{Solid, Superellipsoid, Supertoroid};
use crate::surface::deviation::distance_to_triangle;
use crate::surface::sample_deformed_surface;

/// Every family, undeformed.
fn plain() -> impl Iterator<Item = Deformed<Shape>> {
    examples().map(|(shape, _)| Deformed::new(shape, Chain::default()).unwrap())
}

/// Every family, tapered, twisted and bent.
fn deformed() -> impl Iterator<Item = Deformed<Shape>> {
    let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
    let chain = Chain::new([
        Deformation::new(Taper::new(line(1.0, -0.2))),
        Deformation::new(Twist::new(line(0.0, 0.3))),
        Deformation::new(Bend::new(0.1, 0.0, [-1.0, 1.5]).unwrap()),
    ]);
    // Each family five times, with other exponents.
    examples().step_by(6).map(move |(shape, _)| Deformed::new(shape, chain.clone()).unwrap())
}

/// How near the boundary comes to a point of a triangle, over that triangle: by a search that steps
/// to whichever neighbour of a place is nearer, and halves its steps where none is.
fn distance_within(surface: &Covering, places: &[Vector3<f64>; 3], [u, v]: [f64; 2]) -> f64 {
    let [a, b, c] = places;
    let place = |[u, v]: [f64; 2]| a * (1.0 - u - v) + b * u + c * v;
    let corners = places.map(|place| surface.point(&place));
    let x = corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v;
    let distance = |at| (surface.point(&place(at)) - x).norm();
    let is_within = |&[u, v]: &[f64; 2]| u >= 0.0 && v >= 0.0 && u + v <= 1.0;
    let (mut at, mut step) = ([u, v], 0.25);
    let mut nearest = distance(at);
    while step > 1e-3 {
        let around = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
        let next = around
            .map(|[du, dv]| [at[0] + step * du, at[1] + step * dv])
            .into_iter()
            .filter(is_within)
            .map(|at| (distance(at), at))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        match next {
            Some((nearer, there)) if nearer < nearest => (nearest, at) = (nearer, there),
            _ => step *= 0.5,
        }
    }
    nearest
}

/// Points of triangles from the boundary.
fn assert_mesh_is_near(surface: &Covering, lattice: &Lattice, tolerance: f64) {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for triangle in lattice.triangles.iter().step_by(lattice.triangles.len().div_ceil(1000)) {
        let places = triangle.map(|i| lattice.places[i as usize]);
        let [u, v]: [f64; 2] = [rng.random(), rng.random()];
        let at = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
        let distance = distance_within(surface, &places, at);
        assert!(distance <= tolerance, "{:?} {distance} {tolerance}", surface.shape);
    }
}

/// Points of the boundary, drawn without regard to the mesh, from its triangles.
fn assert_surface_is_near(solid: &Deformed<Shape>, mesh: &Mesh, tolerance: f64) {
    let boxes: Vec<[Vector3<f64>; 2]> = mesh
        .corners()
        .map(|[a, b, c]| [a.inf(&b).inf(&c), a.sup(&b).sup(&c)])
        .map(|[min, max]| [min.add_scalar(-tolerance), max.add_scalar(tolerance)])
        .collect();
    for x in sample_deformed_surface(solid, 200, 2) {
        let is_near = mesh.corners().zip(&boxes).any(|(corners, [min, max])| {
            (0..3).all(|i| min[i] <= x[i] && x[i] <= max[i])
                && distance_to_triangle(&x, &corners) <= tolerance
        });
        assert!(is_near, "{:?} {x} {tolerance}", solid.shape());
    }
}

/// The whole claim, for solids some units large.
fn assert_within(solid: &Deformed<Shape>, tolerance: f64, method: MeshMethod) {
    let surface = Covering { shape: solid.shape(), chain: solid.chain() };
    let lattice = within(&surface, tolerance, method).unwrap();
    assert_mesh_is_near(&surface, &lattice, tolerance);
    let mesh = surface.mesh(lattice);
    assert!(mesh.is_closed(), "{method:?} {:?}", solid.shape());
    assert_surface_is_near(solid, &mesh, tolerance);
}

#[test]
fn boundary_and_mesh_of_every_family_are_nowhere_further_apart_than_the_tolerance() {
    let mut count = 0;
    for (tolerance, step) in [(0.1, 2), (0.01, 7)] {
        for solid in plain().step_by(step) {
            assert_within(&solid, tolerance, MeshMethod::Subdivision);
            count += 1;
        }
    }
    for method in [MeshMethod::Lattice, MeshMethod::Curvature] {
        for solid in plain().step_by(6) {
            assert_within(&solid, 0.03, method);
            count += 1;
        }
    }
    assert_eq!(count, 63 + 18 + 2 * 21);
}

#[test]
fn boundary_and_mesh_of_deformed_shapes_are_nowhere_further_apart_than_the_tolerance() {
    let mut families = std::collections::HashSet::new();
    for solid in deformed() {
        for method in METHODS {
            assert_within(&solid, 0.03, method);
        }
        families.insert(solid.shape().family());
    }
    assert_eq!(families.len(), 5);
}

/// Twelve turns, one from each step of the first triangles' grids to the next.
#[test]
fn a_twist_in_step_with_the_places_that_are_looked_at_is_seen() {
    let ribbon = Superellipsoid::new([0.5, 0.1, 1.0], [0.5, 0.5]).unwrap().into();
    let twist = Twist::new(Line::new(0.0, 12.0 * std::f64::consts::PI).unwrap());
    let solid = Deformed::new(ribbon, Chain::new([Deformation::new(twist)])).unwrap();
    assert_within(&solid, 0.03, MeshMethod::Subdivision);
}

#[test]
fn volumes_of_meshes_are_those_of_the_solids_and_triangles_face_outwards() {
    for (shape, _) in examples() {
        let mesh = tessellate_within(shape, 0.03, MeshMethod::Subdivision).unwrap();
        // The mesh is nowhere further off than that.
        let most = 0.03 * shape.surface_area().max(mesh.area());
        assert!((mesh.volume() - shape.volume()).abs() < most, "{shape:?} {}", mesh.volume());
    }
}

#[test]
fn caps_are_flat_and_short_of_theirs_by_their_rims_alone() {
    for (shape, _) in examples() {
        let (axis, clip) = match shape {
            Shape::SuperhyperboloidOneSheet(tower) => (2, tower.clip()),
            Shape::SuperhyperboloidTwoSheets(bowls) => (0, bowls.clip()),
            _ => continue,
        };
        let mesh = tessellate_within(shape, 0.03, MeshMethod::Subdivision).unwrap();
        // Clips are multiples of no semi-axis, and so rounded.
        let is_on_cap = |x: &Vector3<f64>| (x[axis].abs() / clip - 1.0).abs() < 1e-15;
        let caps: Vec<_> = mesh.corners().filter(|c| c.iter().all(is_on_cap)).collect();
        let area: f64 = caps.iter().map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm()).sum();
        let [min, max] = shape.bounding_box();
        let sides = max - min;
        let perimeter = 2.0 * (sides.sum() - sides[axis]);
        let whole: f64 = cap_area(&shape);
        assert!(
            area <= whole * (1.0 + 1e-12) && area > whole - 2.0 * 0.03 * perimeter,
            "{shape:?}"
        );
        assert!(!caps.is_empty());
    }
}

/// The area of both caps, by fine slices.
fn cap_area(shape: &Shape) -> f64 {
    let [_, corner] = shape.bounding_box();
    const SLICES: usize = 4000;
    let slices = |half: f64, width: &dyn Fn(f64) -> f64| {
        let middle = |i: usize| half * (i as f64 + 0.5) / SLICES as f64;
        (0..SLICES).map(|i| 8.0 * width(middle(i)) * half / SLICES as f64).sum::<f64>()
    };
    // Where a cap of the plane ends, along y.
    let end = |x: &dyn Fn(f64) -> Vector3<f64>, half: f64| {
        let (mut low, mut high) = (0.0, half);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if shape.inside_outside(&x(middle)) < 1.0 { low = middle } else { high = middle }
        }
        low
    };
    match shape {
        Shape::SuperhyperboloidOneSheet(_) => {
            slices(corner.x, &|x| end(&|y| Vector3::new(x, y, corner.z), corner.y))
        }
        _ => slices(corner.z, &|z| end(&|y| Vector3::new(corner.x, y, z), corner.y)),
    }
}

#[test]
fn no_triangle_of_a_family_of_semi_axes_one_is_a_sliver() {
    let mut least = [f64::INFINITY; 3];
    for (shape, _) in examples() {
        let unit = with_unit_size(&shape);
        for method in METHODS {
            let mesh = tessellate_within(unit, 0.03, method).unwrap();
            let of_mesh = mesh.corners().map(least_angle).fold(f64::INFINITY, f64::min);
            least[method as usize] = least[method as usize].min(of_mesh);
        }
    }
    // Lines crowd along the profile of a tower, whose levels are wide; cuts of longest sides leave
    // half of the first angles at least.
    assert!(least[0] > 4.0 && least[1] > 3.0 && least[2] > 7.0, "{least:?}");
}

/// The shape of the same exponents, ring and ratio of the clip.
fn with_unit_size(shape: &Shape) -> Shape {
    use crate::shape::{SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, ThreeExponent};
    let one = [1.0; 3];
    match shape {
        Shape::Superellipsoid(s) => Superellipsoid::new(one, s.exponents()).unwrap().into(),
        Shape::SuperhyperboloidOneSheet(s) => {
            SuperhyperboloidOneSheet::new(one, s.exponents(), s.top()).unwrap().into()
        }
        Shape::SuperhyperboloidTwoSheets(s) => {
            SuperhyperboloidTwoSheets::new(one, s.exponents(), s.top()).unwrap().into()
        }
        Shape::Supertoroid(s) => Supertoroid::new(one, s.exponents(), s.ring()).unwrap().into(),
        Shape::ThreeExponent(s) => ThreeExponent::new(one, s.exponents()).unwrap().into(),
    }
}

#[test]
fn a_torus_without_a_hole_is_meshed() {
    for e in [0.1, 1.0, 2.0] {
        let horn = Supertoroid::new([1.0; 3], [e, e], 1.0).unwrap();
        for method in METHODS {
            let mesh = tessellate_within(horn, 0.02, method).unwrap();
            assert!(mesh.is_closed());
            assert!(mesh.vertices().iter().flatten().all(|c| c.is_finite()));
            assert!((mesh.volume() / horn.volume() - 1.0).abs() < 0.05);
        }
    }
}

#[test]
fn the_tolerance_scales_with_the_shape() {
    for factor in [1e-6, 1.0, 1e3] {
        let size = [2.0, 0.7, 1.3].map(|a| a * factor);
        let torus = Supertoroid::new(size, [0.5, 1.5], 1.6).unwrap();
        let mesh = tessellate_within(torus, 0.01 * factor, MeshMethod::Subdivision).unwrap();
        let expected = Supertoroid::new([2.0, 0.7, 1.3], [0.5, 1.5], 1.6).unwrap();
        let unit = tessellate_within(expected, 0.01, MeshMethod::Subdivision).unwrap();
        let ratio = mesh.triangles().len() as f64 / unit.triangles().len() as f64;
        assert!((ratio - 1.0).abs() < 0.01, "{factor} {ratio}");
    }
}

#[test]
fn hopeless_tolerances_are_refused_for_every_family() {
    for (shape, _) in examples().step_by(6) {
        for method in METHODS {
            let refused = tessellate_within(shape, 1e-11, method);
            let is_flat = refused.is_ok();
            assert!(is_flat || matches!(refused, Err(ToleranceError::TooFine { .. })));
        }
    }
}
