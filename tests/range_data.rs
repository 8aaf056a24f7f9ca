//! Real range cameras: one side, a table, free space beside the object.

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use common::{iou, shared};
use nalgebra::{Rotation3, Vector3};
use png::{BitDepth, ColorType, Encoder};
use superquadric::cloud::read;
use superquadric::model::Model;
use superquadric::pose::Pose;
use superquadric::recover::{Constraints, Doubt, Fit, FitOptions, Sight, fit};
use superquadric::shape::Superellipsoid;
use superquadric::view::{Camera, DepthMap, Mask, find_plane, points_above};
use tempfile::TempDir;

/// Allowance for each full extent.
const ABSOLUTE: f64 = 0.007;
const RELATIVE: f64 = 0.07;

/// Full extents in metres, ascending: as published, and as a scan or our own measure has them.
const SUGAR_BOX: [[f64; 3]; 2] = [[0.038, 0.089, 0.175], [0.045, 0.092, 0.176]];
const PEPPER_CAN: [[f64; 3]; 2] = [[0.0474, 0.0474, 0.0922], [0.0474, 0.0474, 0.0922]];

fn extents(fit: &Fit) -> [f64; 3] {
    let mut extents = fit.model.shape.size().map(|a| 2.0 * a);
    extents.sort_by(f64::total_cmp);
    extents
}

fn is_right(extents: [f64; 3], known: [[f64; 3]; 2]) -> bool {
    (0..3).all(|k| {
        known.iter().any(|known| {
            let error = (extents[k] - known[k]).abs();
            error <= ABSOLUTE || error <= RELATIVE * known[k]
        })
    })
}

/// The depth map of an object with a mask.
fn depth_map(folder: &Path, object: &str, mask: &Path) -> DepthMap {
    let camera = Camera::read(folder.join("intrinsics.json")).unwrap();
    let path = folder.join(format!("{object}_depth.png"));
    DepthMap::read(path, camera, Some(mask), None).unwrap()
}

/// The fit that the camera's geometry and the table allow.
fn fit_on_table(map: &DepthMap) -> Fit {
    let table = find_plane(&map.surroundings(), [0.0; 3], 0).expect("a table");
    let points = points_above(&map.inner_points(), &table, [0.0; 3]);
    let sight = Some(map.sight());
    fit(&points, &FitOptions { sight, support: Some(table), ..FitOptions::default() }).unwrap()
}

#[test]
fn sugar_box_and_pepper_can_are_measured_from_one_view_on_the_table() {
    let Some(folder) = shared("data/rgbd") else { return };
    for (object, known) in [("sugar", SUGAR_BOX), ("pepper", PEPPER_CAN)] {
        let mask = folder.join(format!("{object}_mask.png"));
        let map = depth_map(&folder, object, &mask);
        let found = extents(&fit_on_table(&map));
        assert!(is_right(found, known), "{object}: {found:?}");
        // Without what the camera knows besides its points nothing is claimed.
        let alone = fit(&map.inner_points(), &FitOptions::default()).unwrap();
        assert!(is_right(extents(&alone), known) || !alone.is_trusted(), "{object}");
        let is_unseen = |doubt: &Doubt| matches!(doubt, Doubt::UncertainSize { .. });
        assert!(alone.doubts.iter().any(is_unseen), "{object}: {:?}", alone.doubts);
    }
}

/// A mask whose outline is moved by so many pixels, outwards where positive.
fn moved_mask(mask: &Path, by: i64, folder: &TempDir) -> PathBuf {
    let mask = Mask::read(mask).unwrap();
    let [width, height] = mask.size().map(i64::from);
    let is_object = |x: i64, y: i64| {
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        is_inside && mask.is_object()[(y * width + x) as usize]
    };
    let reach = by.abs();
    let of_pixel = |pixel: i64| {
        let (x, y) = (pixel % width, pixel / width);
        let mut around = (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy)));
        let is_kept = if by > 0 {
            around.any(|(dx, dy)| is_object(x + dx, y + dy))
        } else {
            around.all(|(dx, dy)| is_object(x + dx, y + dy))
        };
        if is_kept { 255 } else { 0 }
    };
    let pixels: Vec<u8> = (0..width * height).map(of_pixel).collect();
    let path = folder.path().join(format!("mask{by}.png"));
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width as u32, height as u32);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    fs::write(&path, bytes).unwrap();
    path
}

#[test]
fn a_mask_may_be_two_pixels_off() {
    let Some(folder) = shared("data/rgbd") else { return };
    let scratch = TempDir::new().unwrap();
    for (object, known) in [("sugar", SUGAR_BOX), ("pepper", PEPPER_CAN)] {
        for by in [-2, 2] {
            let mask = moved_mask(&folder.join(format!("{object}_mask.png")), by, &scratch);
            let found = extents(&fit_on_table(&depth_map(&folder, object, &mask)));
            println!("{object} {by} {found:?}");
            assert!(is_right(found, known), "{object} by {by}: {found:?}");
        }
    }
}

/// What a single view does not show is said: extents that are off by more than a tenth are among
/// those called uncertain.
#[test]
fn extents_of_single_views_that_are_wrong_are_called_uncertain() {
    let Some(folder) = shared("data/single-view") else { return };
    for (file, published, scan) in [
        ("6dof_sugar_rawframe.ply", [0.038, 0.089, 0.175], [0.045, 0.092, 0.176]),
        ("6dof_pepper_rawframe.ply", [0.0474, 0.0474, 0.0922], [0.0474, 0.0474, 0.0922]),
        ("posecnn_f2_004_sugar_box.ply", [0.038, 0.089, 0.175], [0.045, 0.092, 0.176]),
        ("posecnn_f2_021_bleach_cleanser.ply", [0.065, 0.098, 0.250], [0.0675, 0.0982, 0.2537]),
        ("posecnn_f3_005_tomato_soup_can.ply", [0.066, 0.066, 0.101], [0.067, 0.067, 0.1016]),
        ("posecnn_f5_003_cracker_box.ply", [0.060, 0.158, 0.210], [0.0713, 0.1635, 0.2136]),
    ] {
        let cloud = read(&folder.join(file)).unwrap();
        let sight = Some(Sight::from_viewpoint([0.0; 3]));
        let found = fit(&cloud, &FitOptions { sight, ..FitOptions::default() }).unwrap();
        let mut axes = [0, 1, 2];
        let size = found.model.shape.size();
        axes.sort_by(|&i, &j| size[i].total_cmp(&size[j]));
        for (rank, axis) in axes.into_iter().enumerate() {
            let extent = 2.0 * size[axis];
            let error = [published, scan].map(|known| (extent / known[rank] - 1.0).abs());
            let is_called_uncertain = found.doubts.iter().any(
                |doubt| matches!(doubt, Doubt::UncertainSize { axis: named, .. } if *named == axis),
            );
            assert!(error[0].min(error[1]) <= 0.1 || is_called_uncertain, "{file} {extent}");
        }
    }
}

/// One ball in scans with its stand and background; in the last the stand reaches up to it.
#[test]
fn a_ball_before_its_stand_has_its_radius() {
    let Some(folder) = shared("data/lidar-ball") else { return };
    let options = FitOptions { constraints: Constraints::sphere(), ..FitOptions::default() };
    for scan in ["S1", "S2", "S3", "S4"] {
        let path = folder.join(format!("spherecalib_ex3_L1_{scan}_crop450.ply"));
        let found = fit(&read(&path).unwrap(), &options).unwrap();
        let [radius, ..] = found.model.shape.size();
        assert!((0.28..=0.31).contains(&radius), "{scan}: {radius}");
        assert!(found.is_trusted() && found.stray_share > 0.0, "{scan}: {:?}", found.doubts);
        let spread = found.covariance.half_intervals()[0];
        assert!((0.3 - radius).abs() <= 2.0 * spread && spread < 0.03, "{scan}: {spread}");
    }
}

/// The published example whose parameters are known: its width and its height, and that its length
/// is not, since one of its ends is not seen. Three strays in the plane of that end do not make it one.
#[test]
fn the_seen_part_of_the_published_noisy_example_is_recovered() {
    let Some(folder) = shared("data/ems") else { return };
    let cloud = read(&folder.join("noisy_pointCloud_example_1.ply")).unwrap();
    let found = fit(&cloud, &FitOptions::default()).unwrap();
    let rotation = Rotation3::from_euler_angles(0.3712, 2.6031, 2.1758);
    let shape = Superellipsoid::new([0.6506, 1.4863, 1.8478], [0.1108, 0.2786]).unwrap();
    let truth = Model { shape, pose: Pose::new(rotation, Vector3::new(-0.0551, -0.0617, 0.0120)) };
    assert!(iou(&truth, &found.model) > 0.85);
    let [a1, a2, a3] = found.model.shape.size();
    assert!((a1 / 1.4863 - 1.0).abs() < 0.01 && (a2 / 0.6506 - 1.0).abs() < 0.01);
    let error = found.covariance.standard_errors()[2];
    assert!(1.8478 - a3 < 3.0 * error, "{a3} {error}");
}
