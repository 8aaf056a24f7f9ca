//! Masses of deformed shapes of every family against closed forms and random points.

use std::f64::consts::{FRAC_PI_2, PI};

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::deform::{Bend, Chain, Deformation, Line, Polyline, Scale, Taper, Twist};
use crate::shape::{
    LevelSet, Shape, Solid, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets,
    Supertoroid, ThreeExponent,
};

const SIZE: [f64; 3] = [0.8, 0.5, 0.6];

/// Every family at some exponents.
fn shapes() -> Vec<Shape> {
    let mut shapes = Vec::new();
    for e in [[0.1, 0.4], [1.0, 1.0], [1.6, 0.7], [2.0, 2.0]] {
        shapes.push(Superellipsoid::new(SIZE, e).unwrap().into());
        shapes.push(SuperhyperboloidOneSheet::new(SIZE, e, 0.9).unwrap().into());
        shapes.push(SuperhyperboloidTwoSheets::new(SIZE, e, 1.5).unwrap().into());
        shapes.push(Supertoroid::new([0.3, 0.2, 0.4], e, 1.8).unwrap().into());
    }
    for n in [[2.0, 2.0, 2.0], [1.2, 3.0, 8.0]] {
        shapes.push(ThreeExponent::new(SIZE, n).unwrap().into());
    }
    shapes
}

fn line(at_zero: f64, slope: f64) -> Line {
    Line::new(at_zero, slope).unwrap()
}

fn deformed<S: Solid + LevelSet>(shape: S, stages: impl Into<Vec<Deformation>>) -> Deformed<S> {
    Deformed::new(shape, Chain::new(stages.into())).unwrap()
}

/// A block of half-sizes 0.5, 1 and 0.25, its edges as good as sharp.
fn block() -> Superellipsoid {
    Superellipsoid::new([0.5, 1.0, 0.25], [1e-3, 1e-3]).unwrap()
}

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &impl std::fmt::Debug) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected} {what:?}");
}

#[test]
fn masses_of_what_is_not_deformed_are_the_shapes_own() {
    for shape in shapes() {
        let estimate = deformed(shape, []).mass_estimate(1e-7);
        assert!(estimate.error <= 1e-7, "{shape:?} {}", estimate.error);
        let expected = shape.mass_properties();
        assert_near(estimate.properties.volume(), expected.volume(), 1e-7, &shape);
        assert_near(estimate.surface_area, shape.surface_area(), 1e-7, &shape);
        let difference = estimate.properties.inertia() - expected.inertia();
        assert!(difference.amax() < 1e-6 * expected.inertia().amax(), "{shape:?}");
        assert!(estimate.properties.centroid().norm() < 1e-7, "{shape:?}");
    }
}

#[test]
fn twists_keep_volumes_and_tapers_multiply_slices() {
    for shape in shapes() {
        let twist = Deformation::new(Twist::new(line(0.3, 1.5)));
        let volume = deformed(shape, [twist]).mass_estimate(1e-7).properties.volume();
        assert_near(volume, shape.volume(), 1e-7, &shape);
        // The mean of `(1 + c z)^2` over a solid that is symmetric in z.
        let c = 0.4;
        let taper = Deformation::new(Taper::new(line(1.0, c)));
        let volume = deformed(shape, [taper]).mass_estimate(1e-7).properties.volume();
        let squares = shape.mass_properties().second_moments()[(2, 2)];
        assert_near(volume, shape.volume() + c * c * squares, 1e-6, &shape);
    }
}

#[test]
fn scaled_shapes_are_shapes_of_other_sizes() {
    for exponents in [[0.1, 0.1], [1.0, 0.4], [2.0, 2.0]] {
        let shape = Superellipsoid::new([0.8, 1.8, 0.6], exponents).unwrap();
        let scale = Deformation::new(Scale::new([2.0, 0.5, 3.0]).unwrap());
        let scaled = deformed(shape, [scale]).mass_estimate(1e-8);
        let expected = Superellipsoid::new([1.6, 0.9, 1.8], exponents).unwrap();
        let inertia = expected.mass_properties().inertia();
        assert!((scaled.properties.inertia() - inertia).amax() < 1e-7 * inertia.amax());
        assert_near(scaled.surface_area, expected.surface_area(), 1e-8, &shape);
    }
}

#[test]
fn a_bent_block_has_the_volume_and_centroid_of_pappus() {
    // Of 1 - k z only the mean, 1, matters for its volume.
    let bend = Deformation::new(Bend::new(FRAC_PI_2 / 2.0, 0.0, [-1.0, 1.0]).unwrap());
    let properties = deformed(block(), [bend]).mass_estimate(1e-7).properties;
    assert_near(properties.volume(), block().volume(), 1e-7, &"bent");
    // The centroid of a quarter of a ring of radii R +- a3 about its axis at height R.
    let radius = 2.0 / FRAC_PI_2;
    let (outer, inner) = (radius + 0.25, radius - 0.25);
    let mean = 2.0 / 3.0 * (outer.powi(3) - inner.powi(3)) / (outer.powi(2) - inner.powi(2));
    let height = radius - mean * (PI / 4.0).sin() / (PI / 4.0);
    assert!((properties.centroid() - Vector3::new(0.0, 0.0, height)).norm() < 1e-5);
}

#[test]
fn where_a_bend_ends_and_a_polyline_has_a_knot_volumes_are_as_accurate() {
    // Half of the block is bent about a line nearer by `offset` than its own middle plane is.
    let (k, offset) = (0.7, 0.2);
    let frame = crate::pose::Pose::new(Default::default(), Vector3::new(0.0, 0.0, offset));
    let bend = Deformation::in_frame(Bend::new(k, 0.0, [-0.6, 0.4]).unwrap(), frame);
    let volume = deformed(block(), [bend]).mass_estimate(1e-7).properties.volume();
    assert_near(volume / block().volume(), 1.0 + 0.5 * k * offset, 2e-6, &"bent");
    // Slices of z grow as the square of a profile with a knot.
    let knots = vec![[-0.3, 0.6], [0.1, 1.4], [0.3, 0.9]];
    let taper = Deformation::new(Taper::new(Polyline::new(knots).unwrap()));
    let volume = deformed(block(), [taper]).mass_estimate(1e-7).properties.volume();
    // Simpson's rule is exact for squares of lines.
    let simpson = |profile: &dyn Fn(f64) -> f64, a: f64, b: f64| {
        let [start, middle, end] = [a, 0.5 * (a + b), b].map(|z| profile(z).powi(2));
        (b - a) / 6.0 * (start + 4.0 * middle + end)
    };
    let below = simpson(&|z| 1.2 + 2.0 * z, -0.25, 0.1);
    let above = simpson(&|z| 1.65 - 2.5 * z, 0.1, 0.25);
    assert_near(volume, 2.0 * (below + above), 2e-6, &"tapered");
}

#[test]
fn masses_of_chains_are_those_of_random_points() {
    let stages = [
        Deformation::new(Taper::new(line(1.0, -0.3))),
        Deformation::new(Twist::new(line(0.0, 1.2))),
        Deformation::new(Bend::new(0.5, 0.0, [-0.6, 0.5]).unwrap()),
    ];
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    for shape in shapes() {
        let solid = deformed(shape, stages.clone());
        let estimate = solid.mass_estimate(1e-6);
        assert!(estimate.error <= 1e-6, "{shape:?} {}", estimate.error);
        let [min, max] = solid.bounding_box();
        let extent = max - min;
        let (mut volume, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
        let count = 40_000;
        let weight = extent.product() / f64::from(count);
        for _ in 0..count {
            let x = min + extent.map(|side| side * rng.random::<f64>());
            if solid.contains(&x) {
                volume += weight;
                first += weight * x;
                second += weight * x * x.transpose();
            }
        }
        let drawn = MassProperties::of_integrals(volume, first, second);
        // Five standard errors of a share of a half, and of moments about as certain.
        let slack = 5.0 * 0.5 / f64::from(count).sqrt() * extent.product();
        let length = extent.norm();
        let properties = estimate.properties;
        assert!((properties.volume() - drawn.volume()).abs() < slack, "{shape:?}");
        let off_centre = (properties.centroid() - drawn.centroid()).norm();
        assert!(off_centre * volume < slack * length, "{shape:?}");
        let difference = (properties.inertia() - drawn.inertia()).amax();
        assert!(difference < slack * length * length, "{shape:?}");
    }
}
