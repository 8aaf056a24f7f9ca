use super::*;
use crate::pose::Pose;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// Products of rotation matrices, each entry of rounding 1e-16.
const TOLERANCE: f64 = 1e-13;

const AT: [f64; 3] = [4.0, -2.0, 7.0];

fn model(size: [f64; 3], exponents: [f64; 2], angles: [f64; 3]) -> Model {
    Model {
        shape: Superellipsoid::new(size, exponents).unwrap(),
        pose: Pose::from_euler_zyz(angles, Vector3::from(AT)),
    }
}

/// The same, turned further about an axis of the world.
fn turned(model: &Model, axis: Vector3<f64>, angle: f64) -> Model {
    let rotation = Rotation3::new(axis.normalize() * angle) * model.pose.rotation();
    Model { pose: Pose::new(rotation, *model.pose.translation()), ..*model }
}

#[track_caller]
fn assert_errors(a: &Model, b: &Model, size: f64, rotation: f64) {
    let found = (size_error(a, b), rotation_error(a, b));
    assert!((found.0 - size).abs() < TOLERANCE, "size {found:?}");
    assert!((found.1 - rotation).abs() < TOLERANCE, "rotation {found:?}");
}

#[test]
fn rotations_of_the_cube_are_24_and_distinct() {
    let all: Vec<_> = cube_rotations().collect();
    assert_eq!(all.len(), 24);
    for (i, p) in all.iter().enumerate() {
        assert_eq!(p.matrix().determinant(), 1.0);
        assert!(all[..i].iter().all(|q| p != q));
    }
}

#[test]
fn equivalent_descriptions_do_not_differ() {
    for unit in [1e-6, 1.0, 1e6] {
        let size = [2.0, 1.0, 0.5].map(|a| a * unit);
        let swapped = [size[1], size[0], size[2]];
        let a = model(size, [0.2, 1.4], [0.3, 1.1, -0.8]);
        for b in [
            a,
            model(swapped, [0.2, 1.4], [0.3, 1.1, -0.8 + FRAC_PI_2]),
            model(size, [0.2, 1.4], [0.3, 1.1, -0.8 + PI]),
            model(size, [0.2, 1.4], [0.3 + PI, PI - 1.1, 0.8]),
        ] {
            assert_errors(&a, &b, 0.0, 0.0);
        }
    }
}

#[test]
fn any_axis_of_an_ellipsoid_and_of_a_box_can_be_the_third() {
    for e in [0.1, 1.0] {
        let a = model([2.0, 1.0, 0.5], [e, e], [0.3, 1.1, -0.8]);
        for b_from_a in cube_rotations() {
            let size = (b_from_a * Vector3::new(2.0, 1.0, 0.5)).abs();
            let pose = Pose::new(a.pose.rotation() * b_from_a.inverse(), Vector3::from(AT));
            let b = Model { shape: a.shape.with_size(size.into()), pose };
            // Equal only for e1 = e2 = 1; a box of one order or another is the same but for
            // its corners.
            assert_errors(&a, &b, 0.0, 0.0);
        }
    }
}

#[test]
fn a_square_prism_is_also_a_lozenge_turned_by_45_degrees() {
    let a = model([1.0, 1.0, 3.0], [0.1, 0.01], [0.3, 1.1, -0.8]);
    let b = model([SQRT_2, SQRT_2, 3.0], [0.1, 1.99], [0.3, 1.1, -0.8 + FRAC_PI_4]);
    // Exponents are 0.01 from the limit, in which the solids are the same.
    assert!(size_error(&a, &b) < 0.01);
    assert!(rotation_error(&a, &b) < TOLERANCE);
}

#[test]
fn errors_are_those_put_in() {
    let a = model([2.0, 1.0, 0.5], [0.2, 1.4], [0.3, 1.1, -0.8]);
    let axis = Vector3::new(1.0, -2.0, 0.5);
    for angle in [1e-9, 1e-3, 0.3, 0.7] {
        assert_errors(&a, &turned(&a, axis, angle), 0.0, angle);
    }
    let larger = Model { shape: a.shape.with_size([2.06, 0.98, 0.5]), ..a };
    assert_errors(&a, &larger, 0.03, 0.0);
}

#[test]
fn a_cylinder_has_an_axis_only() {
    let a = model([1.0, 1.0, 3.0], [0.1, 1.0], [0.3, 1.1, -0.8]);
    let axis = a.pose.rotation() * Vector3::z();
    for psi in [0.4, FRAC_PI_4, 2.0] {
        assert_errors(&a, &turned(&a, axis, psi), 0.0, 0.0);
    }
    let across = a.pose.rotation() * Vector3::x();
    for tilt in [1e-6, 0.5, PI - 0.5] {
        let tilted = turned(&turned(&a, axis, 1.0), across, tilt);
        assert_errors(&a, &tilted, 0.0, f64::min(tilt, PI - tilt));
    }
}

#[test]
fn a_sphere_has_no_orientation_and_a_cube_has_24() {
    let ball = model([2.0; 3], [1.0, 1.0], [0.0; 3]);
    assert_errors(&ball, &turned(&ball, Vector3::new(1.0, 2.0, 3.0), 2.0), 0.0, 0.0);

    let cube = model([2.0; 3], [0.1, 0.1], [0.0; 3]);
    let diagonal = Vector3::new(1.0, 1.0, 1.0);
    assert_errors(&cube, &turned(&cube, diagonal, 2.0 * PI / 3.0), 0.0, 0.0);
    assert_errors(&cube, &turned(&cube, diagonal, PI / 3.0), 0.0, PI / 3.0);
    assert_errors(&cube, &turned(&cube, Vector3::x(), FRAC_PI_4), 0.0, FRAC_PI_4);
}
