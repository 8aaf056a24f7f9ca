//! A deformed shape is a shape like any other.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;

use super::*;
use crate::deform::{Bend, Deformation, Line, Polyline, Spline, Taper, Twist};

fn line(at_zero: f64, slope: f64) -> Line {
    Line::new(at_zero, slope).unwrap()
}

fn quarter_bend() -> Deformation {
    Deformation::new(Bend::new(FRAC_PI_2 / 2.0, 0.0, [-1.0, 1.0]).unwrap())
}

fn chains() -> Vec<Chain> {
    let taper = || Deformation::new(Taper::new(line(1.0, -0.3)));
    let twist = || Deformation::new(Twist::new(line(0.0, 1.2)));
    let outside =
        Deformation::about(Twist::new(line(0.0, 0.5)), Vector3::new(3.0, 0.0, 0.0), Vector3::z());
    let kinked = Polyline::new(vec![[-0.5, 1.2], [0.2, 0.7]]).unwrap();
    vec![
        Chain::default(),
        Chain::new([taper()]),
        Chain::new([twist()]),
        Chain::new([outside.unwrap()]),
        Chain::new([quarter_bend()]),
        Chain::new([Deformation::new(Taper::new(kinked))]),
        Chain::new([taper(), twist(), quarter_bend()]),
    ]
}

/// Every chain on a box, an ellipsoid, a near cylinder and an octahedron.
fn solids() -> Vec<Deformed> {
    let shape = |exponents| Superellipsoid::new([0.8, 1.8, 0.6], exponents).unwrap();
    let shapes = [[0.1, 0.1], [1.0, 1.0], [0.2, 1.0], [2.0, 2.0]].map(shape);
    let all = chains().into_iter().flat_map(|chain| {
        shapes.map(|shape| Deformed::new(shape, chain.clone()).expect("a shape of the domain"))
    });
    all.collect()
}

fn angles() -> impl Iterator<Item = (f64, f64)> {
    [-1.4, -0.6, 0.1, 0.8]
        .into_iter()
        .flat_map(|eta| [-2.9, -1.0, 0.4, 2.2].map(|omega| (eta, omega)))
}

#[test]
fn surface_points_are_on_the_surface_and_normals_lead_outside() {
    for solid in solids() {
        let e = solid.shape().exponents()[0];
        for (eta, omega) in angles() {
            let x = solid.position(eta, omega);
            let n = solid.normal(eta, omega);
            assert!((solid.inside_outside(&x) - 1.0).abs() < 1e-12 / e);
            assert!((solid.level([x.x, x.y, x.z]) - 1.0).abs() < 1e-12);
            assert!((n.norm() - 1.0).abs() < 1e-12);
            assert!(!solid.contains(&(x + 1e-6 * n)), "{solid:?}");
            assert!(solid.contains(&(x - 1e-6 * n)), "{solid:?}");
        }
    }
}

#[test]
fn the_gradient_is_its_difference_quotient_and_along_the_normal() {
    for solid in solids().iter().filter(|solid| solid.shape().exponents()[0] == 1.0) {
        for (eta, omega) in angles() {
            let x = solid.position(eta, omega);
            let gradient = solid.inside_outside_gradient(&x);
            let h = 1e-6;
            let quotient = Vector3::from_fn(|i, _| {
                let step = Vector3::ith(i, h);
                (solid.inside_outside(&(x + step)) - solid.inside_outside(&(x - step))) / (2.0 * h)
            });
            // Rounding over the step.
            assert!((gradient - quotient).norm() < 1e-8 * gradient.norm(), "{solid:?}");
            assert!((gradient.normalize() - solid.normal(eta, omega)).norm() < 1e-12);
        }
    }
}

/// Surface points on a grid that is even in the shape's directions.
fn surface_points(solid: &Deformed) -> Vec<Vector3<f64>> {
    let mut points = Vec::new();
    for i in 0..=60 {
        for j in 0..120 {
            let (eta, omega) =
                (f64::from(i) * PI / 60.0 - FRAC_PI_2, f64::from(j) * PI / 60.0 - PI);
            points.push(solid.position(eta, omega));
        }
    }
    points
}

#[test]
fn bounding_boxes_hold_the_surface_and_are_tight() {
    for solid in solids() {
        let [min, max] = solid.bounding_box();
        let points = surface_points(&solid);
        for axis in 0..3 {
            let least = points.iter().map(|x| x[axis]).fold(f64::INFINITY, f64::min);
            let greatest = points.iter().map(|x| x[axis]).fold(f64::NEG_INFINITY, f64::max);
            let extent = greatest - least;
            let (below, above) = (least - min[axis], max[axis] - greatest);
            assert!(below >= -1e-12 && above >= -1e-12, "{solid:?} {axis}");
            // The bound's looseness, and what the grid has missed.
            assert!(
                below < 0.03 * extent && above < 0.03 * extent,
                "{solid:?} {axis} {below} {above} {extent}"
            );
        }
    }
}

#[test]
fn a_shape_that_a_deformation_folds_is_refused() {
    let shape = Superellipsoid::new([1.0, 1.0, 1.0], [0.1, 1.0]).unwrap();
    let fold = |deformation| Deformed::new(shape, Chain::new([deformation])).unwrap_err();
    let taper = fold(Deformation::new(Taper::new(line(1.0, -1.2))));
    assert!(matches!(taper, DeformError::TaperFolds { .. }));
    let bend = fold(Deformation::new(Bend::new(1.1, 0.0, [-1.0, 1.0]).unwrap()));
    assert!(matches!(bend, DeformError::BendFolds { .. }));
    let meeting =
        fold(Deformation::new(Bend::new(0.9 * 20.0 * PI / 9.0, 0.0, [-0.45, 0.45]).unwrap()));
    assert!(matches!(meeting, DeformError::BendFolds { .. } | DeformError::BendMeets { .. }));
    // A taper that would fold beyond the shape does not matter.
    let before = Deformation::new(Taper::new(line(1.0, -0.9)));
    assert!(Deformed::new(shape, Chain::new([before])).is_ok());
}

#[test]
fn a_moebius_band_is_a_twist_by_half_a_turn_and_a_bend_by_a_whole_one() {
    // B84 Fig. 2.4.3, the band's ends meeting.
    let band = Superellipsoid::new([0.6, PI, 0.05], [0.2, 0.2]).unwrap();
    let along_y = Vector3::y();
    let half_turn = Spline::new(vec![[-PI, -FRAC_PI_2], [PI, FRAC_PI_2]]).unwrap();
    let twist = Deformation::about(Twist::new(half_turn), Vector3::zeros(), along_y).unwrap();
    let bend = Deformation::new(Bend::new(1.0, 0.0, [-PI, PI]).unwrap());
    let band = Deformed::new(band, Chain::new([twist, bend])).unwrap();
    let volume = band.mass_estimate(1e-6).properties.volume();
    // The volume changes by 1 - k z alone, whose mean is 1 across the symmetric band.
    assert!((volume / band.shape().volume() - 1.0).abs() < 1e-6);
}
