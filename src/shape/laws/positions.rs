//! Where surface, inside, outside, box and dual are.

use nalgebra::Vector3;

use super::*;

/// How much F may be off at a surface point whose coordinates are rounded.
fn rounding_of_f(shape: &Shape, x: &Vector3<f64>) -> f64 {
    1e-13 + 2e-14 * shape.inside_outside_gradient(x).component_mul(x).abs().sum()
}

#[test]
fn positions_have_inside_outside_one() {
    try_on_all(1000, |Example { shape, .. }| {
        let angles = angles(shape);
        for &[eta, omega] in &angles {
            let x = shape.position(eta, omega);
            let f = shape.inside_outside(&x);
            assert!((f - 1.0).abs() < rounding_of_f(shape, &x), "{shape:?} {eta} {omega} {f}");
        }
        angles.len()
    });
}

#[test]
fn nudging_along_the_normal_leads_outside_and_against_it_inside() {
    try_on_all(1000, |example| {
        let shape = &example.shape;
        if !example.is_at_most(1.5) {
            return 0;
        }
        let angles = angles(shape);
        for &[eta, omega] in &angles {
            let x = shape.position(eta, omega);
            let step = 1e-6 * example.least_size * shape.normal(eta, omega);
            let [outside, inside] = [x + step, x - step];
            assert!(shape.inside_outside(&outside) > 1.0, "{shape:?} {eta} {omega}");
            assert!(shape.inside_outside(&inside) < 1.0, "{shape:?} {eta} {omega}");
            assert!(shape.radial_distance(&outside) > 0.0, "{shape:?} {eta} {omega}");
            assert!(shape.radial_distance(&inside) < 0.0, "{shape:?} {eta} {omega}");
            assert!(!shape.contains(&outside));
        }
        angles.len()
    });
}

/// The point from which rays go to a surface point.
fn ray_origin(shape: &Shape, surface: &Vector3<f64>) -> Vector3<f64> {
    let Shape::Supertoroid(torus) = shape else { return Vector3::zeros() };
    let [a1, a2, _] = torus.size();
    let equator = Superellipsoid::new([a1, a2, 1.0], [1.0, torus.exponents()[1]]).unwrap();
    let outwards = Vector3::new(surface.x, surface.y, 0.0);
    equator.radial_projection(&outwards) * torus.ring()
}

#[test]
fn radial_distance_is_that_along_the_ray() {
    try_on_all(500, |Example { shape, .. }| {
        let angles = smooth_angles(shape);
        let side = if matches!(shape, Shape::SuperhyperboloidTwoSheets(_)) { -1.0 } else { 1.0 };
        for &[eta, omega] in &angles {
            let surface = shape.position(eta, omega);
            let origin = ray_origin(shape, &surface);
            for factor in [0.3, 0.9, 1.0, 1.1] {
                let x = origin + factor * (surface - origin);
                let expected = side * (factor - 1.0) * (surface - origin).norm();
                let bound = rounding_of_f(shape, &surface) * surface.norm();
                let found = shape.radial_distance(&x);
                assert!((found - expected).abs() < bound, "{shape:?} {found} {expected}");
            }
        }
        angles.len()
    });
}

#[test]
fn radial_distance_at_the_middle_is_finite_and_tells_the_side() {
    try_on_all(36, |Example { shape, .. }| {
        let distance = shape.radial_distance(&Vector3::zeros());
        let is_outside = shape.inside_outside(&Vector3::zeros()) > 1.0;
        assert!(distance.is_finite() && (distance > 0.0) == is_outside, "{shape:?}");
        1
    });
}

/// The dual, and the latitude, longitude and sign with which its position is the normal.
fn dual(shape: &Shape, [eta, omega]: [f64; 2]) -> (Shape, [f64; 2], f64) {
    match shape {
        Shape::Superellipsoid(s) => (s.dual().unwrap().into(), [eta, omega], 1.0),
        Shape::SuperhyperboloidOneSheet(s) => (s.dual().unwrap().into(), [-eta, omega], 1.0),
        Shape::SuperhyperboloidTwoSheets(s) => (s.dual().unwrap().into(), [-eta, -omega], -1.0),
        Shape::Supertoroid(s) => (s.dual().unwrap().into(), [eta, omega], 1.0),
        Shape::ThreeExponent(s) => (s.dual().unwrap().into(), [eta, omega], 1.0),
    }
}

#[test]
fn positions_of_the_dual_are_the_normals() {
    try_on_all(500, |example| {
        let shape = &example.shape;
        if !example.is_at_most(1.5) {
            return 0;
        }
        let angles = angles(shape);
        for &at in &angles {
            let (dual, [eta, omega], sign) = dual(shape, at);
            let along = sign * dual.position(eta, omega).normalize();
            let normal = shape.normal(at[0], at[1]);
            // Latitudes near a quarter turn are rounded by 1e-16 of a small cosine.
            assert!((along - normal).norm() < 1e-9, "{shape:?} {at:?} {along} {normal}");
        }
        angles.len()
    });
}

#[test]
fn the_dual_of_the_dual_is_the_shape_but_of_a_torus_and_of_unequal_exponents() {
    try_on_all(1, |example| {
        let shape = &example.shape;
        if !example.is_at_most(1.5) {
            return 0;
        }
        let again = dual(&dual(shape, [0.0; 2]).0, [0.0; 2]).0;
        match shape {
            Shape::Supertoroid(torus) => {
                let tube = Superellipsoid::new(torus.size(), torus.exponents()).unwrap();
                assert_same(&again, &tube.into());
            }
            Shape::ThreeExponent(solid) if example.exponents[0] != example.exponents[1] => {
                let Shape::ThreeExponent(again) = again else { panic!("{again:?}") };
                for (found, n) in again.exponents().into_iter().zip(solid.exponents()) {
                    assert!((found / n - 1.0).abs() < 1e-13);
                }
            }
            _ => assert_same(&again, shape),
        }
        1
    });
}

/// That two shapes have the same box and the same function.
fn assert_same(a: &Shape, b: &Shape) {
    assert_eq!(a.family(), b.family());
    let [box_a, box_b] = [a, b].map(|shape| shape.bounding_box()[1]);
    assert!((box_a - box_b).norm() < 1e-10 * box_b.norm(), "{a:?} {b:?}");
    let x = b.position(0.4, 0.3);
    assert!((a.inside_outside(&x) - 1.0).abs() < 1e-10, "{a:?} {b:?}");
}

/// Points of the boundary, the rim of a clip among them.
fn boundary(shape: &Shape) -> Vec<Vector3<f64>> {
    if let Shape::SuperhyperboloidTwoSheets(bowls) = shape {
        return rim(shape, bowls.clip());
    }
    let [[south, north], [west, east]] = shape.domain();
    let share = |i: usize, n: usize| i as f64 / n as f64;
    let mut points = Vec::new();
    for i in 0..=64 {
        for j in 0..=128 {
            let eta = south + share(i, 64) * (north - south);
            points.push(shape.position(eta, west + share(j, 128) * (east - west)));
        }
    }
    points
}

/// The rim of the bowl at `x = clip`, by bisection in half planes about the x axis.
fn rim(shape: &Shape, clip: f64) -> Vec<Vector3<f64>> {
    let on_ray = |i: usize| {
        let (sin, cos) = (std::f64::consts::PI * i as f64 / 128.0).sin_cos();
        let at = |r: f64| Vector3::new(clip * (1.0 - 1e-12), r * cos, r * sin);
        let (mut inside, mut outside) = (0.0, 1e3);
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if shape.contains(&at(middle)) { inside = middle } else { outside = middle }
        }
        let rim = at(inside);
        [rim, -rim]
    };
    (0..256).flat_map(on_ray).collect()
}

#[test]
fn support_is_the_greatest_projection_of_the_boundary() {
    let directions =
        [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 2.0, 3.0], [-0.3, 0.01, 0.5]];
    try_on_all(100, |Example { shape, .. }| {
        let points = boundary(shape);
        for direction in directions.map(Vector3::from) {
            let support = shape.support(&direction);
            let greatest =
                points.iter().map(|x| direction.dot(x)).fold(f64::NEG_INFINITY, f64::max);
            assert!(greatest <= support * (1.0 + 1e-10), "{shape:?} {direction} {greatest}");
            // Half a grid step off the greatest.
            assert!(greatest >= support * (1.0 - 4e-2), "{shape:?} {direction} {support}");
        }
        directions.len()
    });
}
