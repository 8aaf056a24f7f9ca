//! The laws that every family keeps, over exponents and degenerate positions.

use nalgebra::{Matrix3, Vector3};

use super::{Parametric, Shape, Solid, Superellipsoid};

const EXPONENTS: [f64; 5] = [0.1, 0.5, 1.0, 1.5, 2.0];

fn exponent_pairs() -> impl Iterator<Item = [f64; 2]> {
    EXPONENTS.into_iter().flat_map(|e1| EXPONENTS.map(|e2| [e1, e2]))
}

/// Every family at every pair of exponents.
fn shapes() -> Vec<Shape> {
    let size = [2.0, 0.7, 1.3];
    exponent_pairs().map(|e| Superellipsoid::new(size, e).unwrap().into()).collect()
}

/// Runs a law on many examples, and refuses to have seen none of a family.
fn for_each_example<T>(
    examples: impl Fn(&Shape) -> Vec<T>,
    law: impl Fn(&Shape, &T) -> Option<()>,
) {
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for shape in shapes() {
        let kept = examples(&shape).iter().filter(|example| law(&shape, example).is_some()).count();
        match counts.iter_mut().find(|(family, _)| *family == shape.family()) {
            Some((_, count)) => *count += kept,
            None => counts.push((shape.family(), kept)),
        }
    }
    assert!(!counts.is_empty() && counts.iter().all(|(_, count)| *count >= 100), "{counts:?}");
}

/// Shares of the natural ranges: ends, middle and quarters, where axes and planes of symmetry
/// are, and others.
const SHARES: [f64; 9] = [0.0, 0.11, 0.25, 0.37, 0.5, 0.62, 0.75, 0.93, 1.0];

/// Latitudes and longitudes of a shape's domain.
fn angles(shape: &Shape) -> Vec<[f64; 2]> {
    let [[south, north], [west, east]] = shape.domain();
    let etas = SHARES.map(|share| south + share * (north - south));
    let omegas = SHARES.map(|share| west + share * (east - west));
    etas.into_iter().flat_map(|eta| omegas.map(|omega| [eta, omega])).collect()
}

/// Those off the planes of symmetry, where every function is smooth.
fn smooth_angles(shape: &Shape) -> Vec<[f64; 2]> {
    let is_smooth =
        |[eta, omega]: &[f64; 2]| (2.0 * eta).sin().abs() > 0.1 && (2.0 * omega).sin().abs() > 0.1;
    angles(shape).into_iter().filter(is_smooth).collect()
}

#[test]
fn positions_have_inside_outside_one() {
    for_each_example(angles, |shape, &[eta, omega]| {
        let f = shape.inside_outside(&shape.position(eta, omega));
        assert!((f - 1.0).abs() < 1e-12, "{shape:?} {eta} {omega} {f}");
        Some(())
    });
}

/// `(f(t + h) - f(t - h)) / 2h`, with the error of the fourth order left.
fn quotient(f: impl Fn(f64) -> Vector3<f64>, t: f64, h: f64) -> Vector3<f64> {
    let central = |h: f64| (f(t + h) - f(t - h)) / (2.0 * h);
    (4.0 * central(h) - central(2.0 * h)) / 3.0
}

#[test]
fn derivatives_of_the_position_are_its_difference_quotients() {
    for_each_example(smooth_angles, |shape, &[eta, omega]| {
        let h = 1e-4;
        let [r_eta, r_omega] = shape.tangents(eta, omega);
        let [r_ee, r_eo, r_oo] = shape.second_derivatives(eta, omega);
        let tangents_at = |eta, omega| shape.tangents(eta, omega);
        for (derivative, quotient) in [
            (r_eta, quotient(|t| shape.position(t, omega), eta, h)),
            (r_omega, quotient(|t| shape.position(eta, t), omega, h)),
            (r_ee, quotient(|t| tangents_at(t, omega)[0], eta, h)),
            (r_eo, quotient(|t| tangents_at(eta, t)[0], omega, h)),
            (r_eo, quotient(|t| tangents_at(t, omega)[1], eta, h)),
            (r_oo, quotient(|t| tangents_at(eta, t)[1], omega, h)),
        ] {
            let scale = 1e-8 * (1.0 + derivative.norm());
            assert!((derivative - quotient).norm() < scale, "{shape:?} {eta} {omega}");
        }
        Some(())
    });
}

#[test]
fn derivatives_of_inside_outside_are_its_difference_quotients() {
    for_each_example(smooth_angles, |shape, &[eta, omega]| {
        let surface = shape.position(eta, omega);
        for x in [surface, 0.8 * surface, 1.1 * surface] {
            let gradient = shape.inside_outside_gradient(&x);
            let hessian = shape.inside_outside_hessian(&x);
            let step = |axis: usize, t: f64| x + Vector3::ith(axis, t);
            let columns: [_; 3] = std::array::from_fn(|axis| {
                let h = 1e-4 * x[axis].abs();
                let along = |t| Vector3::new(shape.inside_outside(&step(axis, t)), 0.0, 0.0);
                let slope = quotient(along, 0.0, h).x;
                // Of exponents up to 20, and rounding over the step.
                let scale =
                    1e-8 * (gradient[axis].abs() + shape.inside_outside(&x) / x[axis].abs());
                assert!((gradient[axis] - slope).abs() < scale.abs() + 1e-10, "{shape:?} {x}");
                quotient(|t| shape.inside_outside_gradient(&step(axis, t)), 0.0, h)
            });
            let difference = hessian - Matrix3::from_columns(&columns);
            let bound = 1e-7 * hessian.amax();
            assert!(difference.amax() < bound, "{shape:?} {x} {hessian} {difference}");
        }
        Some(())
    });
}

#[test]
fn normals_are_along_the_gradient_and_perpendicular_to_both_tangents() {
    for_each_example(angles, |shape, &[eta, omega]| {
        let normal = shape.normal(eta, omega);
        assert!((normal.norm() - 1.0).abs() < 1e-14, "{shape:?} {eta} {omega}");
        for tangent in shape.tangents(eta, omega) {
            let length = tangent.norm();
            if length.is_finite() && length > 1e-100 {
                let cosine = normal.dot(&tangent) / length;
                assert!(cosine.abs() < 1e-12, "{shape:?} {eta} {omega} {cosine}");
            }
        }
        // On an edge the gradient is the mean of both sides'.
        let gradient = shape.inside_outside_gradient(&shape.position(eta, omega));
        let Shape::Superellipsoid(of_family) = shape;
        let is_edge = of_family.exponents().iter().any(|&e| e >= 2.0);
        if is_edge && smooth_angles(shape).iter().all(|angle| *angle != [eta, omega]) {
            return None;
        }
        let sine = normal.cross(&gradient.normalize()).norm();
        assert!(sine < 1e-12 && normal.dot(&gradient) > 0.0, "{shape:?} {eta} {omega} {sine}");
        Some(())
    });
}
