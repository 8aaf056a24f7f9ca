//! Outlines of solids with creases, and of smooth ones, after strong deformations, against rays.

mod common;

use common::silhouette::{HEIGHT, TOLERANCE, WIDTH, error, primitive};
use nalgebra::Vector3;
use rayon::prelude::*;
use superquadric::deform::{Bend, Deformation, Line, Taper, Twist};
use superquadric::pose::Pose;
use superquadric::shape::{
    Shape, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
    ThreeExponent,
};
use superquadric::solid::Tree;
use superquadric::view::{AnyCamera, Camera, Distortion, OrthographicCamera};

/// A taper and a twist along z and a bend about x, of these rates.
fn stages([taper, twist, bend]: [f64; 3]) -> [Deformation; 3] {
    let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
    [
        Deformation::new(Taper::new(line(1.0, taper))),
        Deformation::new(Twist::new(line(0.0, twist))),
        Deformation::new(Bend::new(bend, 0.0, [-3.0, 3.0]).unwrap()),
    ]
}

const RATES: [[f64; 3]; 2] = [[-0.4, 1.2, 0.25], [0.3, -1.6, 0.35]];

fn smooth() -> Vec<Shape> {
    let size = [1.0, 1.4, 0.7];
    vec![
        Superellipsoid::new(size, [0.6, 0.8]).unwrap().into(),
        Supertoroid::new([0.3, 0.4, 0.35], [1.0, 1.0], 2.5).unwrap().into(),
        Supertoroid::new([0.3, 0.4, 0.35], [0.5, 0.7], 2.5).unwrap().into(),
        ThreeExponent::new(size, [4.0, 2.0, 3.0]).unwrap().into(),
    ]
}

/// Bowls and towers with sharp caps, boxes that are sharp but for a hundredth, and a blade.
fn edged() -> Vec<Shape> {
    let size = [0.5, 0.6, 0.4];
    let block = [1.0, 1.4, 0.7];
    vec![
        SuperhyperboloidTwoSheets::new(size, [1.0, 1.0], 2.5).unwrap().into(),
        SuperhyperboloidTwoSheets::new(size, [0.5, 1.6], 1.6).unwrap().into(),
        SuperhyperboloidTwoSheets::new(size, [1.7, 0.3], 1.2).unwrap().into(),
        SuperhyperboloidOneSheet::new(size, [1.0, 1.0], 2.0).unwrap().into(),
        SuperhyperboloidOneSheet::new(size, [0.7, 1.3], 2.0).unwrap().into(),
        SuperhyperboloidOneSheet::new(size, [0.3, 0.2], 0.5).unwrap().into(),
        Superellipsoid::new(block, [1.0, 2.6]).unwrap().into(),
        Superellipsoid::new(block, [0.1, 0.1]).unwrap().into(),
        Superellipsoid::new(block, [0.05, 1.0]).unwrap().into(),
        ThreeExponent::new(block, [12.0, 1.5, 20.0]).unwrap().into(),
        ThreeExponent::new(block, [1.2, 1.2, 8.0]).unwrap().into(),
    ]
}

fn poses() -> [Pose; 2] {
    let centre = Vector3::new(0.2, -0.1, 6.0);
    [[0.3, 0.8, -0.4], [1.0, 1.5, 0.2]].map(|angles| Pose::from_euler_zyz(angles, centre))
}

/// A lens and none, which show the solids `zoom` times as large as a small picture of all of them.
fn cameras(zoom: f64) -> [AnyCamera; 2] {
    let pinhole = Camera {
        fx: 120.0 * zoom,
        fy: 125.0 * zoom,
        cx: 78.0,
        cy: 61.0,
        width: WIDTH,
        height: HEIGHT,
        depth_unit: None,
        distortion: Distortion::new(&[-0.1, 0.01, 1e-3, -2e-3]).unwrap(),
    };
    let (scale, origin) = ([21.0, 20.0].map(|scale| scale * zoom), [77.3, 60.1]);
    let parallel = OrthographicCamera { scale, origin, width: WIDTH, height: HEIGHT };
    [pinhole.into(), parallel.into()]
}

fn assert_are_edges_of_what_rays_hit(solids: &[Tree], zoom: f64) {
    let views = solids.iter().flat_map(|solid| cameras(zoom).map(|camera| (solid, camera)));
    let views: Vec<(&Tree, AnyCamera)> = views.collect();
    let off = |(solid, camera)| (error(solid, &camera), solid);
    let errors: Vec<(f64, &Tree)> = views.into_par_iter().map(off).collect();
    let far: Vec<_> = errors.iter().filter(|(error, _)| *error >= TOLERANCE).collect();
    assert!(far.is_empty(), "{} of {}: {far:#?}", far.len(), errors.len());
}

/// Shapes, each deformed and posed in two ways.
fn deformed(shapes: &[Shape]) -> Vec<Tree> {
    let of = |shape: &Shape| {
        let shape = *shape;
        RATES
            .into_iter()
            .zip(poses())
            .map(move |(rates, pose)| primitive(shape, &stages(rates), pose))
    };
    shapes.iter().flat_map(of).collect()
}

#[test]
fn outlines_are_the_edges_of_what_rays_hit_of_plain_solids() {
    let plain = [smooth(), edged()].concat();
    let posed = |shape: &Shape| poses().map(|pose| primitive(*shape, &[], pose));
    let solids: Vec<Tree> = plain.iter().flat_map(posed).collect();
    assert_are_edges_of_what_rays_hit(&solids, 1.0);
}

#[test]
fn outlines_are_the_edges_of_what_rays_hit_of_smooth_solids_after_deformations() {
    assert_are_edges_of_what_rays_hit(&deformed(&smooth()), 1.0);
}

#[test]
fn outlines_are_the_edges_of_what_rays_hit_of_edged_solids_after_deformations() {
    assert_are_edges_of_what_rays_hit(&deformed(&edged()), 1.0);
}

/// Some sides of theirs are hundreds of pixels beside the picture.
#[test]
fn outlines_of_solids_that_reach_beyond_the_picture_are_the_edges_of_what_rays_hit() {
    assert_are_edges_of_what_rays_hit(&deformed(&edged()[1..6]), 4.0);
}
