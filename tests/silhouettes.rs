//! Outlines of random solids of every family, deformed or not, against rays.

mod common;

use common::Scene;
use common::silhouette::{HEIGHT, TOLERANCE, WIDTH, ball, error, parallel, primitive};
use nalgebra::Vector3;
use rayon::prelude::*;
use superquadric::deform::{Bend, Chain, Deformation, Deformed, Line, Taper, Twist};
use superquadric::outline::Outline;
use superquadric::pose::Pose;
use superquadric::shape::{
    LevelSet, Shape, Solid, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets,
    Supertoroid, ThreeExponent,
};
use superquadric::solid::{Primitive, Tree};
use superquadric::view::{AnyCamera, Camera, Distortion, OrthographicCamera};

/// Pixels from the middle of the picture to the end of the solid, about.
const RADIUS: f64 = 50.0;

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

/// Pictures of a tenth of the size to eight times as large: chords follow.
#[test]
fn outlines_are_as_near_in_pictures_of_any_size() {
    let torus = Supertoroid::new([0.3, 0.4, 0.35], [0.6, 0.8], 2.5).unwrap();
    let bowls = SuperhyperboloidTwoSheets::new([0.5, 0.6, 0.4], [1.0, 0.7], 1.5).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 1.1, 0.4], Vector3::new(0.0, 0.0, 8.0));
    for shape in [torus.into(), bowls.into()] {
        let solid = primitive(shape, &[], pose);
        for size in [0.1, 1.0, 8.0] {
            let [scale, origin] = [[20.0 * size; 2], [80.0, 60.0]];
            let (width, height) = (WIDTH, HEIGHT);
            let camera = OrthographicCamera { scale, origin, width, height };
            let off = error(&solid, &AnyCamera::from(camera));
            assert!(off < TOLERANCE, "{off} pixels of {solid:?} {size} times as large");
        }
    }
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
