//! Laws of the superellipsoid, over exponents, aspects and degenerate positions.

use super::*;
use std::f64::consts::{FRAC_PI_2, PI};

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

/// Latitudes and longitudes, the poles, the equator and the planes of symmetry among them.
fn angles() -> impl Iterator<Item = (f64, f64)> {
    let etas = [-FRAC_PI_2, -0.6, 0.0, 1e-3, 0.3, 1.2, FRAC_PI_2];
    let omegas = [-PI, -2.0, -FRAC_PI_2, 0.0, 0.2, 0.8, FRAC_PI_2, 3.0];
    etas.into_iter().flat_map(move |eta| omegas.map(|omega| (eta, omega)))
}

#[test]
fn positions_have_gauge_and_inside_outside_one() {
    for shape in shapes() {
        for (eta, omega) in angles() {
            let x = shape.position(eta, omega);
            // Rounding of a power, undone by its reciprocal.
            assert!((shape.gauge(&x) - 1.0).abs() < 1e-14, "{shape:?} {eta} {omega}");
            let f = shape.inside_outside(&x);
            assert!((f - 1.0).abs() < 1e-14 * 2.0 / shape.exponents()[0]);
        }
    }
}

#[test]
fn inside_outside_is_the_printed_formula() {
    for shape in shapes() {
        let ([a1, a2, a3], [e1, e2]) = (shape.size(), shape.exponents());
        let x = Vector3::new(0.4 * a1, -0.9 * a2, 0.7 * a3);
        let xy = 0.4_f64.powf(2.0 / e2) + 0.9_f64.powf(2.0 / e2);
        let printed = xy.powf(e2 / e1) + 0.7_f64.powf(2.0 / e1);
        // Rounding amplified by exponents up to 40.
        assert!((shape.inside_outside(&x) / printed - 1.0).abs() < 1e-12);
    }
}

#[test]
fn gauge_is_homogeneous() {
    for shape in shapes() {
        let x = shape.position(0.4, 0.9);
        for factor in [1e-60, 1e-3, 0.5, 7.0, 1e60] {
            let ratio = shape.gauge(&(x * factor)) / (factor * shape.gauge(&x));
            assert!((ratio - 1.0).abs() < 1e-14);
        }
        assert_eq!(shape.gauge(&Vector3::zeros()), 0.0);
    }
}

#[test]
fn gauge_gradient_is_its_difference_quotient_and_satisfies_eulers_identity() {
    for shape in shapes().filter(|shape| shape.exponents().iter().all(|&e| e >= 0.1)) {
        let x = shape.position(0.5, -0.7);
        let gradient = shape.gauge_gradient(&x);
        assert!((gradient.dot(&x) - 1.0).abs() < 1e-13);
        for axis in 0..3 {
            let mut step = Vector3::zeros();
            step[axis] = 1e-5 * x[axis];
            let quotient =
                (shape.gauge(&(x + step)) - shape.gauge(&(x - step))) / (2.0 * step[axis]);
            // Curvature 2/e = 20, squared, times the step squared, and rounding over the step.
            let scale = shape.gauge(&x) / x[axis].abs();
            assert!((gradient[axis] - quotient).abs() < 1e-7 * scale, "{shape:?}");
        }
    }
}

#[test]
fn normal_is_parallel_to_the_gauge_gradient_and_perpendicular_to_tangents() {
    for shape in shapes().filter(|shape| shape.exponents().iter().all(|&e| e < 2.0)) {
        for (eta, omega) in [(0.5, -0.7), (-0.2, 2.0), (0.9, 0.6)] {
            let normal = shape.normal(eta, omega);
            let x = shape.position(eta, omega);
            let gradient = shape.gauge_gradient(&x).normalize();
            assert!((normal - gradient).norm() < 1e-12, "{shape:?} {normal} {gradient}");
            let h = 1e-6;
            let along_eta = shape.position(eta + h, omega) - shape.position(eta - h, omega);
            let along_omega = shape.position(eta, omega + h) - shape.position(eta, omega - h);
            for tangent in [along_eta, along_omega] {
                // Curvature of the parameterisation over the step.
                assert!(normal.dot(&tangent.normalize()).abs() < 1e-6, "{shape:?}");
            }
        }
    }
}

#[test]
fn nudging_along_the_normal_leads_outside_and_inside() {
    for shape in shapes().filter(|shape| shape.exponents().iter().all(|&e| e <= 1.5)) {
        for (eta, omega) in angles() {
            let x = shape.position(eta, omega);
            let normal = shape.normal(eta, omega);
            let step = 1e-6 * shape.size().into_iter().fold(f64::INFINITY, f64::min) * normal;
            assert!(shape.gauge(&(x + step)) > 1.0, "{shape:?} {eta} {omega}");
            assert!(shape.radial_distance(&(x + step)) > 0.0);
            assert!(shape.gauge(&(x - step)) < 1.0, "{shape:?} {eta} {omega}");
            assert!(shape.radial_distance(&(x - step)) < 0.0);
        }
    }
}

#[test]
fn radial_distance_is_that_to_the_radial_projection() {
    for shape in shapes() {
        for factor in [0.01, 0.9, 1.0, 1.5, 1e4] {
            let x = shape.position(0.3, 0.4) * factor;
            let foot = shape.radial_projection(&x);
            assert!((shape.gauge(&foot) - 1.0).abs() < 1e-14);
            let expected = x.norm() - foot.norm();
            let scale = x.norm().max(foot.norm());
            assert!((shape.radial_distance(&x) - expected).abs() < 1e-14 * scale);
        }
    }
}

#[test]
fn radial_distance_at_the_centre_is_that_of_a_ray_to_a_corner_of_the_box() {
    for shape in shapes() {
        let ray = Vector3::from(shape.size());
        let depth = shape.radial_projection(&ray).norm();
        let distance = shape.radial_distance(&Vector3::zeros());
        assert!((distance + depth).abs() < 1e-14 * depth);
    }
}

#[test]
fn support_is_the_greatest_projection_of_the_surface() {
    let directions = [[1.0, 0.0, 0.0], [0.0, 0.0, -2.0], [1.0, 2.0, 3.0], [-0.3, 0.01, 0.5]];
    for shape in shapes().filter(|shape| shape.size()[0] == 2.0) {
        for direction in directions.map(Vector3::from) {
            let support = shape.support(&direction);
            let mut greatest = f64::NEG_INFINITY;
            for i in -200..=200 {
                for j in -400..=400 {
                    let (eta, omega) = (f64::from(i) * PI / 400.0, f64::from(j) * PI / 400.0);
                    greatest = greatest.max(direction.dot(&shape.position(eta, omega)));
                }
            }
            assert!(greatest <= support * (1.0 + 1e-14));
            // Half a grid step off the maximum, at the greatest curvature of the grid.
            assert!(greatest >= support * (1.0 - 1e-4), "{shape:?} {greatest} {support}");
        }
    }
}

#[test]
fn support_at_a_normal_is_attained_at_its_point() {
    for shape in shapes().filter(|shape| shape.exponents().iter().all(|&e| e < 2.0)) {
        for (eta, omega) in angles() {
            let normal = shape.normal(eta, omega);
            let attained = normal.dot(&shape.position(eta, omega));
            assert!((shape.support(&normal) / attained - 1.0).abs() < 1e-12);
        }
    }
}

/// JLS Table 2.1, in units of a1 a2 a3; exponent 0 is approached, the error being quadratic.
#[test]
fn volumes_of_jls_table_2_1() {
    const NEAR_ZERO: f64 = 1e-5;
    let table = [
        (NEAR_ZERO, [8.0, 16.0 / 3.0, 8.0 / 3.0]),
        (1.0, [2.0 * PI, 4.0 / 3.0 * PI, 2.0 / 3.0 * PI]),
        (2.0, [4.0, 8.0 / 3.0, 4.0 / 3.0]),
    ];
    for (e2, row) in table {
        for (e1, expected) in [NEAR_ZERO, 1.0, 2.0].into_iter().zip(row) {
            let shape = Superellipsoid::new([2.0, 0.5, 3.0], [e1, e2]).unwrap();
            assert!((shape.volume() / (3.0 * expected) - 1.0).abs() < 1e-9, "{e1} {e2}");
        }
    }
}

#[test]
fn volume_is_the_share_of_its_box_that_lies_inside() {
    for shape in shapes().filter(|shape| shape.size()[0] == 2.0) {
        let [a1, a2, a3] = shape.size();
        let n = 60;
        let at = |i: i32| (f64::from(i) + 0.5) / f64::from(n);
        let mut inside = 0;
        for i in 0..n {
            for j in 0..n {
                for k in 0..n {
                    let x = Vector3::new(a1 * at(i), a2 * at(j), a3 * at(k));
                    inside += i32::from(shape.gauge(&x) < 1.0);
                }
            }
        }
        let counted = 8.0 * a1 * a2 * a3 * f64::from(inside) / f64::from(n.pow(3));
        // A plane face may fall on either side of the midpoints of half a layer of cells.
        assert!((counted / shape.volume() - 1.0).abs() < 1.5 / f64::from(n), "{shape:?}");
    }
}

#[test]
fn parameters_outside_their_domain_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Superellipsoid::new([1.0, bad, 1.0], [1.0, 1.0]).is_err());
        assert!(Superellipsoid::new([1.0, 1.0, 1.0], [1.0, bad]).is_err());
    }
}
