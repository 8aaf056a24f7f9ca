//! Feet along rays against the gauge's own.

use nalgebra::{Matrix3, Vector3};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::super::*;
use super::{COUNTS, columns, random_points, view_of};
use crate::machine::InstructionSet;
use crate::machine::vectorized::run_by;
use crate::model::Model;
use crate::pose::Pose;
use crate::recover::normalization::Normalization;
use crate::recover::options::Precision;
use crate::shape::Superellipsoid;
use crate::surface::sample_surface;

/// Where a sensor is in the model's frame, near and far off.
const SENSORS: [([f64; 3], f64); 2] = [([4.0, -3.0, 2.0], 1.0), ([0.6, 0.0, 0.8], 0.0)];

/// The foot of a point in the model's frame by the gauge itself, as the pass defines it: the point on
/// its normal that takes the given one's place, and the factor.
fn scalar_foot(shape: &Superellipsoid, spread: &Spread, x: Vector3<f64>) -> (Vector3<f64>, f64) {
    let (sensor, nearness) = spread.sensor;
    let ray = (Vector3::from(sensor) - nearness * x).normalize();
    let spread = Matrix3::identity() * spread.across
        + ray * ray.transpose() * (spread.along - spread.across);
    let normal = |x: &Vector3<f64>| shape.gauge_gradient(x).normalize();
    let n = normal(&x);
    let distance = (shape.gauge(&x) - 1.0) / shape.gauge_gradient(&x).norm();
    let foot = x - spread * n * (distance / n.dot(&(spread * n)));
    let n = normal(&foot);
    (foot + n * n.dot(&(x - foot)), n.dot(&(spread * n)).sqrt().recip())
}

#[test]
fn every_path_has_the_feet_along_the_rays() {
    let shape = Superellipsoid::new([0.5, 1.0, 1.5], [0.4, 1.3]).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 0.8, -1.0], Vector3::new(0.1, 0.0, -0.2));
    for (sensor, count) in SENSORS.into_iter().flat_map(|s| COUNTS.iter().map(move |c| (s, *c))) {
        let spread = Spread { sensor, along: 1.4, across: 0.2 };
        // Feet are to first order: far from the surface they may lie anywhere, and amplify rounding.
        let points: Vec<[f64; 3]> = sample_surface(&shape, count, 7)
            .into_iter()
            .zip(random_points(&mut ChaCha8Rng::seed_from_u64(8), count))
            .map(|(x, noise)| pose.world_from_model(&(x + 0.01 * Vector3::from(noise))).into())
            .collect();
        let [x, y, z] = columns(&points);
        for (precision, tolerance) in [(Precision::Double, 1e-12), (Precision::Single, 1e-4)] {
            let view = view_of(shape, pose, Residual::Geometric).with_precision(precision);
            for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
                let points_of = FeetOf { view: &view, spread: &spread, points: [&x, &y, &z] };
                let feet = run_by(set, points_of);
                for (i, point) in points.iter().enumerate() {
                    let x_model = pose.model_from_world(&Vector3::from(*point));
                    let (expected, factor) = scalar_foot(&shape, &spread, x_model);
                    let foot = Vector3::from(feet.points.each_ref().map(|column| column[i]));
                    let error = (foot - expected).norm() + (feet.factors[i] / factor - 1.0).abs();
                    assert!(error < tolerance, "{set:?} {precision:?} at {point:?}: {error}");
                }
            }
        }
    }
}

/// Points moved along the rays by any length are farther from the surface by that length, however
/// obliquely they are seen, to second order; the geometric distance shortens by the cosine.
#[test]
fn what_is_moved_along_a_ray_is_as_far_as_it_was_moved() {
    let shape = Superellipsoid::new([0.5, 1.0, 1.5], [0.7, 1.2]).unwrap();
    let model = Model { shape, pose: Pose::identity() };
    let spread = Spread { sensor: ([0.0, 0.0, 1.0], 0.0), along: 1.0, across: 1e-6 };
    let view = ModelView::new(&Normalization::identity(), &model, Residual::Geometric);
    let (plain, along_rays) = (view.clone(), view.with_spread(spread));
    for (eta, omega) in [(1.3, 0.4), (0.7, 2.0), (0.3, -1.1)] {
        let (x, cosine) = (shape.position(eta, omega), shape.normal(eta, omega).z);
        for step in [1e-5, -1e-5] {
            let moved = x + Vector3::z() * step;
            let residual = |view: &ModelView| {
                gram(view, [&[moved.x], &[moved.y], &[moved.z]], None, false)
                    .residual_squares()
                    .sqrt()
            };
            assert!((residual(&along_rays) / step.abs() - 1.0).abs() < 1e-3, "{eta} {omega}");
            assert!((residual(&plain) / step.abs() - cosine).abs() < 1e-3 && cosine < 0.99);
        }
    }
}

#[test]
fn noise_alike_in_all_directions_leaves_the_geometric_rows() {
    let points = sample_surface(&Superellipsoid::new([0.52; 3], [1.0; 2]).unwrap(), 500, 9);
    let [x, y, z] = columns(&points.into_iter().map(Into::into).collect::<Vec<_>>());
    let shape = Superellipsoid::new([0.5; 3], [1.0; 2]).unwrap();
    let view = view_of(shape, Pose::identity(), Residual::Geometric);
    let alike = Spread { sensor: SENSORS[0], along: 1.0, across: 1.0 };
    let plain = gram(&view, [&x, &y, &z], None, false);
    let feet = gram(&view.with_spread(alike), [&x, &y, &z], None, false);
    for (a, b) in plain.matrix.iter().flatten().zip(feet.matrix.iter().flatten()) {
        assert!((a - b).abs() < 1e-10, "{a} {b}");
    }
}
