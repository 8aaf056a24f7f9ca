//! The laws that every deformation obeys, over all of them, along the axes and any line, alone
//! and in chains, in micrometres and in kilometres.

mod examples;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Matrix3, Vector3};

use super::*;
use crate::math::{Dual, Interval, Univariate};
use examples::{Example, POINTS, bend, examples, line, polyline};

/// Runs a law over every example and point, and makes sure that there are some.
fn for_all(law: impl Fn(&Example, &Vector3<f64>)) {
    let (mut examples_tried, mut points_tried) = (0, 0);
    for example in examples() {
        for x in example.points() {
            law(&example, &x);
            points_tried += 1;
        }
        examples_tried += 1;
    }
    assert!(examples_tried >= 20 && points_tried >= POINTS * examples_tried, "nothing was tried");
}

/// The Jacobian by central differences.
fn difference_quotients(example: &Example, x: &Vector3<f64>) -> Matrix3<f64> {
    let h = 1e-6 * example.unit();
    let column = |axis: usize| {
        let step = Vector3::ith(axis, h);
        let moved = |x: Vector3<f64>| Vector3::from(example.chain.forward_of(x.into()));
        (moved(x + step) - moved(x - step)) / (2.0 * h)
    };
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}

#[test]
fn the_jacobian_is_its_difference_quotient() {
    for_all(|example, x| {
        let jacobian = example.chain.jacobian(x);
        let difference = (jacobian - difference_quotients(example, x)).amax();
        // Curvature over a step of 1e-6, and rounding over it.
        assert!(difference < 2e-8 * jacobian.amax(), "{} {x:?} {difference}", example.name);
    });
}

#[test]
fn determinant_and_normal_transform_are_those_of_the_jacobian() {
    for_all(|example, x| {
        let jacobian = example.chain.jacobian(x);
        let determinant = example.chain.determinant(x);
        assert!(determinant > 0.0, "{}", example.name);
        assert!((determinant / jacobian.determinant() - 1.0).abs() < 1e-12, "{}", example.name);
        let cofactors = jacobian.try_inverse().unwrap().transpose() * determinant;
        let difference = (example.chain.normal_transform(x) - cofactors).amax();
        assert!(difference < 1e-12 * cofactors.amax(), "{} {difference}", example.name);
    });
}

#[test]
fn normals_are_perpendicular_to_deformed_tangents_and_keep_their_side() {
    for_all(|example, x| {
        let n = Vector3::new(0.3, -0.7, 0.4).normalize();
        let [u, v] = [n.cross(&Vector3::x()), n.cross(&Vector3::y())];
        let jacobian = difference_quotients(example, x);
        let normal = (example.chain.normal_transform(x) * n).normalize();
        for tangent in [u, v] {
            // The error of the difference quotients.
            let deformed = (jacobian * tangent).normalize();
            assert!(normal.dot(&deformed).abs() < 2e-7, "{}", example.name);
        }
        assert!(normal.dot(&(jacobian * n)) > 0.0, "{}", example.name);
    });
}

#[test]
fn the_inverse_of_the_forward_map_is_the_identity() {
    for_all(|example, x| {
        let deformed = example.chain.forward(x).unwrap_or_else(|e| panic!("{}: {e}", example.name));
        let back = example.chain.inverse(&deformed).unwrap();
        // Some twenty roundings, magnified by a scaling of 1:150 and by deformed coordinates.
        let tolerance = 1e-13 * (example.unit() + deformed.amax());
        assert!((back - x).amax() < tolerance, "{} {x:?} {back:?}", example.name);
    });
}

#[test]
fn the_forward_map_of_the_inverse_is_the_identity() {
    for_all(|example, x| {
        if let Ok(before) = example.chain.inverse(x) {
            let again = example.chain.forward(&before).unwrap();
            let tolerance = 1e-13 * (example.unit() + before.amax());
            assert!((again - x).amax() < tolerance, "{} {x:?} {again:?}", example.name);
        }
    });
}

#[test]
fn intervals_hold_the_images_of_points() {
    for_all(|example, x| {
        let size = 0.1 * example.unit();
        let region: [Interval; 3] = std::array::from_fn(|i| Interval::new(x[i], x[i] + size));
        let [forward, inverse] =
            [example.chain.forward_of(region), example.chain.inverse_of(region)];
        for share in [[0.0, 0.0, 0.0], [1.0, 0.5, 0.2], [0.3, 1.0, 1.0]] {
            let inner = x + Vector3::from(share) * size;
            let image = example.chain.forward_of(inner.into());
            let original = example.chain.inverse_of(inner.into());
            // Point arithmetic rounds, too.
            let holds =
                |a: Interval, b: f64| a.widened_relatively(1e-13).widened(1e-13 * size).contains(b);
            assert!((0..3).all(|i| holds(forward[i], image[i])), "{}", example.name);
            assert!((0..3).all(|i| holds(inverse[i], original[i])), "{} {inner:?}", example.name);
        }
    });
}

#[test]
fn slopes_along_a_line_are_the_jacobian_times_its_direction() {
    for_all(|example, x| {
        let direction = Vector3::new(0.6, -0.3, 0.74) * example.unit();
        let start = Dual::variable(Interval::ZERO);
        let line = std::array::from_fn(|i| start * direction[i] + x[i]);
        let slopes = example.chain.forward_of(line).map(|dual| dual.slope);
        let expected = example.chain.jacobian(x) * direction;
        let slack = 1e-11 * expected.amax();
        let holds = (0..3).all(|i| slopes[i].widened(slack).contains(expected[i]));
        assert!(holds, "{} {slopes:?} {expected:?}", example.name);
    });
}

#[test]
fn a_taper_changes_volumes_by_r_squared_and_a_twist_keeps_them() {
    for z in [-0.9, -0.2, 0.0, 0.4, 0.79] {
        let x = Vector3::new(0.3, -0.2, z);
        let r = polyline().value(z);
        assert_eq!(Taper::new(polyline()).determinant(&x), r * r);
        assert_eq!(Twist::new(polyline()).determinant(&x), 1.0);
    }
}

#[test]
fn a_bend_changes_volumes_by_one_less_k_z_and_moves_its_ends_rigidly() {
    let bend = bend(0.8, 0.1, [-0.7, 0.6]);
    for z in [-1.0, 0.0, 0.9] {
        assert_eq!(bend.determinant(&Vector3::new(0.2, 0.1, z)), 1.0 - 0.8 * z);
        for y in [-2.0, 1.3] {
            let jacobian = bend.jacobian(&Vector3::new(0.2, y, z));
            assert_eq!(bend.determinant(&Vector3::new(0.2, y, z)), 1.0);
            assert!((jacobian.transpose() * jacobian - Matrix3::identity()).amax() < 1e-15);
        }
    }
}

#[test]
fn the_centre_line_of_a_bend_becomes_an_arc_of_the_same_length() {
    let bend = bend(FRAC_PI_2, 0.0, [-1.0, 1.0]);
    let ends = [-1.0, 1.0].map(|y| bend.forward(&Vector3::new(0.0, y, 0.0)).unwrap());
    let radius = 1.0 / FRAC_PI_2;
    assert!((ends[0] - Vector3::new(0.0, -radius, radius)).norm() < 1e-15);
    assert!((ends[1] - Vector3::new(0.0, radius, radius)).norm() < 1e-15);
}

#[test]
fn folds_are_named() {
    let taper = Taper::new(line(1.0, -0.5));
    let at = |z: f64| Vector3::new(1.0, 0.0, z);
    for z in [2.0, 3.0] {
        assert!(matches!(taper.forward(&at(z)), Err(DeformError::TaperFolds { .. })));
        assert!(matches!(taper.inverse(&at(z)), Err(DeformError::TaperFolds { .. })));
    }
    let quarter = bend(0.5, 0.0, [-PI / 2.0, PI / 2.0]);
    for z in [2.0, 5.0] {
        assert!(matches!(quarter.forward(&at(z)), Err(DeformError::BendFolds { .. })));
    }
    let open = bend(1.0, 0.0, [-2.0, 2.0]);
    let far = Vector3::new(0.0, 5.0, 0.0);
    assert!(matches!(open.forward(&far), Err(DeformError::BendMeets { .. })));
    let chain = Chain::new([
        Deformation::new(Scale::new([1.0, 1.0, 4.0]).unwrap()),
        Deformation::new(taper),
    ]);
    assert!(chain.forward(&at(0.4)).is_ok());
    let message = chain.forward(&at(0.6)).unwrap_err().to_string();
    assert!(message.contains("folds at z = 2.4"), "{message}");
}

#[test]
fn parameters_outside_their_domain_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Scale::new([1.0, bad, 1.0]).is_err());
    }
    assert!(Bend::new(f64::NAN, 0.0, [-1.0, 1.0]).is_err());
    assert!(Bend::new(1.0, 0.0, [1.0, 1.0]).is_err());
    assert!(Bend::new(4.0, 0.0, [-1.0, 1.0]).is_err());
    let twist = || Twist::new(line(0.0, 1.0));
    assert!(Deformation::about(twist(), Vector3::zeros(), Vector3::zeros()).is_err());
    assert!(
        Deformation::about(twist(), Vector3::zeros(), Vector3::new(f64::NAN, 0.0, 1.0)).is_err()
    );
}
