//! Depth maps of real objects from one side: what such a view cannot show must not be trusted.

mod common;

use common::shared;
use superquadric::cloud::read;
use superquadric::recover::{FitOptions, fit};

/// Files, and the objects' full extents in metres, ascending.
const VIEWS: [(&str, [f64; 3]); 4] = [
    ("6dof_sugar_rawframe.ply", [0.038, 0.089, 0.175]),
    ("posecnn_f2_004_sugar_box.ply", [0.038, 0.089, 0.175]),
    ("posecnn_f3_005_tomato_soup_can.ply", [0.066, 0.066, 0.101]),
    ("posecnn_f5_003_cracker_box.ply", [0.060, 0.158, 0.210]),
];

/// Relative error of an extent from which on trust in it would be misplaced.
const GROSS: f64 = 0.25;

#[test]
fn a_view_that_misleads_is_not_trusted() {
    let Some(folder) = shared("data/single-view") else { return };
    for (file, truth) in VIEWS {
        let cloud = read(&folder.join(file)).expect("a readable view");
        let fit = fit(&cloud, &FitOptions::default()).expect("a cloud with an extent");
        let mut extents = fit.model.shape.size().map(|a| 2.0 * a);
        extents.sort_by(f64::total_cmp);
        let error = (0..3).map(|k| (extents[k] / truth[k] - 1.0).abs()).fold(0.0, f64::max);
        println!("{file}: {extents:.4?}, trusted {}", fit.is_trusted());
        assert!(error < GROSS || !fit.is_trusted(), "{file}: {extents:?} is trusted");
    }
}
