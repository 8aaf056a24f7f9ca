use std::f64::consts::{FRAC_PI_2, PI};

use super::*;

/// Depth, as a share of the gauge, to which a touching line may enter: rounding of some hundred
/// operations.
const ROUNDING: f64 = 1e-13;

fn shapes() -> Vec<Superellipsoid> {
    let mut shapes = Vec::new();
    let exponents = [0.05, 0.1, 0.5, 1.0, 1.7, 1.95, 2.0];
    for size in [[1.0, 1.0, 1.0], [1.0, 2.0, 3.0], [1e-6, 1e-4, 2e-6], [3e3, 3e5, 1e4]] {
        for e1 in exponents {
            shapes.extend(exponents.map(|e2| Superellipsoid::new(size, [e1, e2]).unwrap()));
        }
    }
    shapes
}

fn directions() -> [Vector3<f64>; 8] {
    [
        Vector3::x(),
        -Vector3::y(),
        Vector3::z(),
        Vector3::new(0.3, -0.7, 0.0),
        Vector3::new(0.0, 1.0, 1e-9),
        Vector3::new(1.0, 1.0, 1.0),
        Vector3::new(-0.2, 0.5, 0.8),
        Vector3::new(1e-8, -0.4, -1.0),
    ]
}

/// The least gauge on the line of sight through a point: golden section, the gauge being convex.
fn least_gauge(shape: &Superellipsoid, viewpoint: &Viewpoint, x: &Vector3<f64>) -> f64 {
    let along = match viewpoint {
        Viewpoint::At(centre) => x - centre,
        Viewpoint::Along(direction) => *direction,
    };
    let size = Vector3::from(shape.size());
    let reach = 4.0 / along.component_div(&size).norm();
    let gauge = |t: f64| shape.gauge(&(x + t * along));
    let (mut low, mut high) = (-reach, reach);
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let mut least = gauge(0.0);
    for _ in 0..100 {
        let span = golden * (high - low);
        let (a, b) = (gauge(high - span), gauge(low + span));
        least = least.min(a).min(b);
        if a < b { high = low + span } else { low = high - span }
    }
    least
}

fn assert_touches(shape: &Superellipsoid, viewpoint: &Viewpoint, x: &Vector3<f64>) {
    let gauge = shape.gauge(x);
    assert!((gauge - 1.0).abs() < ROUNDING, "{shape:?} {viewpoint:?} {x:?} {gauge}");
    let least = least_gauge(shape, viewpoint, x);
    assert!(least > 1.0 - ROUNDING, "{shape:?} {viewpoint:?} {x:?} {}", 1.0 - least);
}

fn viewpoints(shape: &Superellipsoid) -> Vec<Viewpoint> {
    let size = Vector3::from(shape.size());
    let mut viewpoints = Vec::new();
    for direction in directions() {
        viewpoints.push(Viewpoint::Along(direction.component_mul(&size)));
        let surface = shape.radial_projection(&direction.component_mul(&size));
        viewpoints.extend([1.01, 3.0, 50.0].map(|far| Viewpoint::At(far * surface)));
    }
    viewpoints
}

#[test]
fn lines_of_sight_touch_at_the_rim_and_do_not_enter() {
    for shape in shapes() {
        for viewpoint in viewpoints(&shape) {
            let tangents = Tangents::new(&shape, &viewpoint).unwrap();
            for i in 0..12 {
                assert_touches(&shape, &viewpoint, &tangents.point(0.1 + 0.5 * f64::from(i)));
            }
        }
    }
}

#[test]
fn the_closed_form_lies_on_the_rim_and_is_the_solved_one() {
    for shape in shapes() {
        if shape.exponents().contains(&2.0) {
            continue;
        }
        let size = Vector3::from(shape.size());
        for direction in directions().into_iter().filter(|direction| direction.z != 0.0) {
            let view = direction.component_mul(&size);
            for i in -8..8 {
                let x = orthographic_rim_point(&shape, &view, 0.2 + 0.4 * f64::from(i));
                assert_touches(&shape, &Viewpoint::Along(view), &x);
            }
        }
    }
    let ellipsoid = Superellipsoid::new([1.0, 2.0, 3.0], [1.0, 1.0]).unwrap();
    let view = Vector3::new(1.0, -2.0, 0.5);
    for x in rim(&ellipsoid, &Viewpoint::Along(view), 50).unwrap() {
        let omega = (x.y / 2.0).atan2(x.x);
        assert!((orthographic_rim_point(&ellipsoid, &view, omega) - x).norm() < 1e-13);
    }
}

#[test]
fn seen_from_the_side_the_rim_is_two_meridians() {
    for shape in shapes() {
        if shape.exponents().contains(&2.0) {
            continue;
        }
        let size = Vector3::from(shape.size());
        for direction in directions().into_iter().filter(|direction| direction.z == 0.0) {
            let view = direction.component_mul(&size);
            for omega in orthographic_rim_meridians(&shape, &view) {
                for eta in [-FRAC_PI_2, -1.0, 0.0, 0.3, 1.5] {
                    assert_touches(&shape, &Viewpoint::Along(view), &shape.position(eta, omega));
                }
            }
        }
    }
    let sphere = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
    assert_eq!(orthographic_rim_meridians(&sphere, &Vector3::y()), [PI, 0.0]);
}

#[test]
fn the_rim_of_a_sphere_is_the_circle_of_euclid() {
    let sphere = Superellipsoid::new([2.0; 3], [1.0; 2]).unwrap();
    let centre = Vector3::new(1.0, -4.0, 5.0);
    for x in rim(&sphere, &Viewpoint::At(centre), 100).unwrap() {
        assert!((x.norm() - 2.0).abs() < 1e-14);
        // The foot of the circle's plane is at r^2 / |c| from the centre.
        assert!((x.dot(&centre) - 4.0).abs() < 1e-13);
    }
}

#[test]
fn points_go_evenly_once_around() {
    for shape in shapes().into_iter().step_by(7) {
        for viewpoint in viewpoints(&shape).into_iter().step_by(3) {
            let points = rim(&shape, &viewpoint, 200).unwrap();
            assert_eq!(points.len(), 200);
            let chords = (0..200).map(|i| (points[(i + 1) % 200] - points[i]).norm());
            let chords: Vec<f64> = chords.collect();
            let mean = chords.iter().sum::<f64>() / 200.0;
            let greatest = chords.iter().copied().fold(0.0, f64::max);
            assert!(greatest < 1.3 * mean, "{shape:?} {viewpoint:?} {greatest} {mean}");
        }
    }
}

#[test]
fn views_without_a_rim_are_refused() {
    let shape = Superellipsoid::new([1.0; 3], [0.1, 1.0]).unwrap();
    let refusal = |shape: &Superellipsoid, viewpoint| rim(shape, &viewpoint, 9).unwrap_err();
    for inside in [Vector3::zeros(), Vector3::x(), Vector3::new(0.5, 0.5, 0.99)] {
        assert_eq!(refusal(&shape, Viewpoint::At(inside)), RimError::Inside);
    }
    for direction in [Vector3::zeros(), Vector3::new(f64::NAN, 0.0, 1.0)] {
        assert_eq!(refusal(&shape, Viewpoint::Along(direction)), RimError::Viewpoint);
    }
    let star = Superellipsoid::new([1.0; 3], [1.0, 2.5]).unwrap();
    assert_eq!(refusal(&star, Viewpoint::Along(Vector3::z())), RimError::NotConvex(2.5));
}
