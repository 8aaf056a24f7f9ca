//! Scans of real objects with known sizes.

mod common;

use common::shared;
use superquadric::cloud::read;
use superquadric::recover::{Fit, FitOptions, fit};

/// Allowance for each full extent, of the published size or of the scan's: scans bulge at edges
/// and corners.
const ABSOLUTE: f64 = 0.005;
const RELATIVE: f64 = 0.05;

/// A can's lids are recessed.
const RECESSED: f64 = 0.008;

/// Full extents in metres, ascending: as published, and as the scan measures.
struct Object {
    file: &'static str,
    published: [f64; 3],
    scan: [f64; 3],
    /// The extent along the axis of a can.
    height: Option<usize>,
}

const OBJECTS: [Object; 5] = [
    Object {
        file: "003_cracker_box.xyz",
        published: [0.060, 0.158, 0.210],
        scan: [0.0713, 0.1635, 0.2136],
        height: None,
    },
    Object {
        file: "005_tomato_soup_can.xyz",
        published: [0.066, 0.066, 0.101],
        scan: [0.067, 0.067, 0.1016],
        height: Some(2),
    },
    Object {
        file: "007_tuna_fish_can.xyz",
        published: [0.033, 0.085, 0.085],
        scan: [0.0331, 0.0846, 0.0846],
        height: Some(0),
    },
    Object {
        file: "036_wood_block.xyz",
        published: [0.085, 0.085, 0.200],
        scan: [0.0885, 0.0894, 0.2059],
        height: None,
    },
    Object {
        file: "061_foam_brick.xyz",
        published: [0.050, 0.050, 0.075],
        scan: [0.0509, 0.0517, 0.0774],
        height: None,
    },
];

fn extents(fit: &Fit) -> [f64; 3] {
    let mut extents = fit.model.shape.size().map(|a| 2.0 * a);
    extents.sort_by(f64::total_cmp);
    extents
}

#[test]
fn scans_come_out_with_their_true_extents() {
    let Some(folder) = shared("data/ycb-scan") else { return };
    for object in OBJECTS {
        let cloud = read(&folder.join(object.file)).expect("a readable scan");
        let fit = fit(&cloud, &FitOptions::default()).expect("a cloud with an extent");
        let extents = extents(&fit);
        println!("{}: {extents:.4?}", object.file);
        for k in 0..3 {
            let absolute = if object.height == Some(k) { RECESSED } else { ABSOLUTE };
            let is_near = |truth: f64| (extents[k] - truth).abs() <= absolute.max(RELATIVE * truth);
            assert!(
                is_near(object.published[k]) || is_near(object.scan[k]),
                "{}: {extents:?}",
                object.file
            );
        }
        assert!(fit.is_trusted(), "{}: {:?}", object.file, fit.doubts);
    }
}
