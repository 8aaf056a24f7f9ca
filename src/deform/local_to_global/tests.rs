//! B81's examples and B84's consistency, against closed forms.

use std::f64::consts::PI;

use super::*;
use crate::deform::{Bend, Chain, Deform, Deformation, Line, Taper, Twist};

const TOLERANCE: f64 = 1e-12;

fn stations() -> Vec<f64> {
    (0..=40).map(|i| 0.25 * f64::from(i)).collect()
}

/// B81's inextensible plane curve of inclination `theta(s)`, from the origin along x.
fn plane_curve(theta: impl Fn(f64) -> f64) -> Vec<Vector3<f64>> {
    let rotation = |s: f64| zxz_rotation([theta(s), 0.0, 0.0]);
    deformed_curve(rotation, |_| Vector3::x(), Vector3::zeros(), &stations(), TOLERANCE)
}

#[test]
fn constant_curvature_makes_a_circular_arc() {
    for k in [0.5, 0.25, -2.0] {
        for (s, x) in stations().into_iter().zip(plane_curve(|s| k * s)) {
            let expected = Vector3::new((k * s).sin(), 1.0 - (k * s).cos(), 0.0) / k;
            assert!((x - expected).norm() < 1e-12, "{k} {s}");
        }
    }
}

/// Fresnel's integrals `int_0^s cos(a t^2) dt` and of the sine, by their power series.
fn fresnel(a: f64, s: f64) -> [f64; 2] {
    let mut sums = [0.0; 2];
    let (mut term, mut n) = (s, 0);
    while term.abs() > 1e-18 || n < 3 {
        // The series of cosine and sine alternate; the term is a^n s^(2n+1) / n!.
        let sign = if n % 4 < 2 { 1.0 } else { -1.0 };
        sums[n % 2] += sign * term / f64::from(2 * n as u32 + 1);
        n += 1;
        term *= a * s * s / n as f64;
    }
    sums
}

#[test]
fn curvature_in_proportion_to_length_makes_cornus_spiral() {
    // B81 Fig. 13a: theta = 0.06 s^2 - 0.1.
    let (sin, cos) = (-0.1_f64).sin_cos();
    for (s, x) in stations().into_iter().zip(plane_curve(|s| 0.06 * s * s - 0.1)) {
        let [c, d] = fresnel(0.06, s);
        let expected = Vector3::new(c * cos - d * sin, c * sin + d * cos, 0.0);
        // The series cancels down from exp(6).
        assert!((x - expected).norm() < 1e-11, "{s}");
    }
}

/// Bessel's J0 by its power series.
fn bessel_j0(x: f64) -> f64 {
    let (mut term, mut sum) = (1.0, 0.0);
    for n in 1..40 {
        sum += term;
        term *= -0.25 * x * x / f64::from(n * n);
    }
    sum
}

#[test]
fn sine_generated_curves_repeat_and_advance_by_bessels_function() {
    // B81 Figs. 13b, c: theta = a cos s advances 2 pi J0(a) along x in a period.
    for a in [1.0, 0.25] {
        let rotation = |s: f64| zxz_rotation([a * f64::cos(s), 0.0, 0.0]);
        let periods = [0.0, 2.0 * PI, 4.0 * PI];
        let x = deformed_curve(rotation, |_| Vector3::x(), Vector3::zeros(), &periods, TOLERANCE);
        let advance = Vector3::new(2.0 * PI * bessel_j0(a), 0.0, 0.0);
        assert!((x[1] - advance).norm() < 1e-11 && (x[2] - 2.0 * advance).norm() < 1e-11);
    }
}

#[test]
fn inextensible_curves_keep_their_length() {
    let angles = |s: f64| [0.3 * s, 0.5 * s.sin(), 0.2 * s * s];
    let fine: Vec<f64> = (0..=4000).map(|i| 0.001 * f64::from(i)).collect();
    let curve = deformed_curve(
        |s| zxz_rotation(angles(s)),
        |_| Vector3::x(),
        Vector3::zeros(),
        &fine,
        TOLERANCE,
    );
    let length: f64 = curve.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    // Chords fall short by the square of their angle over 24.
    assert!((length - 4.0).abs() < 1e-6);
}

#[test]
fn omega_is_the_velocity_of_the_frame_in_its_own_axes() {
    let angles = |s: f64| [0.3 + 0.7 * s, -0.4 + 0.5 * s.sin(), 0.2 + 0.9 * s * s];
    let rates = |s: f64| [0.7, 0.5 * s.cos(), 1.8 * s];
    let h = 1e-5;
    for s in [-1.0, 0.0, 0.4, 2.0] {
        let frame = zxz_rotation(angles(s));
        let change = (zxz_rotation(angles(s + h)) - zxz_rotation(angles(s - h))) / (2.0 * h);
        let omega = zxz_curvatures(angles(s), rates(s));
        // B81's differentiation rules: T' = O3 N1 - O2 N2, N1' = O1 N2 - O3 T, N2' = O2 T - O1 N1.
        let rules =
            Matrix3::new(0.0, -omega.z, omega.y, omega.z, 0.0, -omega.x, -omega.y, omega.x, 0.0);
        assert!((change - frame * rules).amax() < 1e-8, "{s}");
        assert!((change.column(0).norm() - curve_curvature(&omega)).abs() < 1e-8);
    }
}

#[test]
fn a_helix_comes_of_constant_rates() {
    // T at a constant slope that turns about z: phi1 = 0 leaves T in the plane, so tilt by phi1.
    let (slope, turn) = (0.4_f64, 1.3);
    let angles = |s: f64| [slope, 0.5 * PI, turn * s];
    let x = deformed_curve(
        |s| zxz_rotation(angles(s)),
        |_| Vector3::x(),
        Vector3::zeros(),
        &stations(),
        TOLERANCE,
    );
    let radius = slope.cos() / turn;
    for (s, x) in stations().into_iter().zip(x) {
        let angle = turn * s;
        let expected =
            Vector3::new(radius * angle.sin(), radius * (1.0 - angle.cos()), s * slope.sin());
        assert!((x - expected).norm() < 1e-11, "{s}");
    }
}

fn chain() -> Chain {
    let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
    Chain::new([
        Deformation::new(Taper::new(line(1.0, -0.3))),
        Deformation::new(Twist::new(line(0.0, 1.2))),
        Deformation::new(Bend::new(0.7, 0.0, [-1.0, 1.0]).unwrap()),
    ])
}

#[test]
fn a_deformation_comes_back_from_its_jacobian_along_any_path() {
    let chain = chain();
    let origin = Vector3::new(0.1, -0.2, 0.3);
    let image = chain.forward(&origin).unwrap();
    let field = JacobianField::new(|x| chain.jacobian(x), origin, image, 1e-9);
    for x in [[0.8, 1.9, -0.6], [-0.5, -1.4, 0.4], [0.3, 0.2, 0.1]].map(Vector3::from) {
        let expected = chain.forward(&x).unwrap();
        let [direct, around] =
            [field.deformed(&x), field.deformed_along(&[Vector3::new(-0.4, 0.3, 0.2), x])];
        for found in [direct, around] {
            assert!(found.error <= 1e-9);
            assert!((found.value - expected).norm() < 1e-9, "{x:?}");
        }
    }
}

#[test]
fn jacobians_pass_their_test_and_other_fields_fail_by_a_number() {
    let chain = chain();
    let true_field =
        JacobianField::new(|x| chain.jacobian(x), Vector3::zeros(), Vector3::zeros(), 1e-9);
    for x in [[0.3, 0.4, 0.2], [-0.2, 0.6, -0.3]].map(Vector3::from) {
        assert!(true_field.violation(&x, 1.0) < 1e-9);
    }
    // J_1,2 = (0, 0, 1) and J_2,1 = 0: the violation is 1.
    let sheared =
        |x: &Vector3<f64>| Matrix3::from_columns(&[x.y * Vector3::z(), Vector3::y(), Vector3::z()]);
    let false_field = JacobianField::new(sheared, Vector3::zeros(), Vector3::zeros(), 1e-9);
    assert!((false_field.violation(&Vector3::new(0.3, 0.4, 0.2), 1.0) - 1.0).abs() < 1e-9);
    // Around a square of area 1 the paths then end 1 apart.
    let corner = Vector3::new(1.0, 1.0, 0.0);
    let paths =
        [Vector3::x(), Vector3::y()].map(|side| false_field.deformed_along(&[side, corner]));
    assert!(((paths[0].value - paths[1].value).norm() - 1.0).abs() < 1e-12);
}

#[test]
fn sheets_are_bent_consistently_within_a_tolerance_lambda() {
    // B81: rates of all three angles below lambda.
    for lambda in [0.1, 0.01, 0.001] {
        let share = lambda / 3.0;
        let angles = move |x: &Vector3<f64>| {
            [share * (x.x + x.y.sin()), 0.7 + share * (x.y - x.x.cos()), share * (x.x * 0.5 - x.y)]
        };
        let rotation = |x: &Vector3<f64>| zxz_rotation(angles(x));
        let field = JacobianField::new(rotation, Vector3::zeros(), Vector3::zeros(), 1e-10);
        for x in [[0.3, 0.4, 0.0], [1.0, 1.0, 0.0], [-0.5, 0.9, 0.0]].map(Vector3::from) {
            // Each of two columns turns by no more than the sum of three rates.
            let violation = field.violation(&x, 1.0);
            assert!(violation > 0.0 && violation < 2.0 * 3.0 * lambda, "{lambda} {violation}");
            let straight = field.deformed(&x).value;
            let around = field.deformed_along(&[Vector3::new(x.x, 0.0, 0.0), x]).value;
            let area = 0.5 * (x.x * x.y).abs();
            assert!((straight - around).norm() < 6.0 * lambda * area, "{lambda}");
            // Lengths from the origin stretch by no more than 1 + lambda.
            assert!(straight.norm() <= x.norm() * (1.0 + lambda));
        }
    }
}
