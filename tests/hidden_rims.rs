//! What solids hide of their own rims and of each other's.

mod common;

use common::silhouette::{TOLERANCE, ball, error, parallel, primitive};
use nalgebra::Vector3;
use superquadric::deform::{Bend, Deformation, Line, Twist};
use superquadric::outline::{Outline, RimCurve, rim_curves};
use superquadric::pose::Pose;
use superquadric::shape::{
    LevelSet, Shape, Superellipsoid, SuperhyperboloidTwoSheets, Supertoroid,
};
use superquadric::solid::Tree;
use superquadric::view::Viewpoint;

fn solids_that_hide_of_themselves() -> Vec<Tree> {
    let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
    let twist = Deformation::new(Twist::new(line(0.0, 1.2)));
    let bend = Deformation::new(Bend::new(0.7, 0.0, [-2.0, 2.0]).unwrap());
    let shapes: [(Shape, Vec<Deformation>); 5] = [
        (Supertoroid::new([0.3, 0.4, 0.35], [0.6, 0.8], 2.5).unwrap().into(), vec![]),
        (Supertoroid::new([0.3, 0.4, 0.35], [1.5, 0.4], 2.0).unwrap().into(), vec![twist.clone()]),
        (SuperhyperboloidTwoSheets::new([0.5, 0.6, 0.4], [1.0, 0.7], 1.5).unwrap().into(), vec![]),
        (
            Superellipsoid::new([0.4, 2.0, 0.2], [0.4, 0.6]).unwrap().into(),
            vec![twist, bend.clone()],
        ),
        (Superellipsoid::new([0.4, 2.0, 0.2], [1.0, 1.0]).unwrap().into(), vec![bend]),
    ];
    let solid = |(shape, stages): (_, Vec<_>)| primitive(shape, &stages, Pose::identity());
    shapes.into_iter().map(solid).collect()
}

/// The least level on the way to a point, but for the last hundredth.
fn least_level(solid: &Tree, viewpoint: &Viewpoint, x: &Vector3<f64>) -> f64 {
    let start = match viewpoint {
        Viewpoint::At(centre) => *centre,
        Viewpoint::Along(direction) => x - 10.0 * direction.normalize(),
    };
    let steps = 4000;
    let at = |i: u32| start.lerp(x, f64::from(i) / f64::from(steps));
    (0..steps * 99 / 100).map(|i| solid.level(at(i).into())).fold(f64::INFINITY, f64::min)
}

#[test]
fn rims_are_hidden_where_small_steps_along_the_line_of_sight_enter_the_solid() {
    let views = [
        Viewpoint::At(Vector3::new(5.0, -2.0, 1.0)),
        Viewpoint::Along(Vector3::new(-1.0, 0.5, -0.3)),
    ];
    let (mut hidden, mut seen) = (0, 0);
    for solid in solids_that_hide_of_themselves() {
        for viewpoint in views {
            for RimCurve { points, is_hidden } in rim_curves(&solid, &viewpoint, 200).unwrap() {
                for (x, is_hidden) in points.iter().zip(is_hidden) {
                    let least = least_level(&solid, &viewpoint, x);
                    if least < 0.99 {
                        assert!(is_hidden, "{least} before {x:?} of {solid:?}");
                        hidden += 1;
                    } else if !is_hidden {
                        seen += 1;
                    }
                }
            }
        }
    }
    assert!(hidden > 100 && seen > 500, "{hidden} {seen}");
}

/// Two balls of radius 0.5 whose centres are 0.5 apart across the line of sight, the second
/// behind the first: its rim is hidden where it is within the first's, 2 pi / 3 of it.
#[test]
fn of_several_solids_one_hides_the_rim_of_the_other() {
    let solid = Tree::Union(vec![ball([0.0, 0.0, 2.0]), ball([0.5, 0.0, 4.0])]);
    let outline = Outline::of(&solid, &parallel()).unwrap();
    let [front, back] = outline.rim_camera() else { panic!("two rims") };
    assert!(front.is_hidden.iter().all(|is_hidden| !is_hidden));
    let share = back.is_hidden.iter().filter(|is_hidden| **is_hidden).count() as f64
        / back.points.len() as f64;
    assert!((share - 1.0 / 3.0).abs() < 0.02, "{share}");
    for (x, is_hidden) in back.points.iter().zip(&back.is_hidden) {
        let off = x.xy().norm() - 0.5;
        assert!(off.abs() < 1e-6 || (off < 0.0) == *is_hidden, "{x:?}");
    }
    // Two circles less their lens.
    let lens = std::f64::consts::TAU / 3.0 - 0.75_f64.sqrt();
    let area = 0.25 * (std::f64::consts::TAU - lens) * 40.0 * 40.0;
    assert!((outline.area() / area - 1.0).abs() < 1e-3, "{} {area}", outline.area());
    assert_eq!(outline.polygons().len(), 1);
    assert!(error(&solid, &parallel()) < TOLERANCE);
}
