//! Solids of two balls and of B81's kind.

use std::f64::consts::PI;

use super::*;
use crate::deform::{Bend, Chain, Deformation, Deformed};
use crate::pose::Pose;
use crate::shape::Superellipsoid;
use crate::solid::volume_bounds;
use crate::surface::boundary_mesh;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn placed(size: [f64; 3], exponents: [f64; 2], center: [f64; 3], chain: Chain) -> Tree {
    let shape = Shape::from(Superellipsoid::new(size, exponents).unwrap());
    let deformed = Deformed::new(shape, chain).unwrap();
    let pose = Pose::new(Default::default(), Vector3::from(center));
    Primitive { deformed, pose }.into()
}

fn ball(x: f64) -> Tree {
    placed([1.0; 3], [1.0; 2], [x, 0.0, 0.0], Chain::default())
}

/// A bent bar, bored through.
fn bored() -> Tree {
    let bend = Deformation::new(Bend::new(0.6, 0.0, [-1.0, 1.0]).unwrap());
    let bar = placed([0.5, 1.8, 0.4], [0.3, 0.3], [0.0; 3], Chain::new([bend]));
    let drill = placed([0.25, 0.25, 2.0], [0.2, 1.0], [0.0, 0.1, 0.0], Chain::default());
    Tree::Difference(Box::new(bar), vec![drill])
}

fn lens() -> Tree {
    Tree::Intersection(vec![ball(-0.5), ball(0.5)])
}

/// The volume that two unit balls a distance d apart share.
fn lens_volume(d: f64) -> f64 {
    PI * (2.0 - d).powi(2) * (d * d + 4.0 * d) / (12.0 * d)
}

fn solids() -> Vec<Tree> {
    let union = Tree::Union(vec![ball(-0.5), ball(0.5)]);
    let bite = Tree::Difference(Box::new(ball(-0.5)), vec![ball(0.5)]);
    vec![ball(0.0), union, lens(), bite, bored(), Tree::Union(vec![bored(), lens()])]
}

#[test]
fn what_is_inside_has_a_level_below_one_and_is_in_the_box() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    for solid in solids() {
        let [min, max] = solid.bounding_box();
        let mut inside = 0;
        for _ in 0..4000 {
            let x = Vector3::from_fn(|_, _| 5.0 * rng.random::<f64>() - 2.5);
            let is_inside = solid.contains(&x);
            assert_eq!(solid.level(x.into()) < 1.0, is_inside);
            assert!(!is_inside || (0..3).all(|i| min[i] <= x[i] && x[i] <= max[i]));
            inside += u32::from(is_inside);
        }
        assert!(inside > 20);
    }
}

#[test]
fn volumes_of_two_balls_are_their_closed_forms() {
    let whole = 4.0 / 3.0 * PI;
    let shared = lens_volume(1.0);
    let expected = [whole, 2.0 * whole - shared, shared, whole - shared];
    for (solid, expected) in solids().iter().zip(expected) {
        for tolerance in [0.05, 1e-3] {
            let [least, greatest] = volume_bounds(solid, tolerance);
            assert!(least <= expected && expected <= greatest, "{least} {expected} {greatest}");
            assert!(greatest - least <= tolerance * greatest, "{tolerance}");
        }
    }
}

#[test]
fn meshes_are_closed_and_their_volume_is_within_the_bounds() {
    for solid in solids() {
        let mesh = boundary_mesh(&solid, solid.bounding_box(), 60);
        assert!(mesh.is_closed());
        let [least, greatest] = volume_bounds(&solid, 0.01);
        assert!(greatest - least <= 0.01 * greatest);
        // Chords of cells of a sixtieth cut corners.
        let slack = 0.01 * greatest;
        let volume = mesh.volume();
        assert!(least - slack < volume && volume < greatest + slack, "{least} {volume} {greatest}");
    }
}

#[test]
fn a_moved_solid_holds_the_moved_points() {
    let motion = Pose::from_euler_zyz([0.3, 1.2, -2.0], Vector3::new(5.0, -3.0, 0.25));
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    for solid in solids() {
        let moved = solid.moved(&motion);
        for _ in 0..500 {
            let x = Vector3::from_fn(|_, _| 4.0 * rng.random::<f64>() - 2.0);
            assert_eq!(moved.contains(&motion.world_from_model(&x)), solid.contains(&x));
        }
    }
}

#[test]
fn nothing_is_a_solid_too() {
    for nothing in [
        Tree::<Primitive<Shape>>::Union(Vec::new()),
        Tree::Intersection(vec![ball(-3.0), ball(3.0)]),
    ] {
        assert!(!nothing.contains(&Vector3::zeros()));
        assert_eq!(volume_bounds(&nothing, 0.1), [0.0, 0.0]);
        let mesh = boundary_mesh(&nothing, nothing.bounding_box(), 10);
        assert!(mesh.triangles().is_empty());
    }
}
