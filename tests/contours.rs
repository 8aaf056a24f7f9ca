//! Occluding contours against masks: ray-cast ones, and those of real photographs.

mod common;

use common::{Scene, shared};
use nalgebra::Vector3;
use superquadric::model::Model;
use superquadric::pose::Pose;
use superquadric::recover::{FitOptions, fit};
use superquadric::shape::Superellipsoid;
use superquadric::view::{
    Camera, Contour, DepthMap, Distortion, Mask, OrthographicCamera, Projection, find_plane,
    points_above,
};

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;

/// Most pixels between the polygon and the edge of the ray-cast mask.
const TOLERANCE: f64 = 0.02;

/// A line of sight in the camera's frame.
type Line = [Vector3<f64>; 2];

/// Whether a line meets a solid: the gauge along it is convex, and its least value is found by
/// golden section.
fn meets(model: &Model, [origin, direction]: Line) -> bool {
    let origin = model.pose.model_from_world(&origin);
    let direction = model.pose.rotation().inverse_transform_vector(&direction).normalize();
    let radius = Vector3::from(model.shape.size()).norm();
    let foot = origin - origin.dot(&direction) * direction;
    if foot.norm() > radius {
        return false;
    }
    let gauge = |t: f64| model.shape.gauge(&(foot + t * direction));
    let (mut low, mut high) = (-radius, radius);
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_a, mut at_b) = (gauge(a), gauge(b));
    for _ in 0..70 {
        if at_a.min(at_b) <= 1.0 {
            return true;
        }
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - golden * (high - low);
            at_a = gauge(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + golden * (high - low);
            at_b = gauge(b);
        }
    }
    false
}

/// Columns at which a row crosses the polygon, ascending.
fn crossings(polygon: &[[f64; 2]], row: f64) -> Vec<f64> {
    let next = polygon.iter().skip(1).chain(polygon.first());
    let crossing = |(a, b): (&[f64; 2], &[f64; 2])| {
        ((a[1] <= row) != (b[1] <= row))
            .then(|| a[0] + (row - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
    };
    let mut columns: Vec<f64> = polygon.iter().zip(next).filter_map(crossing).collect();
    columns.sort_by(f64::total_cmp);
    columns
}

fn is_inside(crossings: &[f64], column: f64) -> bool {
    crossings.iter().filter(|crossing| **crossing <= column).count() % 2 == 1
}

fn distance(polygon: &[[f64; 2]], [u, v]: [f64; 2]) -> f64 {
    let next = polygon.iter().skip(1).chain(polygon.first());
    let to_segment = |(a, b): (&[f64; 2], &[f64; 2])| {
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        let share = ((u - a[0]) * x + (v - a[1]) * y) / (x * x + y * y);
        let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
        (a[0] + share * x - u).hypot(a[1] + share * y - v)
    };
    polygon.iter().zip(next).map(to_segment).fold(f64::INFINITY, f64::min)
}

/// Holds the contour against the lines of sight of all pixels: how many of them meet the solid.
fn assert_is_edge_of_mask(
    model: &Model,
    camera: &impl Projection,
    line: impl Fn(f64, f64) -> Option<Line>,
) -> usize {
    let contour = Contour::of(model, camera).expect("a contour");
    let mut inside = 0;
    for row in (0..HEIGHT).map(f64::from) {
        let crossings = crossings(contour.polygon(), row);
        for column in (0..WIDTH).map(f64::from) {
            let Some(line) = line(column, row) else { continue };
            let is_object = meets(model, line);
            inside += usize::from(is_object);
            if is_object != is_inside(&crossings, column) {
                let off = distance(contour.polygon(), [column, row]);
                assert!(off < TOLERANCE, "{off} pixels at {column}, {row} of {model:?}");
            }
        }
    }
    inside
}

/// Any exponents up to 2, aspects up to 100, micrometres to kilometres.
fn random_shape(scene: &mut Scene) -> Superellipsoid {
    let unit = 10.0_f64.powf(scene.uniform(-6.0, 3.0));
    let aspect = [2.0, 10.0, 100.0][scene.uniform(0.0, 3.0) as usize];
    let mut exponent = || match scene.uniform(0.0, 1.0) {
        draw if draw < 0.1 => 0.05,
        draw if draw < 0.2 => 2.0,
        _ => scene.uniform(0.05, 2.0),
    };
    let exponents = [exponent(), exponent()];
    Superellipsoid::new(scene.size(aspect).map(|a| a * unit), exponents).expect("a valid shape")
}

#[test]
fn contours_are_the_edges_of_ray_cast_masks_of_both_cameras() {
    let mut seen = 0;
    for seed in 0..200 {
        let mut scene = Scene::new(seed);
        let shape = random_shape(&mut scene);
        let radius = Vector3::from(shape.size()).norm();
        let distance = scene.uniform(1.3, 8.0) * radius;
        let off_axis = Vector3::new(scene.uniform(-0.3, 0.3), scene.uniform(-0.3, 0.3), 1.0);
        let model = Model { shape, pose: Pose::new(scene.rotation(), distance * off_axis) };
        let focal = scene.uniform(20.0, 60.0) * (distance / radius - 0.5);
        let lens = [-0.1, 0.01, 1e-3, -2e-3].map(|k| if seed % 2 == 0 { k } else { 0.0 });
        let camera = Camera {
            fx: focal,
            fy: 1.1 * focal,
            cx: scene.uniform(60.0, 100.0) - focal * off_axis.x,
            cy: scene.uniform(40.0, 80.0) - focal * off_axis.y,
            width: WIDTH,
            height: HEIGHT,
            depth_unit: None,
            distortion: Distortion::new(&lens).expect("a lens"),
        };
        let ray = |column, row| Some([Vector3::zeros(), camera.ray(column, row)?.into()]);
        seen += assert_is_edge_of_mask(&model, &camera, ray);

        let parallel = OrthographicCamera {
            scale: [50.0 / radius, 60.0 / radius],
            origin: [80.0 - 50.0 / radius * model.pose.translation().x, 60.0],
            width: WIDTH,
            height: HEIGHT,
        };
        let line = |column: f64, row: f64| {
            let [u, v] = parallel.origin;
            let foot = [(column - u) / parallel.scale[0], (row - v) / parallel.scale[1], 0.0];
            Some([Vector3::from(foot), Vector3::z()])
        };
        seen += assert_is_edge_of_mask(&model, &parallel, line);
    }
    assert!(seen > 400 * 300, "{seen} pixels of objects in all");
}

/// Overlap of the polygon with a mask, as intersection over union.
fn silhouette_iou(contour: &Contour, mask: &Mask) -> f64 {
    let width = mask.size()[0] as usize;
    let (mut both, mut either) = (0, 0);
    for (row, is_object) in mask.is_object().chunks(width).enumerate() {
        let crossings = crossings(contour.polygon(), row as f64);
        for (column, is_object) in is_object.iter().enumerate() {
            let is_inside = is_inside(&crossings, column as f64);
            both += usize::from(is_inside && *is_object);
            either += usize::from(is_inside || *is_object);
        }
    }
    f64::from(both as u32) / f64::from(either as u32)
}

/// The can's mask leaves out its dark sides, up to 7 pixels wide, where the sensor saw nothing: the
/// outline of the right can is larger. The bottle with its neck is no superellipsoid.
#[test]
fn contours_of_fits_to_real_depth_maps_cover_the_objects_masks() {
    let Some(folder) = shared("data/rgbd") else { return };
    let camera = Camera::read(folder.join("intrinsics.json")).expect("a camera");
    for (object, least, is_one) in
        [("sugar", 0.9, true), ("pepper", 0.84, true), ("mustard", 0.75, false)]
    {
        let path = |kind: &str| folder.join(format!("{object}_{kind}.png"));
        let mask = Mask::read(path("mask")).expect("a mask");
        let map = DepthMap::read(path("depth"), camera, Some(&path("mask")), None).expect("a map");
        let table = find_plane(&map.surroundings(), [0.0; 3], 0).expect("a table");
        let cloud = points_above(&map.inner_points(), &table, [0.0; 3]);
        let sight = Some(map.sight());
        let options = FitOptions { sight, support: Some(table), ..FitOptions::default() };
        let fit = fit(&cloud, &options).expect("a fit");
        let contour = Contour::of(&fit.model, &camera).expect("a contour");
        let iou = silhouette_iou(&contour, &mask);
        let extents = fit.model.shape.size().map(|a| 2.0 * a);
        println!("{object}: silhouette overlap {iou:.3}, extents {extents:.3?}");
        assert!(iou >= least, "{object}: {iou}");
        assert!(is_one || !fit.is_trusted(), "{object} is trusted");
    }
}
