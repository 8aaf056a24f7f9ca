//! Fits in single precision against those in double precision: nothing is lost beside the noise.

mod common;

use std::process::Command;

use common::{Scene, iou, one_sided_view, point_cloud};
use serde_json::Value;
use superquadric::model::Model;
use superquadric::recover::{Distance, Fit, FitOptions, Precision, fit};

const SAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/samples/one_sided_view.ply");

/// Share of a standard error by which parameters may differ, and of what the overlap lacks to one.
const SHARE: f64 = 0.05;

const CLOUDS: u64 = 50;

/// The fits of some points in single and in double precision.
fn fits(points: &[[f64; 3]]) -> [Fit; 2] {
    [Precision::Single, Precision::Double].map(|precision| {
        fit(&point_cloud(points), &FitOptions { precision, ..FitOptions::default() }).unwrap()
    })
}

/// Semi-axes, exponents and centre, in the order of the covariance without the rotation.
fn parameters(model: &Model) -> [f64; 8] {
    let ([a1, a2, a3], [e1, e2]) = (model.shape.size(), model.shape.exponents());
    let centre = model.pose.translation();
    [a1, a2, a3, e1, e2, centre.x, centre.y, centre.z]
}

fn assert_within_a_share_of_the_standard_errors([single, double]: &[Fit; 2]) {
    let errors = double.covariance.standard_errors();
    let errors = errors[..5].iter().chain(&errors[8..]);
    let pairs = parameters(&single.model).into_iter().zip(parameters(&double.model));
    for ((a, b), error) in pairs.zip(errors) {
        assert!((a - b).abs() < SHARE * error, "{a} {b} of {:?}, +- {error}", double.model);
    }
}

fn assert_nothing_is_lost(cloud: impl Fn(&mut Scene, &Model) -> Vec<[f64; 3]>) {
    for seed in 0..CLOUDS {
        let mut scene = Scene::new(seed);
        let truth = scene.random_model();
        let fits = fits(&cloud(&mut scene, &truth));
        assert_within_a_share_of_the_standard_errors(&fits);
        let overlaps = [0, 1].map(|k| iou(&fits[k].model, &truth));
        let bound = f64::max(1e-3, SHARE * (1.0 - overlaps[1]));
        assert!((overlaps[0] - overlaps[1]).abs() < bound, "cloud {seed}: {overlaps:?}");
        assert_eq!(fits[0].is_trusted(), fits[1].is_trusted(), "cloud {seed}");
    }
}

#[test]
fn complete_noisy_clouds_lose_nothing() {
    assert_nothing_is_lost(|scene, truth| scene.cloud(truth, 1_000, 0.01));
}

#[test]
fn noisy_views_lose_nothing() {
    assert_nothing_is_lost(|scene, truth| one_sided_view(scene, truth, 1_000, 0.01));
}

/// Standard errors are a thousandth of the noise.
#[test]
fn many_points_lose_nothing() {
    for seed in 0..3 {
        let mut scene = Scene::new(seed);
        let truth = scene.random_model();
        assert_within_a_share_of_the_standard_errors(&fits(&scene.cloud(&truth, 500_000, 0.01)));
    }
}

/// Millimetres, ten kilometres off: floats would not tell the points apart.
#[test]
fn clouds_far_from_the_origin_lose_nothing() {
    for seed in 0..5 {
        let mut scene = Scene::new(seed);
        let truth = scene.random_model();
        let mut points = scene.cloud(&truth, 1_000, 0.01);
        points.iter_mut().flatten().for_each(|coordinate| *coordinate = 1e-3 * *coordinate + 1e4);
        assert_within_a_share_of_the_standard_errors(&fits(&points));
    }
}

#[test]
fn clouds_without_noise_are_met_to_single_precision() {
    for seed in 0..20 {
        let mut scene = Scene::new(seed);
        let truth = scene.random_model();
        let cloud = point_cloud(&scene.cloud(&truth, 1_000, 0.0));
        for distance in [Distance::Radial, Distance::Geometric] {
            let precision = Precision::Single;
            let found =
                fit(&cloud, &FitOptions { distance, precision, ..FitOptions::default() }).unwrap();
            assert!(found.is_trusted(), "{seed}: {:?}", found.doubts);
            assert!(found.relative_rms() < 2e-7, "{seed}: {}", found.relative_rms());
            let overlap = iou(&found.model, &truth);
            assert!(overlap > 1.0 - 1e-6, "{seed}: {overlap}");
        }
    }
}

#[test]
fn the_program_fits_in_the_precision_that_is_asked_for() {
    let size_and_rms = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_superquadric"));
        let output = command.args(["fit", SAMPLE, "-o", "-"]).args(arguments).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let fit: Value = serde_json::from_slice(&output.stdout).unwrap();
        let [size, rms] = [&fit["model"]["shape"]["size"][0], &fit["fit"]["rms_geometric"]];
        [size, rms].map(|number| number.as_f64().unwrap())
    };
    let double = size_and_rms(&["--precision", "double"]);
    let single = size_and_rms(&["--precision", "single"]);
    assert_eq!(size_and_rms(&[]), double);
    // The last step may be the same, but not what it leaves.
    assert!((single[0] / double[0] - 1.0).abs() < 1e-4, "{single:?} {double:?}");
    assert!(single[1] != double[1], "{single:?}");
    assert!((single[1] / double[1] - 1.0).abs() < 1e-6, "{single:?} {double:?}");
}
