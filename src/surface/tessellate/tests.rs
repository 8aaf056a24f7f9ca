use nalgebra::Vector3;

use super::*;

const EXPONENTS: [f64; 7] = [0.05, 0.1, 0.5, 1.0, 1.5, 1.9, 2.0];

const SIZES: [[f64; 3]; 5] =
    [[1.0, 1.0, 1.0], [2.0, 1.0, 0.5], [1.0, 1.0, 100.0], [100.0, 100.0, 1.0], [1e-6, 1e-5, 1e-4]];

fn shapes() -> impl Iterator<Item = Superellipsoid> {
    EXPONENTS.into_iter().flat_map(|e1| {
        EXPONENTS
            .into_iter()
            .flat_map(move |e2| SIZES.map(|size| Superellipsoid::new(size, [e1, e2]).unwrap()))
    })
}

fn mesh(shape: &Superellipsoid, n: usize) -> Mesh {
    tessellate(shape, Resolution::new(n).unwrap())
}

/// Share by which the mesh falls short of the solid's volume.
fn volume_deficit(shape: &Superellipsoid, n: usize) -> f64 {
    1.0 - mesh(shape, n).volume() / shape.volume()
}

#[test]
fn a_mesh_is_a_closed_sphere_of_the_stated_counts() {
    for shape in shapes() {
        for n in [2, 12] {
            let mesh = mesh(&shape, n);
            let (vertices, triangles) = (mesh.vertices().len(), mesh.triangles().len());
            assert!(mesh.is_closed(), "{shape:?}");
            assert_eq!((vertices, triangles), (6 * n * n + 2, 12 * n * n));
            // Euler characteristic V - E + F, closed: E = 3F/2.
            assert_eq!(vertices + triangles - 3 * triangles / 2, 2);
        }
    }
}

#[test]
fn vertices_are_on_the_surface() {
    for shape in shapes() {
        for x in mesh(&shape, 12).vertices() {
            // A few powers and products, each of relative rounding 1e-16.
            assert!((shape.gauge(x) - 1.0).abs() < 1e-14, "{shape:?} {x}");
        }
    }
}

#[test]
fn triangles_face_outwards() {
    for shape in shapes() {
        for [a, b, c] in mesh(&shape, 12).corners() {
            let area = (b - a).cross(&(c - a));
            // The solid is convex, so its centre lies behind every facet.
            assert!(area.dot(&a) > 0.0, "{shape:?} {a} {b} {c}");
        }
    }
}

#[test]
fn volume_is_that_of_the_solid_from_inside() {
    for shape in shapes() {
        // Facets of a sphere, 2.8 degrees wide, fall short by 0.1 %, and no shape is rounder. All
        // are convex, so the mesh never holds more than the solid; 1e-13 is its rounding.
        let deficit = volume_deficit(&shape, 32);
        assert!((-1e-13..1.1e-3).contains(&deficit), "{shape:?}: {deficit}");
    }
}

#[test]
fn no_triangle_of_a_unit_shape_is_a_sliver() {
    for shape in shapes().filter(|shape| shape.size() == [1.0; 3]) {
        let least = mesh(&shape, 32).corners().map(least_angle).fold(f64::INFINITY, f64::min);
        // Lines crowd at most fourfold, atan(1/4) = 14 degrees, and a quadrilateral in the
        // corner of a lid is skewed besides.
        assert!(least.to_degrees() > 7.0, "{shape:?}: {least}");
    }
}

#[test]
fn volume_converges_with_the_square_of_the_resolution() {
    for shape in shapes().filter(|shape| shape.size() == [1.0; 3]) {
        let (coarse, fine) = (volume_deficit(&shape, 32), volume_deficit(&shape, 64));
        // A factor of 4 in the limit, of which edges of radius 0.05 leave a bit; 1e-13 is the
        // rounding of 50 000 terms.
        assert!(fine < coarse / 3.3 + 1e-13, "{shape:?}: {coarse} {fine}");
    }
}

/// Least angle of a triangle, in radians.
fn least_angle(corners: [Vector3<f64>; 3]) -> f64 {
    let angle = |i: usize| {
        let [a, b, c] = [0, 1, 2].map(|j| corners[(i + j) % 3]);
        let (u, v) = (b - a, c - a);
        u.cross(&v).norm().atan2(u.dot(&v))
    };
    (0..3).map(angle).fold(f64::INFINITY, f64::min)
}

#[test]
fn odd_and_extreme_resolutions_are_refused() {
    for found in [0, 1, 3, 33, 4098, usize::MAX] {
        assert_eq!(Resolution::new(found), Err(ResolutionError { found }));
    }
    assert_eq!(Resolution::default().segments(), 32);
}
