//! The nearest point against closed forms, against offsets along normals, and against dense
//! sampling.

use super::*;
use crate::surface::{Resolution, tessellate};

const EXPONENTS: [f64; 7] = [0.05, 0.1, 0.5, 1.0, 1.5, 1.9, 2.0];
const SIZES: [[f64; 3]; 4] =
    [[1.0, 1.0, 1.0], [2.0, 1.0, 0.5], [1e-6, 2e-6, 1e-4], [100.0, 1.0, 30.0]];

fn shapes() -> impl Iterator<Item = Superellipsoid> {
    SIZES.into_iter().flat_map(|size| {
        EXPONENTS.into_iter().flat_map(move |e1| {
            EXPONENTS.map(|e2| Superellipsoid::new(size, [e1, e2]).expect("a valid shape"))
        })
    })
}

/// Points in all octants, on axes and planes, at the centre, near, far and very far.
fn targets(shape: &Superellipsoid) -> impl Iterator<Item = Vector3<f64>> + use<> {
    let size = Vector3::from(shape.size());
    [
        [0.0, 0.0, 0.0],
        [0.5, 0.0, 0.0],
        [0.0, -0.3, 0.0],
        [0.0, 0.0, 2.0],
        [0.2, 0.7, 0.0],
        [-1.5, 0.0, 1.2],
        [0.3, -0.2, 0.5],
        [0.9, 0.9, 0.9],
        [-1.1, 1.3, -0.4],
        [1e6, -2e6, 3e5],
    ]
    .into_iter()
    .map(move |share| Vector3::from(share).component_mul(&size))
}

#[test]
fn feet_are_on_the_surface_and_none_of_many_points_is_nearer() {
    let mut count = 0;
    for shape in shapes() {
        let mesh = tessellate(&shape, Resolution::new(48).unwrap());
        let least_size = shape.size().into_iter().fold(f64::INFINITY, f64::min);
        for x in targets(&shape) {
            let foot = shape.nearest_point(&x);
            assert!((shape.gauge(&foot) - 1.0).abs() < 1e-13, "{shape:?} {x}");
            let distance = (x - foot).norm();
            let sampled = mesh.vertices().iter().map(|v| (x - v).norm());
            let nearest = sampled.fold(f64::INFINITY, f64::min);
            assert!(distance <= nearest * (1.0 + 1e-12), "{shape:?} {x} {distance} {nearest}");
            // Half a step off the foot, at most.
            let step = shape.mean_semi_axis() / 12.0;
            assert!(
                nearest < distance + step.min(step * step / distance.max(least_size)) + step,
                "{shape:?} {x} {distance} {nearest}"
            );
            count += 1;
        }
    }
    assert!(count > 1000);
}

#[test]
fn feet_of_offsets_along_the_normal_are_where_they_started() {
    let mut count = 0;
    for shape in shapes().filter(|shape| shape.exponents().iter().all(|&e| e <= 1.5)) {
        let least = shape.size().into_iter().fold(f64::INFINITY, f64::min);
        for (eta, omega) in [(0.4, 0.3), (-1.2, 2.0), (0.0, 0.7), (1.0, -1.1), (0.8, 0.0)] {
            let (start, normal) = (shape.position(eta, omega), shape.normal(eta, omega));
            for offset in [1e-3, 1.0, 30.0] {
                let x = start + offset * least * normal;
                let distance = shape.euclidean_distance(&x);
                let scale = start.norm().max(offset * least);
                assert!((distance - offset * least).abs() < 1e-12 * scale, "{shape:?} {x}");
                count += 1;
            }
        }
    }
    assert!(count > 1000);
}

#[test]
fn a_sphere_has_its_closed_form() {
    let sphere = Superellipsoid::new([2.0; 3], [1.0, 1.0]).unwrap();
    for x in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.3, -0.4, 1.2], [30.0, -7.0, 0.01]] {
        let x = Vector3::from(x);
        assert!((sphere.euclidean_distance(&x) - (x.norm() - 2.0)).abs() < 1e-13);
    }
}

#[test]
fn an_octahedron_has_its_closed_form() {
    let octahedron = Superellipsoid::new([1.0; 3], [2.0, 2.0]).unwrap();
    let root3 = 3.0_f64.sqrt();
    for (x, expected) in [
        ([0.0, 0.0, 0.0], -1.0 / root3),
        ([0.1, -0.2, 0.3], -0.4 / root3),
        ([1.0, 1.0, -1.0], 2.0 / root3),
        ([3.0, 0.0, 0.0], 2.0),
        ([1.0, 1.0, 0.0], 0.5_f64.sqrt()),
    ] {
        let found = octahedron.euclidean_distance(&x.into());
        assert!((found - expected).abs() < 1e-13, "{x:?} {found} {expected}");
    }
}

#[test]
fn a_rounded_box_is_nearest_at_a_face_inside_and_at_a_corner_outside() {
    let cuboid = Superellipsoid::new([3.0, 2.0, 1.0], [0.05, 0.05]).unwrap();
    for (x, expected) in
        [([0.0, 0.0, 0.5], -0.5), ([0.2, -1.7, 0.1], -0.3), ([2.5, 0.0, 0.0], -0.5)]
    {
        // A face bulges by less than 1e-8 there.
        assert!((cuboid.euclidean_distance(&x.into()) - expected).abs() < 1e-8, "{x:?}");
    }
    let foot = cuboid.nearest_point(&Vector3::new(30.0, -20.0, 10.0));
    assert!((foot - Vector3::new(3.0, -2.0, 1.0)).norm() < 0.2 && foot.x > 0.0 && foot.y < 0.0);
}

/// No point of the surface is nearer to one than its distance, so that distances differ by no
/// more than their points do.
#[test]
fn distances_do_not_differ_by_more_than_points() {
    for shape in shapes() {
        let scale = shape.mean_semi_axis();
        for x in targets(&shape).filter(|x| x.norm() < 1e3 * scale) {
            for step in [Vector3::new(1e-3, 2e-3, -1e-3), Vector3::new(-0.05, 0.02, 0.1)] {
                let near = x + step * scale;
                let difference = shape.euclidean_distance(&near) - shape.euclidean_distance(&x);
                let bound = (step * scale).norm() + 1e-12 * (scale + x.norm());
                assert!(difference.abs() <= bound, "{shape:?} {x} {difference} {bound}");
            }
        }
    }
}
