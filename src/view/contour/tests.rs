use nalgebra::Rotation3;

use super::*;
use crate::pose::Pose;
use crate::shape::Superellipsoid;
use crate::view::{Camera, Distortion, OrthographicCamera};

fn camera(distortion: &[f64]) -> Camera {
    Camera {
        fx: 500.0,
        fy: 520.0,
        cx: 319.5,
        cy: 239.5,
        width: 640,
        height: 480,
        depth_unit: None,
        distortion: Distortion::new(distortion).unwrap(),
    }
}

fn sphere(radius: f64, centre: [f64; 3]) -> Model {
    Model {
        shape: Superellipsoid::new([radius; 3], [1.0; 2]).unwrap(),
        pose: Pose::new(Rotation3::identity(), centre.into()),
    }
}

#[test]
fn a_sphere_is_seen_as_a_circle_or_an_ellipse_of_known_area() {
    let scale = [300.0, 200.0];
    let parallel = OrthographicCamera { scale, origin: [10.0, 20.0], width: 64, height: 48 };
    let contour = Contour::of(&sphere(0.2, [0.1, -0.3, 9.0]), &parallel).unwrap();
    let circle = std::f64::consts::PI * 0.2 * 0.2 * 300.0 * 200.0;
    assert!((contour.area() / circle - 1.0).abs() < 2e-4);
    let [min, max] = contour.bounding_box();
    for (found, expected) in
        [(min[0], 10.0 - 30.0), (max[0], 10.0 + 90.0), (min[1], 20.0 - 100.0), (max[1], 0.0)]
    {
        assert!((found - expected).abs() <= TOLERANCE, "{found} {expected}");
    }

    // On the axis the cone of sight has the half-angle asin(r / d).
    let on_axis = Contour::of(&sphere(0.2, [0.0, 0.0, 1.0]), &camera(&[])).unwrap();
    let slope = (0.2_f64).asin().tan();
    for [column, row] in on_axis.polygon() {
        let [x, y] = [(column - 319.5) / 500.0, (row - 239.5) / 520.0];
        assert!((x.hypot(y) - slope).abs() < 1e-14);
    }
    // Off it the area of the ellipse in which the image cuts the cone of sight.
    let centre = Vector3::new(0.3, 0.2, 1.0);
    let off_axis = Contour::of(&sphere(0.2, centre.into()), &camera(&[])).unwrap();
    let gap = centre.z * centre.z - 0.04;
    let section =
        std::f64::consts::PI * 0.04 * (centre.norm_squared() - 0.04).sqrt() / gap.powf(1.5);
    assert!((off_axis.area() / (section * 500.0 * 520.0) - 1.0).abs() < 2e-4);
}

#[test]
fn the_polygon_is_as_near_the_contour_as_it_says() {
    let shape = Superellipsoid::new([0.1, 0.2, 0.3], [0.05, 1.9]).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 1.1, -0.8], Vector3::new(0.1, -0.1, 1.5));
    let model = Model { shape, pose };
    for lens in [&[][..], &[-0.28, 0.07, 1e-3, -5e-4]] {
        let camera = camera(lens);
        let polygon = Contour::of(&model, &camera).unwrap().polygon().to_vec();
        assert!(polygon.len() < 2000, "{}", polygon.len());
        let tangents = Tangents::new(&shape, &camera.viewpoint(&pose)).unwrap();
        for i in 0..5000 {
            let x_camera = pose.world_from_model(&tangents.point(1.25e-3 * f64::from(i)));
            let pixel = Vector2::from(camera.project(&x_camera).unwrap());
            let distance = (0..polygon.len())
                .map(|i| distance_to_segment(&pixel, polygon[i], polygon[(i + 1) % polygon.len()]))
                .fold(f64::INFINITY, f64::min);
            assert!(distance < 1.1 * TOLERANCE, "{distance}");
        }
    }
}

fn distance_to_segment(pixel: &Vector2<f64>, a: [f64; 2], b: [f64; 2]) -> f64 {
    let (a, b) = (Vector2::from(a), Vector2::from(b));
    let share = (pixel - a).dot(&(b - a)) / (b - a).norm_squared();
    (a + share.clamp(0.0, 1.0) * (b - a) - pixel).norm()
}

#[test]
fn what_does_not_close_in_the_image_is_refused() {
    let refusal = |model: Model, lens: &[f64]| Contour::of(&model, &camera(lens)).unwrap_err();
    assert_eq!(refusal(sphere(1.0, [0.0, 0.0, 0.5]), &[]), RimError::Inside);
    assert_eq!(refusal(sphere(1.0, [3.0, 0.0, 0.5]), &[]), RimError::Behind);
    assert_eq!(refusal(sphere(1.0, [0.0, 0.0, -5.0]), &[]), RimError::Behind);
    let barrel = [-0.28, 0.0, 0.0, 0.0];
    assert_eq!(refusal(sphere(1.0, [0.0, 0.0, 1.2]), &barrel), RimError::BeyondLens);
}
