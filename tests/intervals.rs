//! Stated uncertainty against errors made, over many noisy clouds.

mod common;

use common::{Scene, one_sided_view, one_sided_view_from, point_cloud, with_range_noise};
use superquadric::model::Model;
use superquadric::recover::{Covariance, Fit, FitOptions, fit};

const CLOUDS: u64 = 500;

/// A model whose parameters no other vector stands for but for the order of x and y: neither
/// near a dual nor of revolution.
fn unambiguous_model(scene: &mut Scene) -> Model {
    loop {
        let size = scene.size(3.0);
        let exponents = [scene.uniform(0.3, 1.6), scene.uniform(0.3, 1.6)];
        let ratio = size[0].max(size[1]) / size[0].min(size[1]);
        if ratio > 1.2 && (exponents[0] - exponents[1]).abs() > 0.1 {
            return scene.place(size, exponents).canonical();
        }
    }
}

/// Whether the truth's semi-axes and centre lie in the stated 95 % regions.
fn covered(truth: &Model, fit: &Fit) -> [bool; 2] {
    let (found, known) = (fit.model.shape.size(), truth.shape.size());
    let size = [0, 1, 2].map(|k| found[k] - known[k]);
    let centre = fit.model.pose.translation() - truth.pose.translation();
    [
        Covariance::is_in_region(&fit.covariance.of_size(), size),
        Covariance::is_in_region(&fit.covariance.of_centre(), centre.into()),
    ]
}

fn assert_covered(name: &str, cloud: impl Fn(&mut Scene, &Model) -> Vec<[f64; 3]>) {
    let (mut of_size, mut of_centre) = (0, 0);
    for seed in 0..CLOUDS {
        let mut scene = Scene::new(50_000 + seed);
        let truth = unambiguous_model(&mut scene);
        let points = cloud(&mut scene, &truth);
        let fit = fit(&point_cloud(&points), &FitOptions::default()).unwrap();
        let [size, centre] = covered(&truth, &fit);
        of_size += u32::from(size);
        of_centre += u32::from(centre);
    }
    let [of_size, of_centre] = [of_size, of_centre].map(|n| f64::from(n) / CLOUDS as f64);
    println!("{name}: size {of_size}, centre {of_centre}");
    for share in [of_size, of_centre] {
        assert!((0.90..=0.98).contains(&share), "{name}: {of_size} {of_centre}");
    }
}

#[test]
fn regions_of_size_and_centre_cover_the_truth_for_whole_clouds() {
    assert_covered("whole", |scene, truth| scene.cloud(truth, 1_000, 0.01));
}

#[test]
fn regions_of_size_and_centre_cover_the_truth_for_single_views() {
    assert_covered("one side", |scene, truth| one_sided_view(scene, truth, 2_000, 0.01));
}

#[test]
fn regions_of_size_and_centre_cover_the_truth_for_views_with_noise_along_the_rays() {
    assert_covered("range noise", |scene, truth| {
        let (points, camera_world) = one_sided_view_from(scene, truth, 2_000, 0.003);
        with_range_noise(scene, &points, camera_world, 0.01 * truth.shape.mean_semi_axis())
    });
}
