//! Noise along the rays of a range camera, whose errors across them are none: it must not draw shapes
//! to one side.

mod common;

use common::{Scene, iou, median, one_sided_view_from, point_cloud, with_range_noise};
use superquadric::model::Model;
use superquadric::recover::{Fit, FitOptions, Sight, fit};

const VIEWS: u64 = 100;
const POINTS: usize = 2_000;

/// Standard deviation of the noise, in mean semi-axes.
const NOISE: f64 = 0.02;

fn fits(options: impl Fn([f64; 3]) -> FitOptions) -> Vec<(Model, Fit)> {
    let view = |seed| {
        let mut scene = Scene::new(80_000 + seed);
        let truth = scene.random_model();
        let (points, camera_world) = one_sided_view_from(&mut scene, &truth, POINTS, 0.0);
        let deviation = NOISE * truth.shape.mean_semi_axis();
        let points = with_range_noise(&mut scene, &points, camera_world, deviation);
        (truth, fit(&point_cloud(&points), &options(camera_world)).unwrap())
    };
    (0..VIEWS).map(view).collect()
}

/// Share of the shapes that are right, and medians of the logarithms of their volumes and of the noise
/// along the rays, each as a ratio to the true one.
fn summary(fits: &[(Model, Fit)]) -> [f64; 3] {
    let right = fits.iter().filter(|(truth, fit)| iou(truth, &fit.model) >= 0.9).count();
    let ratio =
        |(truth, fit): &(Model, Fit)| (fit.model.shape.volume() / truth.shape.volume()).ln();
    let ratios: Vec<f64> = fits.iter().map(ratio).collect();
    let along = |(truth, fit): &(Model, Fit)| {
        Some((fit.range_noise?.along / (NOISE * truth.shape.mean_semi_axis())).ln())
    };
    let noise: Vec<f64> = fits.iter().filter_map(along).collect();
    assert!(noise.len() * 10 >= fits.len() * 9, "{} tell their noise", noise.len());
    let summary = [right as f64 / fits.len() as f64, median(&ratios), median(&noise)];
    println!("right, volume, noise: {summary:?}");
    summary
}

#[test]
fn shapes_have_their_size_from_the_points_alone() {
    let [right, volume, noise] = summary(&fits(|_| FitOptions::default()));
    assert!(right >= 0.95 && volume.abs() < 0.01, "{right} {volume}");
    // The direction is rough: some of the noise along the rays seems to be across them.
    assert!(noise.abs() < 0.3, "{noise}");
}

#[test]
fn shapes_have_their_size_where_the_viewpoint_is_told() {
    let told = |camera_world| FitOptions {
        sight: Some(Sight::from_viewpoint(camera_world)),
        ..FitOptions::default()
    };
    let [right, volume, noise] = summary(&fits(told));
    assert!(right >= 0.95 && volume.abs() < 0.01, "{right} {volume}");
    // None across counts as a fifth of that along, which then seems the less.
    assert!(noise.abs() < 0.08, "{noise}");
}
