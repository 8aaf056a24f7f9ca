//! Derivatives, normals and curvatures.

use nalgebra::{Matrix3, Vector3};

use super::*;
use crate::shape::FundamentalForms;

/// `(f(t + h) - f(t - h)) / 2h`, with an error of the fourth order left.
fn quotient(f: impl Fn(f64) -> Vector3<f64>, t: f64, h: f64) -> Vector3<f64> {
    let central = |h: f64| (f(t + h) - f(t - h)) / (2.0 * h);
    (4.0 * central(h) - central(2.0 * h)) / 3.0
}

#[test]
fn derivatives_of_the_position_are_its_difference_quotients() {
    try_on_all(500, |Example { shape, .. }| {
        let angles = smooth_angles(shape);
        for &[eta, omega] in &angles {
            let h = 1e-4;
            let [r_eta, r_omega] = shape.tangents(eta, omega);
            let [r_ee, r_eo, r_oo] = shape.second_derivatives(eta, omega);
            for (derivative, quotient) in [
                (r_eta, quotient(|t| shape.position(t, omega), eta, h)),
                (r_omega, quotient(|t| shape.position(eta, t), omega, h)),
                (r_ee, quotient(|t| shape.tangents(t, omega)[0], eta, h)),
                (r_eo, quotient(|t| shape.tangents(eta, t)[0], omega, h)),
                (r_eo, quotient(|t| shape.tangents(t, omega)[1], eta, h)),
                (r_oo, quotient(|t| shape.tangents(eta, t)[1], omega, h)),
            ] {
                let bound = 1e-7 * (1.0 + derivative.norm());
                assert!((derivative - quotient).norm() < bound, "{shape:?} {eta} {omega}");
            }
        }
        angles.len()
    });
}

#[test]
fn derivatives_of_inside_outside_are_its_difference_quotients() {
    try_on_all(500, |Example { shape, .. }| {
        let angles = smooth_angles(shape);
        for &[eta, omega] in &angles {
            let surface = shape.position(eta, omega);
            for x in [surface, 0.9 * surface, 1.1 * surface] {
                let gradient = shape.inside_outside_gradient(&x);
                let hessian = shape.inside_outside_hessian(&x);
                let columns: [_; 3] = std::array::from_fn(|axis| {
                    let at = |t: f64| x + Vector3::ith(axis, t);
                    let h = 1e-4 * x[axis].abs();
                    let f = |t: f64| Vector3::ith(axis, shape.inside_outside(&at(t)));
                    let slope = quotient(f, 0.0, h)[axis];
                    let bound = 1e-6 * gradient.component_mul(&x).abs().sum() / x[axis].abs();
                    assert!((gradient[axis] - slope).abs() < bound, "{shape:?} {x}");
                    quotient(|t| shape.inside_outside_gradient(&at(t)), 0.0, h)
                });
                let scaled = |m: &Matrix3<f64>| Matrix3::from_fn(|i, j| m[(i, j)] * x[i] * x[j]);
                let difference = hessian - Matrix3::from_columns(&columns);
                let steepness = gradient.component_mul(&x).abs().sum();
                let bound = 1e-5 * scaled(&hessian).amax() + 1e-9 * steepness;
                assert!(scaled(&difference).amax() < bound, "{shape:?} {x}");
            }
        }
        angles.len()
    });
}

#[test]
fn hessians_are_symmetric_and_no_derivative_is_undefined() {
    try_on_all(1000, |Example { shape, .. }| {
        let angles = angles(shape);
        for &[eta, omega] in &angles {
            let x = shape.position(eta, omega);
            for x in [x, x.map(|c| if c.abs() < 1e-9 { 0.0 } else { c }), 0.0 * x] {
                let hessian = shape.inside_outside_hessian(&x);
                assert!(!shape.inside_outside_gradient(&x).iter().any(|d| d.is_nan()));
                assert!(!hessian.iter().any(|d| d.is_nan()), "{shape:?} {x} {hessian}");
                assert_eq!(hessian, hessian.transpose());
            }
            let all = [
                shape.tangents(eta, omega).to_vec(),
                shape.second_derivatives(eta, omega).to_vec(),
            ];
            assert!(!all.concat().iter().any(|r| r.iter().any(|d| d.is_nan())));
        }
        angles.len()
    });
}

#[test]
fn normals_are_perpendicular_to_both_tangents() {
    try_on_all(1000, |Example { shape, .. }| {
        let angles = angles(shape);
        let mut count = 0;
        for &[eta, omega] in &angles {
            let normal = shape.normal(eta, omega);
            assert!((normal.norm() - 1.0).abs() < 1e-14, "{shape:?} {eta} {omega}");
            for tangent in shape.tangents(eta, omega) {
                let length = tangent.norm();
                let is_edge = !smooth_angles(shape).contains(&[eta, omega]);
                if length.is_finite() && length > 1e-100 && !is_edge {
                    let cosine = normal.dot(&tangent) / length;
                    assert!(cosine.abs() < 1e-12, "{shape:?} {eta} {omega} {cosine}");
                    count += 1;
                }
            }
        }
        count
    });
}

#[test]
fn normals_are_along_the_gradient() {
    try_on_all(500, |example| {
        let shape = &example.shape;
        // From exponent 2 on, edges have a normal a side, and the gradient none of them.
        let angles = if example.is_at_most(1.5) { angles(shape) } else { smooth_angles(shape) };
        for &[eta, omega] in &angles {
            let normal = shape.normal(eta, omega);
            let gradient = shape.inside_outside_gradient(&shape.position(eta, omega)).normalize();
            let sine = normal.cross(&gradient).norm();
            // A coordinate's rounding of 1e-16 to the power 2/e - 1 that the gradient takes it to,
            // times the aspect.
            let bound = if example.is_at_most(1.0) { 1e-8 } else { 1e-3 };
            assert!(sine < bound && normal.dot(&gradient) > 0.0, "{shape:?} {eta} {omega} {sine}");
        }
        angles.len()
    });
}

#[test]
fn curvatures_of_the_parametric_and_of_the_level_surface_are_the_same() {
    try_on_all(500, |Example { shape, .. }| {
        let angles = smooth_angles(shape);
        for &[eta, omega] in &angles {
            let parametric = FundamentalForms::at(shape, eta, omega).curvatures();
            let level = shape.curvatures(&shape.position(eta, omega));
            let scale = 1e-8 * (parametric.principal[0].abs() + parametric.principal[1].abs());
            for (a, b) in parametric.principal.into_iter().zip(level.principal) {
                assert!((a - b).abs() < scale + 1e-10, "{shape:?} {eta} {omega} {a} {b}");
            }
        }
        angles.len()
    });
}
