use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::shape::Superellipsoid;
use crate::surface::deviation::distance_to_triangle;

pub(super) const METHODS: [MeshMethod; 3] =
    [MeshMethod::Lattice, MeshMethod::Curvature, MeshMethod::Subdivision];

const EXPONENTS: [f64; 5] = [0.1, 0.5, 1.0, 1.5, 2.0];

const SIZES: [[f64; 3]; 4] =
    [[1.0, 1.0, 1.0], [2.0, 1.0, 0.5], [1e-6, 2e-6, 2e-5], [100.0, 100.0, 5.0]];

/// Every method's mesh of every shape, within a share of the mean semi-axis.
fn for_every_mesh(share: f64, check: impl FnMut(MeshMethod, &Superellipsoid, f64, &Mesh)) {
    for_meshes_of(&SIZES, share, check);
}

/// Those of some sizes.
fn for_meshes_of(
    sizes: &[[f64; 3]],
    share: f64,
    mut check: impl FnMut(MeshMethod, &Superellipsoid, f64, &Mesh),
) {
    let pairs = EXPONENTS.into_iter().flat_map(|e1| EXPONENTS.map(|e2| [e1, e2]));
    for exponents in pairs {
        for &size in sizes {
            let shape = Superellipsoid::new(size, exponents).unwrap();
            let tolerance = share * shape.mean_semi_axis();
            for method in METHODS {
                let mesh = tessellate_within(shape, tolerance, method).unwrap();
                check(method, &shape, tolerance, &mesh);
            }
        }
    }
}

#[test]
fn meshes_are_closed_spheres_on_the_surface_that_face_outwards() {
    for_every_mesh(0.01, |method, shape, _, mesh| {
        assert!(mesh.is_closed(), "{method:?} {shape:?}");
        let (vertices, triangles) = (mesh.vertices().len(), mesh.triangles().len());
        assert_eq!(vertices + triangles - 3 * triangles / 2, 2);
        for x in mesh.vertices() {
            assert!((shape.gauge(x) - 1.0).abs() < 1e-13, "{method:?} {shape:?} {x}");
        }
        for [a, b, c] in mesh.corners() {
            // The solid is convex, so its centre lies behind every facet.
            assert!((b - a).cross(&(c - a)).dot(&a) > 0.0, "{method:?} {shape:?}");
        }
    });
}

/// Points of the triangles other than those at which the deviation was measured.
fn random_point(rng: &mut ChaCha8Rng, [a, b, c]: &[Vector3<f64>; 3]) -> Vector3<f64> {
    let [u, v]: [f64; 2] = [rng.random(), rng.random()];
    let [u, v] = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
    a * (1.0 - u - v) + b * u + c * v
}

/// Hausdorff distance, from above: surface points from the triangle below them, and points of
/// triangles from the surface along its normal or the steepest way out.
#[test]
fn surface_and_mesh_are_nowhere_further_apart_than_the_tolerance() {
    for (share, sizes) in [(0.03, &SIZES[..]), (0.003, &SIZES[1..3])] {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for_meshes_of(sizes, share, |method, shape, tolerance, mesh| {
            let count = mesh.triangles().len();
            let each = 20_000_usize.div_ceil(count);
            for corners in mesh.corners().step_by(count.div_ceil(20_000)) {
                for _ in 0..each {
                    let x = random_point(&mut rng, &corners);
                    let above = distance_to_triangle(&shape.radial_projection(&x), &corners);
                    assert!(above <= tolerance, "{method:?} {shape:?} {above} {tolerance}");
                    let [a, b, c] = corners;
                    let ways = [(b - a).cross(&(c - a)), shape.gauge_gradient(&x)];
                    let is_outside = |way: &Vector3<f64>| {
                        // Up to rounding of the gauge.
                        shape.gauge(&(x + way.normalize() * tolerance)) >= 1.0 - 1e-13
                    };
                    assert!(ways.iter().any(is_outside), "{method:?} {shape:?} {x}");
                }
            }
        });
    }
}

/// Least angle of a triangle, in degrees.
pub(super) fn least_angle(corners: [Vector3<f64>; 3]) -> f64 {
    let angle = |i: usize| {
        let [a, b, c] = [0, 1, 2].map(|j| corners[(i + j) % 3]);
        (b - a).angle(&(c - a))
    };
    (0..3).map(angle).fold(f64::INFINITY, f64::min).to_degrees()
}

#[test]
fn no_triangle_of_a_unit_shape_is_a_sliver() {
    for share in [0.03, 0.003] {
        let mut least = [f64::INFINITY; 3];
        for_meshes_of(&[[1.0; 3]], share, |method, _, _, mesh| {
            let of_mesh = mesh.corners().map(least_angle).fold(f64::INFINITY, f64::min);
            least[method as usize] = least[method as usize].min(of_mesh);
        });
        // Lines crowd fourfold and sixfold, and quadrilaterals in the corner of a lid are skewed
        // besides; cuts of longest sides leave half of the first angles at least, and moving their
        // middles to the surface takes some of that.
        assert!(least[0] > 7.0 && least[1] > 5.0 && least[2] > 10.0, "{least:?}");
    }
}

#[test]
fn a_finer_tolerance_is_met_by_more_triangles_in_proportion() {
    let shape = Superellipsoid::new([1.0, 2.0, 0.7], [0.3, 0.8]).unwrap();
    for method in METHODS {
        let [coarse, fine] = [1e-2, 1e-4].map(|tolerance| {
            tessellate_within(shape, tolerance, method).unwrap().triangles().len() as f64
        });
        // Triangles' sides fall with the root of the tolerance, their number rises with its
        // inverse.
        let ratio = fine / coarse / 100.0;
        assert!((0.3..3.0).contains(&ratio), "{method:?} {ratio}");
    }
}

#[test]
fn flat_faces_take_few_triangles() {
    let octahedron = Superellipsoid::new([1.0; 3], [2.0, 2.0]).unwrap();
    for method in METHODS {
        let mesh = tessellate_within(octahedron, 1e-9, method).unwrap();
        assert!(mesh.triangles().len() <= 48, "{method:?} {}", mesh.triangles().len());
    }
}

#[test]
fn the_edges_of_a_pyramid_are_followed() {
    let pyramid = Superellipsoid::new([1.0; 3], [2.0, 0.1]).unwrap();
    for method in METHODS {
        let mesh = tessellate_within(pyramid, 0.01, method).unwrap();
        assert!(mesh.triangles().len() < 10_000, "{method:?} {}", mesh.triangles().len());
    }
}

#[test]
fn tolerances_that_cannot_be_met_are_refused() {
    let sphere = Superellipsoid::new([1.0; 3], [1.0, 1.0]).unwrap();
    for method in METHODS {
        for tolerance in [0.0, -1.0, f64::INFINITY] {
            let refused = tessellate_within(sphere, tolerance, method);
            assert_eq!(refused, Err(ToleranceError::NotPositive(tolerance)));
        }
        assert!(tessellate_within(sphere, f64::NAN, method).is_err());
    }
    for method in METHODS {
        let refused = tessellate_within(sphere, 1e-12, method);
        let Err(ToleranceError::TooFine { tolerance: 1e-12, wanted }) = refused else {
            panic!("{refused:?}");
        };
        // Facets of sides s, 0.43 s^2 each, are off by s^2/8 or so.
        assert!((1e11..1e15).contains(&wanted), "{method:?} {wanted:e}");
    }
}
