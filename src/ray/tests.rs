//! Rays against every family, deformed shapes and solids.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use super::*;
use crate::deform::{Bend, Chain, Deformation, Deformed, Line, Taper, Twist};
use crate::pose::Pose;
use crate::shape::{
    Shape, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
    ThreeExponent,
};
use crate::solid::{Primitive, Tree};
use crate::view::{Camera, OrthographicCamera};

/// Rays that a shape is tried with.
const RAYS: usize = 10_000;

/// Steps of the brute-force march along a ray.
const STEPS: usize = 150;

fn solid(shape: impl Into<Shape>, stages: impl IntoIterator<Item = Deformation>) -> Tree {
    let deformed = Deformed::new(shape.into(), Chain::new(stages)).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 0.8, -0.4], Vector3::new(0.2, -0.1, 0.3));
    Primitive { deformed, pose }.into()
}

/// The solid searched along the whole ray, and in cells.
fn targets(solid: &Tree) -> [Box<dyn Hittable + Sync>; 2] {
    let whole = Target::new(solid.clone(), solid.bounding_box());
    [Box::new(whole), Box::new(SolidTarget::new(solid))]
}

fn stages() -> [Deformation; 3] {
    let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
    [
        Deformation::new(Taper::new(line(1.0, -0.4))),
        Deformation::new(Twist::new(line(0.0, 1.2))),
        Deformation::new(Bend::new(0.6, 0.0, [-0.8, 0.8]).unwrap()),
    ]
}

/// Two balls, one bitten off the other.
fn bite() -> Tree {
    let ball = |x: f64| {
        let shape = Shape::from(Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap());
        let deformed = Deformed::new(shape, Chain::default()).unwrap();
        Tree::from(Primitive { deformed, pose: Pose::new(Default::default(), Vector3::x() * x) })
    };
    Tree::Difference(Box::new(ball(0.0)), vec![ball(0.9)])
}

fn solids() -> Vec<Tree> {
    let size = [1.0, 1.4, 0.3];
    let of = |exponents| Superellipsoid::new(size, exponents).unwrap();
    let mut solids: Vec<Tree> =
        [[0.1, 0.1], [1.0, 1.0], [0.1, 1.0], [1.0, 0.1], [1.9, 0.5], [2.0, 2.0]]
            .map(|exponents| solid(of(exponents), []))
            .into();
    solids.extend([[0.1, 0.1], [0.5, 1.0]].map(|exponents| solid(of(exponents), stages())));
    solids.push(solid(SuperhyperboloidOneSheet::new(size, [0.7, 1.0], 0.4).unwrap(), []));
    solids.push(solid(SuperhyperboloidTwoSheets::new(size, [1.0, 0.8], 2.0).unwrap(), []));
    solids.push(solid(Supertoroid::new([0.3, 0.3, 0.3], [1.0, 1.0], 3.0).unwrap(), []));
    solids.push(solid(ThreeExponent::new(size, [2.0, 3.0, 4.0]).unwrap(), []));
    solids.push(bite());
    solids
}

/// Rays from around the solid to points about it; a tenth of them along axes.
fn rays(solid: &Tree) -> Vec<Ray> {
    let mut rng = ChaCha8Rng::seed_from_u64(12);
    let [min, max] = solid.bounding_box();
    let (center, half) = (0.5 * (min + max), 0.5 * (max - min));
    let mut draw = || Vector3::from_fn(|_, _| 2.0 * rng.random::<f64>() - 1.0);
    let ray = |i: usize| {
        let aimed = center + draw().component_mul(&half);
        let direction = if i.is_multiple_of(10) { Vector3::ith(i / 10 % 3, 1.0) } else { draw() };
        let origin = aimed - 4.0 * half.norm() / direction.norm() * direction;
        Ray { origin, direction }
    };
    (0..RAYS).map(ray).collect()
}

#[test]
fn hits_are_on_the_surface_and_part_inside_from_outside() {
    for (number, solid) in solids().iter().enumerate() {
        for target in targets(solid) {
            let hits = |ray: &Ray| {
                let all = target.all_hits(ray);
                assert_eq!(all.first().map(|hit| hit.t), target.first_hit(ray).map(|hit| hit.t));
                assert!(all.len().is_multiple_of(2), "{number}: what goes in comes out");
                assert!(all.windows(2).all(|pair| pair[0].t < pair[1].t));
                for i in 0..all.len() {
                    assert_parts_inside_from_outside(solid, ray, &all, i);
                }
                all.len()
            };
            let found: usize = rays(solid).par_iter().map(hits).sum();
            assert!(found > RAYS / 5, "{number}: {found}");
        }
    }
}

/// Nudges a hit along its ray, by no more than half of the way to the next one.
fn assert_parts_inside_from_outside(solid: &Tree, ray: &Ray, all: &[Hit], i: usize) {
    let (hit, length) = (all[i], ray.direction.norm());
    let neighbours = [i.wrapping_sub(1), i + 1].into_iter().filter_map(|j| all.get(j));
    let gap = neighbours.map(|next| (next.t - hit.t).abs()).fold(f64::INFINITY, f64::min);
    let nudge = (1e-6 / length).min(0.5 * gap);
    let [before, after] = [-nudge, nudge].map(|by| solid.contains(&ray.at(hit.t + by)));
    // Of parts thinner than that rounding may hide the inside.
    let goes_in = i.is_multiple_of(2);
    let is_told = gap * length < 1e-6 || (before != goes_in && after == goes_in);
    assert!(is_told, "{ray:?} {hit:?}");
    assert!((hit.normal.norm() - 1.0).abs() < 1e-12);
}

#[test]
fn brute_force_marching_finds_no_hit_that_was_missed() {
    for (number, solid) in solids().iter().enumerate() {
        let bounds = solid.bounding_box();
        for target in targets(solid) {
            let marches_inside = |ray: &Ray| {
                let Some(range) = ray.clipped(&bounds) else { return false };
                let at = |i: usize| range[0] + (range[1] - range[0]) * (i as f64 / STEPS as f64);
                let inside: Vec<f64> =
                    (0..=STEPS).map(at).filter(|&t| solid.contains(&ray.at(t))).collect();
                let hits = target.all_hits(ray);
                for t in &inside {
                    let before = hits.iter().filter(|hit| hit.t < *t).count();
                    assert!(!before.is_multiple_of(2), "{number}: {ray:?} {t} {hits:?}");
                }
                !inside.is_empty()
            };
            let found = rays(solid).par_iter().filter(|ray| marches_inside(ray)).count();
            assert!(found > RAYS / 10, "{number}: {found}");
        }
    }
}

#[test]
fn boxes_and_cells_change_no_hit() {
    let at = |x: f64, exponents| {
        let shape = Shape::from(Superellipsoid::new([0.4, 0.8, 0.5], exponents).unwrap());
        let deformed = Deformed::new(shape, Chain::new(stages())).unwrap();
        Tree::from(Primitive { deformed, pose: Pose::new(Default::default(), Vector3::x() * x) })
    };
    let [a, b, c] = [at(-0.6, [0.5, 1.0]), at(0.3, [1.0, 1.0]), at(0.5, [0.2, 0.2])];
    let shared = Tree::Intersection(vec![a.clone(), b.clone()]);
    let bitten = Tree::Difference(Box::new(c), vec![a, at(3.0, [1.0, 1.0])]);
    let solid = Tree::Union(vec![shared, bitten, at(1.4, [0.3, 0.3])]);
    let [whole, boxed] = targets(&solid);
    let mut hits = 0;
    for ray in rays(&solid).iter().take(2000) {
        let [expected, found] = [whole.all_hits(ray), boxed.all_hits(ray)];
        assert_eq!(expected.len(), found.len(), "{ray:?}");
        for (expected, found) in expected.iter().zip(&found) {
            assert!((expected.position - found.position).norm() < 1e-10, "{ray:?}");
            assert!((expected.normal - found.normal).norm() < 1e-6, "{ray:?}");
        }
        assert_eq!(found.first().copied(), boxed.first_hit(ray));
        hits += found.len();
    }
    assert!(hits > 500, "{hits}");
}

#[test]
fn cells_tell_enough_of_pinched_shapes_whose_slopes_have_no_bound() {
    let star = solid(Superellipsoid::new([1.0, 1.4, 0.8], [2.4, 2.2]).unwrap(), []);
    let [whole, boxed] = targets(&star);
    let mut hits = 0;
    for ray in rays(&star).iter().take(300) {
        let [expected, found] = [whole.all_hits(ray), boxed.all_hits(ray)];
        assert_eq!(expected.len(), found.len(), "{ray:?}");
        hits += found.len();
    }
    assert!(hits > 20, "{hits}");
}

#[test]
fn hits_of_a_ball_are_the_quadratics() {
    let solid = solid(Superellipsoid::new([2.0; 3], [1.0; 2]).unwrap(), []);
    let center = Vector3::new(0.2, -0.1, 0.3);
    for target in targets(&solid) {
        for ray in rays(&solid) {
            let d = ray.direction.normalize();
            let offset = ray.origin - center;
            let (b, c) = (offset.dot(&d), offset.norm_squared() - 4.0);
            let root = (b * b - c).sqrt();
            let hits = target.all_hits(&ray);
            if root.is_nan() {
                assert!(hits.is_empty());
            } else if root > 1e-4 {
                for (hit, expected) in hits.iter().zip([-b - root, -b + root]) {
                    let found = hit.t * ray.direction.norm();
                    assert!((found - expected).abs() < 1e-13 * expected.abs() / root.min(1.0));
                    assert!((hit.normal - (hit.position - center) / 2.0).norm() < 1e-9);
                }
                assert_eq!(hits.len(), 2);
            }
        }
    }
}

#[test]
fn a_sheet_of_a_thousandth_is_not_missed() {
    let sheet = solid(Superellipsoid::new([1.0, 1.0, 1e-3], [0.1, 0.1]).unwrap(), []);
    for target in targets(&sheet) {
        let is_through = |ray: &&Ray| target.all_hits(ray).len() == 2;
        let through = rays(&sheet).iter().filter(is_through).count();
        assert!(through > RAYS / 5, "{through}");
    }
}

#[test]
fn a_ray_that_starts_inside_leaves_once_and_one_away_hits_nothing() {
    let center = Vector3::new(0.2, -0.1, 0.3);
    let inside = Ray { origin: center, direction: Vector3::new(0.3, -0.2, 0.7) };
    let away = Ray { origin: center + 9.0 * Vector3::x(), direction: Vector3::x() };
    for target in targets(&solid(Superellipsoid::new([1.0; 3], [0.3; 2]).unwrap(), [])) {
        assert_eq!(target.all_hits(&inside).len(), 1);
        assert_eq!(target.first_hit(&away), None);
    }
}

/// Grazing, far, tiny and huge: hits are those of the same ball of radius one.
#[test]
fn hits_are_the_same_from_micrometres_to_kilometres_and_at_grazing_rays() {
    for scale in [1e-6, 1.0, 1e6] {
        let ball = solid(Superellipsoid::new([scale; 3], [1.0; 2]).unwrap(), []);
        let center = Vector3::new(0.2, -0.1, 0.3);
        for target in targets(&ball) {
            for offset in [0.0, 0.9, 1.0 - 1e-6, 1.0 - 1e-9, 1.0 + 1e-9, 1.1] {
                let origin = center + scale * Vector3::new(offset, -1.0, -50.0);
                let direction = Vector3::new(0.0, 0.01, 0.5);
                let ray = Ray { origin, direction: direction * (scale / 3.0) };
                let hits = target.all_hits(&ray);
                assert_eq!(hits.len(), if offset < 1.0 { 2 } else { 0 }, "{scale} {offset}");
                let half = 0.5 * scale * (1.0 - offset * offset).sqrt() / direction.norm();
                for hit in &hits {
                    let length = 0.5 * (hits[1].t - hits[0].t) * direction.norm() * scale / 3.0;
                    assert!((length / (2.0 * half * direction.norm()) - 1.0).abs() < 1e-3);
                    assert!(((hit.position - center).norm() / scale - 1.0).abs() < 1e-9);
                }
            }
        }
    }
}

#[test]
fn depth_of_a_ball_is_the_same_for_a_central_and_a_parallel_camera_on_the_axis() {
    let shape = Shape::from(Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap());
    let deformed = Deformed::new(shape, Chain::default()).unwrap();
    let pose = Pose::new(Default::default(), Vector3::new(0.0, 0.0, 5.0));
    let solid = Tree::from(Primitive { deformed, pose });
    let text = r#"{"fx": 30, "fy": 30, "cx": 10, "cy": 8, "width": 21, "height": 17}"#;
    let central: Camera = serde_json::from_str(text).unwrap();
    let parallel =
        OrthographicCamera { scale: [6.0; 2], origin: [10.0, 8.0], width: 21, height: 17 };
    let targets = [SolidTarget::new(&solid)];
    let [central, parallel] =
        [render(&targets, &central, || ()), render(&targets, &parallel, || ())];
    for rendering in [&central, &parallel] {
        let middle = 8 * 21 + 10;
        assert!((rendering.depths[middle] - 4.0).abs() < 1e-12);
        assert!((rendering.normals[middle] + Vector3::z()).norm() < 1e-9);
        assert_eq!((rendering.depths[0], rendering.normals[0]), (0.0, Vector3::zeros()));
    }
    // A sphere of radius 1 at 6 pixels a unit covers about 36 pi pixels.
    let seen = parallel.depths.iter().filter(|depth| **depth > 0.0).count();
    assert!((100..130).contains(&seen), "{seen}");
}
