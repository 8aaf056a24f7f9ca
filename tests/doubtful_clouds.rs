//! Clouds that determine no solid: a named error, or a fit that says why it is not trusted.

mod common;

use common::{Scene, point_cloud};
use superquadric::recover::{Doubt, FitError, FitOptions, fit};

fn attempt(points: &[[f64; 3]]) -> Result<superquadric::recover::Fit, FitError> {
    fit(&point_cloud(points), &FitOptions::default())
}

#[test]
fn too_few_points() {
    for count in 0..11 {
        let points: Vec<[f64; 3]> = (0..count).map(|i| [f64::from(i), 1.0, 2.0]).collect();
        let error = attempt(&points).unwrap_err();
        assert_eq!(error, FitError::TooFewPoints { found: points.len(), needed: 11 });
    }
}

#[test]
fn coincident_points_at_any_scale() {
    for place in [[0.0; 3], [1e-9, 2e-9, 3e-9], [1e6, -1e6, 5.0]] {
        let error = attempt(&vec![place; 50]).unwrap_err();
        assert!(matches!(error, FitError::Coincident { .. }), "{place:?}: {error}");
    }
    // One step of the coordinates' rounding apart is not apart.
    let mut points = vec![[1e6, 0.0, 0.0]; 50];
    points[0][0] = 1e6 + 1.2e-10;
    assert!(matches!(attempt(&points).unwrap_err(), FitError::Coincident { .. }));
}

#[test]
fn collinear_points_in_any_direction() {
    for direction in [[1.0, 0.0, 0.0], [1.0, -2.0, 0.5]] {
        let points: Vec<[f64; 3]> =
            (0..100).map(|i| direction.map(|d| 3.0 + d * f64::from(i))).collect();
        assert_eq!(attempt(&points).unwrap_err(), FitError::Collinear);
    }
}

#[test]
fn coplanar_points_are_fitted_but_not_trusted() {
    let mut scene = Scene::new(1);
    let rotation = scene.rotation();
    let points: Vec<[f64; 3]> = (0..200)
        .map(|_| {
            let [x, y] = [scene.uniform(-1.0, 1.0), scene.uniform(-2.0, 2.0)];
            (rotation * nalgebra::Vector3::new(x, y, 0.0)).into()
        })
        .collect();
    let fit = attempt(&points).unwrap();
    assert!(!fit.is_trusted());
    assert!(fit.doubts.contains(&Doubt::Flat), "{:?}", fit.doubts);
}

#[test]
fn points_that_fill_a_volume_are_not_trusted() {
    let mut scene = Scene::new(2);
    let points: Vec<[f64; 3]> = (0..2000).map(|_| scene.normal_vector().into()).collect();
    let fit = attempt(&points).unwrap();
    assert!(matches!(fit.doubts[..], [Doubt::PoorFit { .. }, ..]), "{:?}", fit.doubts);
}

#[test]
fn as_few_points_as_parameters_are_not_trusted() {
    let mut scene = Scene::new(3);
    let truth = scene.random_model();
    let fit = attempt(&scene.cloud(&truth, 11, 0.01)).unwrap();
    assert!(!fit.is_trusted());
}

#[test]
fn units_at_the_end_of_the_range_of_numbers_are_named_and_others_do() {
    let mut scene = Scene::new(4);
    let truth = scene.random_model();
    let points = scene.cloud(&truth, 300, 0.0);
    let scaled = |unit: f64| -> Vec<[f64; 3]> {
        points.iter().map(|point| point.map(|coordinate| coordinate * unit)).collect()
    };
    for unit in [1e150, 1e-150] {
        assert!(attempt(&scaled(unit)).unwrap().is_trusted());
    }
    for unit in [4e306, 1e-310] {
        let error = attempt(&scaled(unit)).unwrap_err();
        assert!(matches!(error, FitError::OutOfRange { .. }), "{unit:e}: {error}");
    }
}

#[test]
fn skipped_rows_are_counted() {
    let mut scene = Scene::new(5);
    let truth = scene.random_model();
    let mut points = scene.cloud(&truth, 500, 0.01);
    points.insert(17, [f64::NAN, 0.0, 0.0]);
    points.push([0.0, f64::INFINITY, 0.0]);
    let fit = attempt(&points).unwrap();
    assert_eq!((fit.points, fit.points_skipped), (500, 2));
}

/// One side of a cylinder capped by cones: not a superellipsoid, and seen in part. Independent
/// noise of the same size leaves no doubt about a shape that fits.
#[test]
fn residuals_that_err_together_cast_doubt_on_what_is_not_seen() {
    let mut scene = Scene::new(6);
    let spire: Vec<[f64; 3]> = (0..1500)
        .map(|_| {
            let [angle, height] =
                [scene.uniform(0.0, std::f64::consts::PI), scene.uniform(-2.0, 2.0)];
            let radius = (2.0 - height.abs()).min(1.0) * (1.0 + 0.1 * (3.0 * angle).sin());
            [radius * angle.cos(), radius * angle.sin(), height]
        })
        .collect();
    let fit = attempt(&spire).unwrap();
    let uncertain = |doubt: &Doubt| matches!(doubt, Doubt::UncertainSize { .. });
    assert!(fit.doubts.iter().any(uncertain), "{fit:?}");

    let noise = fit.rms_geometric;
    let truth = scene.place([1.0, 1.0, 2.0], [1.0, 1.0]);
    let fit = attempt(&scene.cloud(&truth, 1500, noise / truth.shape.mean_semi_axis())).unwrap();
    assert!(fit.is_trusted(), "{:?}", fit.doubts);
}
