//! Rims of smooth shapes, deformed or not, and of a torus.

use nalgebra::Vector3;

use super::*;
use crate::deform::{Bend, Chain, Deformation, Deformed, Line, Taper, Twist};
use crate::model::Model;
use crate::pose::Pose;
use crate::ray::outward_normal;
use crate::shape::{LevelSet, Shape, Superellipsoid, Supertoroid, ThreeExponent};
use crate::solid::{Primitive, Tree};
use crate::view::{OrthographicCamera, Viewpoint};

const WIDTH: u32 = 100;
const HEIGHT: u32 = 80;

fn stages() -> [Deformation; 3] {
    let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
    [
        Deformation::new(Taper::new(line(1.0, -0.4))),
        Deformation::new(Twist::new(line(0.0, 1.2))),
        Deformation::new(Bend::new(0.25, 0.0, [-3.0, 3.0]).unwrap()),
    ]
}

fn smooth() -> Vec<Shape> {
    let size = [1.0, 1.4, 0.7];
    vec![
        Superellipsoid::new(size, [0.6, 0.8]).unwrap().into(),
        Supertoroid::new([0.3, 0.4, 0.35], [1.0, 1.0], 2.5).unwrap().into(),
        Supertoroid::new([0.3, 0.4, 0.35], [0.5, 0.7], 2.5).unwrap().into(),
        ThreeExponent::new(size, [4.0, 2.0, 3.0]).unwrap().into(),
    ]
}

fn solids(shapes: &[Shape]) -> Vec<Deformed<Shape>> {
    let of = |shape: &Shape, stages: &[Deformation]| {
        Deformed::new(*shape, Chain::new(stages.to_vec())).unwrap()
    };
    let plain = shapes.iter().map(|shape| of(shape, &[]));
    plain.chain(shapes.iter().map(|shape| of(shape, &stages()))).collect()
}

fn parallel() -> OrthographicCamera {
    OrthographicCamera { scale: [21.0, 20.0], origin: [47.3, 40.1], width: WIDTH, height: HEIGHT }
}

#[test]
fn lines_of_sight_touch_smooth_solids_at_their_rims() {
    for deformed in solids(&smooth()) {
        let solid = Tree::from(Primitive { deformed, pose: Pose::identity() });
        for viewpoint in [
            Viewpoint::At(Vector3::new(5.0, -2.0, 3.0)),
            Viewpoint::Along(Vector3::new(-0.3, 0.5, 0.8)),
        ] {
            let curves = rim_curves(&solid, &viewpoint, 200).unwrap();
            assert!(!curves.is_empty());
            for x in curves.iter().flat_map(|curve| &curve.points) {
                let sight = match viewpoint {
                    Viewpoint::At(centre) => x - centre,
                    Viewpoint::Along(direction) => direction,
                };
                let off = sight.normalize().dot(&outward_normal(&solid, x)).abs();
                assert!(off < 1e-9, "{off:e} at {x:?} of {solid:?}");
                assert!((solid.level((*x).into()) - 1.0).abs() < 1e-9, "{x:?} of {solid:?}");
            }
        }
    }
}

#[test]
fn points_of_traced_rims_are_evenly_spaced() {
    for deformed in solids(&smooth()) {
        let solid = Tree::from(Primitive { deformed, pose: Pose::identity() });
        let viewpoint = Viewpoint::At(Vector3::new(5.0, -2.0, 3.0));
        let curves = rim_curves(&solid, &viewpoint, 600).unwrap();
        let count: usize = curves.iter().map(|curve| curve.points.len()).sum();
        assert!(count.abs_diff(600) < curves.len() + 1, "{count}");
        for RimCurve { points, is_hidden } in &curves {
            assert_eq!(points.len(), is_hidden.len());
            let next = points.iter().cycle().skip(1);
            let steps: Vec<f64> = points.iter().zip(next).map(|(a, b)| (b - a).norm()).collect();
            let mean = steps.iter().sum::<f64>() / steps.len() as f64;
            // Chords across a sharp bend are shorter than the way around it.
            assert!(
                steps.iter().all(|step| *step < 1.05 * mean && *step > 0.7 * mean),
                "{solid:?}"
            );
        }
    }
}

/// Half-planes through the axis cut a round torus in two circles; seen from far away along x, the
/// rim is where the circles' normals are across to x.
#[test]
fn a_torus_has_a_hole_from_above_and_hides_its_inner_rim_edge_on() {
    let torus = Shape::from(Supertoroid::new([0.5; 3], [1.0; 2], 3.0).unwrap());
    let above = Tree::from(Primitive::from(Model { shape: torus, pose: Pose::identity() }));
    let outline = Outline::of(&above, &parallel()).unwrap();
    assert_eq!(outline.polygons().len(), 2);
    // Between the radii 0.5 * (3 + 1) and 0.5 * (3 - 1).
    let ring = std::f64::consts::PI * (4.0 - 1.0) * 21.0 * 20.0;
    assert!((outline.area() / ring - 1.0).abs() < 1e-3);
    assert!(outline.rim_camera().iter().all(|curve| !curve.is_hidden.contains(&true)));

    let edge_on = Viewpoint::Along(Vector3::new(1.0, 0.0, 0.1));
    let curves = rim_curves(&above, &edge_on, 400).unwrap();
    let all = || curves.iter().flat_map(|curve| curve.points.iter().zip(&curve.is_hidden));
    // The hole is not seen through: of the inner side all is hidden, of the outer none.
    let (mut inner, mut outer) = (0, 0);
    for (x, is_hidden) in all() {
        let radius = x.xy().norm();
        if radius < 1.3 {
            assert!(is_hidden, "{x:?}");
            inner += 1;
        } else if radius > 1.6 {
            assert!(!is_hidden, "{x:?}");
            outer += 1;
        }
    }
    assert!(inner > 20 && outer > 20, "{inner} {outer}");
}
