//! Outlines of random solids of every family, deformed or not, against rays.

mod common;

use common::Scene;
use nalgebra::Vector3;
use rayon::prelude::*;
use superquadric::deform::{Bend, Chain, Deformation, Deformed, Line, Taper, Twist};
use superquadric::model::Model;
use superquadric::outline::{Outline, RimCurve, rim_curves};
use superquadric::pose::Pose;
use superquadric::ray::{Hittable, Rays, SolidTarget};
use superquadric::shape::{
    LevelSet, Shape, Solid, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets,
    Supertoroid, ThreeExponent,
};
use superquadric::solid::{Primitive, Tree};
use superquadric::view::{AnyCamera, Camera, Distortion, OrthographicCamera, Viewpoint};

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;

/// Pixels from the middle of the picture to the end of the solid, about.
const RADIUS: f64 = 50.0;

/// Most pixels between the outline and the edge of what rays hit.
const TOLERANCE: f64 = 0.5;

/// Pixels from one place on the outline to the next at which rays are cast on either side.
const STEP: f64 = 2.0;

/// Every which pixel a ray is cast through besides, along rows and columns.
const STRIDE: usize = 6;

/// Any exponents that a family has, aspects up to 100, micrometres to kilometres.
fn random_shape(scene: &mut Scene, seed: u64) -> Shape {
    let unit = 10.0_f64.powf(scene.uniform(-6.0, 3.0));
    let aspect = [2.0, 10.0, 100.0][scene.uniform(0.0, 3.0) as usize];
    let size = scene.size(aspect).map(|a| a * unit);
    let mut exponents = |low, high| [scene.uniform(low, high), scene.uniform(low, high)];
    let shape = match seed % 5 {
        0 => Superellipsoid::new(size, exponents(0.1, 2.8)).map(Shape::from),
        1 => {
            let [n1, n2] = exponents(1.2, 12.0);
            ThreeExponent::new(size, [n1, n2, scene.uniform(1.2, 12.0)]).map(Shape::from)
        }
        2 => {
            let exponents = exponents(0.2, 1.8);
            Supertoroid::new(size, exponents, scene.uniform(1.2, 4.0)).map(Shape::from)
        }
        3 => {
            let (exponents, clip) = (exponents(0.2, 1.8), size[2] * scene.uniform(0.3, 2.0));
            SuperhyperboloidOneSheet::new(size, exponents, clip).map(Shape::from)
        }
        _ => {
            let (exponents, clip) = (exponents(0.2, 1.8), size[0] * scene.uniform(1.2, 2.5));
            SuperhyperboloidTwoSheets::new(size, exponents, clip).map(Shape::from)
        }
    };
    shape.expect("a valid shape")
}

/// Every third is tapered, twisted and bent, if none of it would then fold.
fn random_solid(scene: &mut Scene, seed: u64) -> Deformed<Shape> {
    let shape = random_shape(scene, seed);
    let [_, half] = shape.bounding_box();
    let line = |at_zero, slope| Line::new(at_zero, slope).expect("a line");
    let bend = Bend::new(scene.uniform(-0.6, 0.6) / half.y, 0.0, [-half.y, half.y]);
    let stages = [
        Deformation::new(Taper::new(line(1.0, scene.uniform(-0.5, 0.5) / half.z))),
        Deformation::new(Twist::new(line(0.0, scene.uniform(-1.2, 1.2) / half.z))),
        Deformation::new(bend.expect("a bend")),
    ];
    let deformed = seed.is_multiple_of(3).then(|| Deformed::new(shape, Chain::new(stages)).ok());
    deformed.flatten().unwrap_or(Deformed::plain(shape))
}

/// A solid in the frame of a camera that sees it whole, and the camera.
fn random_view(
    scene: &mut Scene,
    deformed: &Deformed<Shape>,
    is_pinhole: bool,
) -> (Tree, AnyCamera) {
    let [min, max] = deformed.bounding_box();
    let radius = 0.5 * (max - min).norm();
    let distance = scene.uniform(2.0, 8.0) * radius;
    let off_axis = Vector3::new(scene.uniform(-0.3, 0.3), scene.uniform(-0.3, 0.3), 1.0);
    let rotation = scene.rotation();
    let middle = rotation * (0.5 * (min + max));
    let pose = Pose::new(rotation, distance * off_axis - middle);
    let [u, v] = [scene.uniform(75.0, 85.0), scene.uniform(55.0, 65.0)];
    let camera = if is_pinhole {
        let focal = RADIUS * (distance / radius - 0.5);
        let lens = [-0.1, 0.01, 1e-3, -2e-3].map(|k| scene.uniform(0.0, 1.0) * k);
        AnyCamera::Pinhole(Camera {
            fx: focal,
            fy: 1.1 * focal,
            cx: u - focal * off_axis.x,
            cy: v - focal * off_axis.y,
            width: WIDTH,
            height: HEIGHT,
            depth_unit: None,
            distortion: Distortion::new(&lens).expect("a lens"),
        })
    } else {
        let scale = [RADIUS / radius, 1.1 * RADIUS / radius];
        let [x, y] = [distance * off_axis.x, distance * off_axis.y];
        let origin = [u - scale[0] * x, v - scale[1] * y];
        AnyCamera::Orthographic(OrthographicCamera { scale, origin, width: WIDTH, height: HEIGHT })
    };
    (Primitive { deformed: deformed.clone(), pose }.into(), camera)
}

/// Whether a place is within polygons, even-odd, and the distance to their nearest side.
fn place(polygons: &[Vec<[f64; 2]>], [u, v]: [f64; 2]) -> (bool, f64) {
    let (mut is_inside, mut nearest) = (false, f64::INFINITY);
    for polygon in polygons {
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            is_inside ^= (a[1] <= v) != (b[1] <= v) && a[0] + (v - a[1]) / y * x > u;
            let share = ((u - a[0]) * x + (v - a[1]) * y) / (x * x + y * y);
            let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
            nearest = nearest.min((a[0] + share * x - u).hypot(a[1] + share * y - v));
        }
    }
    (is_inside, nearest)
}

/// Places a little more than the tolerance to either side of polygons, and pixels of the whole
/// picture.
fn places(polygons: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    for row in (0..HEIGHT).step_by(STRIDE) {
        places.extend((0..WIDTH).step_by(STRIDE).map(|column| [f64::from(column), f64::from(row)]));
    }
    for polygon in polygons {
        let mut passed = STEP;
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            passed += x.hypot(y);
            if passed >= STEP {
                passed = 0.0;
                let off = 1.01 * TOLERANCE / x.hypot(y);
                let [u, v] = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
                places.extend([1.0, -1.0].map(|side| [u - side * off * y, v + side * off * x]));
            }
        }
    }
    places
}

/// The most pixels between the outline and a place at which rays tell otherwise than it does.
fn error(solid: &Tree, camera: &AnyCamera) -> f64 {
    let outline = Outline::of(solid, camera).expect("an outline");
    let target = SolidTarget::new(solid);
    let off = |at: &[f64; 2]| {
        let ray = camera.ray(at[0], at[1])?;
        let (is_inside, off) = place(outline.polygons(), *at);
        (target.first_hit(&ray).is_some() != is_inside).then_some(off)
    };
    places(outline.polygons()).iter().filter_map(off).fold(0.0, f64::max)
}

fn assert_are_edges_of_what_rays_hit(seeds: std::ops::Range<u64>) {
    let errors: Vec<(u64, bool, f64)> = seeds
        .into_par_iter()
        .flat_map_iter(|seed| {
            let mut scene = Scene::new(seed);
            let deformed = random_solid(&mut scene, seed);
            [true, false].map(|is_pinhole| {
                let (solid, camera) = random_view(&mut scene, &deformed, is_pinhole);
                (seed, is_pinhole, error(&solid, &camera))
            })
        })
        .collect();
    let far: Vec<_> = errors.iter().filter(|(.., error)| *error >= TOLERANCE).collect();
    assert!(far.is_empty(), "{} of {}: {far:?}", far.len(), errors.len());
}

#[test]
fn outlines_are_the_edges_of_what_rays_hit_of_random_solids_and_both_cameras() {
    assert_are_edges_of_what_rays_hit(0..30);
}

#[test]
#[ignore = "takes minutes"]
fn outlines_are_the_edges_of_what_rays_hit_of_200_random_solids_and_both_cameras() {
    assert_are_edges_of_what_rays_hit(0..200);
}

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
    let solid = |(shape, stages)| {
        let deformed = Deformed::new(shape, Chain::new(stages)).unwrap();
        Tree::from(Primitive { deformed, pose: Pose::identity() })
    };
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

/// Pictures of a tenth of the size to eight times as large: chords follow.
#[test]
fn outlines_are_as_near_in_pictures_of_any_size() {
    let [torus, _, bowls, ..] = &solids_that_hide_of_themselves()[..] else { panic!("solids") };
    for solid in [torus, bowls] {
        let pose = Pose::from_euler_zyz([0.3, 1.1, 0.4], Vector3::new(0.0, 0.0, 8.0));
        let solid = solid.moved(&pose);
        for size in [0.1, 1.0, 8.0] {
            let [scale, origin] = [[20.0 * size; 2], [80.0, 60.0]];
            let (width, height) = (WIDTH, HEIGHT);
            let camera = OrthographicCamera { scale, origin, width, height };
            let off = error(&solid, &AnyCamera::from(camera));
            assert!(off < TOLERANCE, "{off} pixels of {solid:?} {size} times as large");
        }
    }
}

fn ball(center: [f64; 3]) -> Tree {
    let shape = Shape::from(Superellipsoid::new([0.5; 3], [1.0; 2]).unwrap());
    let pose = Pose::new(Default::default(), Vector3::from(center));
    Primitive::from(Model { shape, pose }).into()
}

fn parallel() -> AnyCamera {
    let [scale, origin] = [[40.0; 2], [80.0, 60.0]];
    AnyCamera::Orthographic(OrthographicCamera { scale, origin, width: WIDTH, height: HEIGHT })
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

/// What balls take away, share and join, against rays.
#[test]
fn outlines_of_differences_and_intersections_are_the_edges_of_what_rays_hit() {
    let [a, b] = [ball([0.0, 0.1, 3.0]), ball([0.4, 0.0, 2.8])];
    let bite = Tree::Difference(Box::new(a.clone()), vec![b.clone()]);
    let lens = Tree::Intersection(vec![a, b.clone()]);
    let joined = Tree::Union(vec![bite.clone(), ball([-0.5, 0.5, 3.5])]);
    for solid in [bite, lens, joined] {
        let off = error(&solid, &parallel());
        assert!(off < TOLERANCE, "{off} pixels of {solid:?}");
        let outline = Outline::of(&solid, &parallel()).unwrap();
        for x in outline.rim_camera().iter().flat_map(|curve| &curve.points) {
            assert!(solid.level((*x).into()) < 1.0 + 1e-6, "{x:?} of {solid:?}");
        }
    }
}

#[test]
fn what_is_behind_a_camera_is_not_seen_and_nothing_has_no_outline() {
    let text = r#"{"fx": 200, "fy": 200, "cx": 80, "cy": 60, "width": 160, "height": 120}"#;
    let camera: Camera = serde_json::from_str(text).unwrap();
    let [ahead, behind] = [ball([0.0, 0.0, 3.0]), ball([0.0, 0.0, -3.0])];
    let both = Outline::of(&Tree::Union(vec![ahead.clone(), behind.clone()]), &camera).unwrap();
    assert_eq!(both, Outline::of(&ahead, &camera).unwrap());
    for nothing in [Tree::Union(Vec::new()), behind] {
        let error = Outline::of(&nothing, &camera).unwrap_err().to_string();
        assert!(error.contains("behind the camera"), "{error}");
    }
}
