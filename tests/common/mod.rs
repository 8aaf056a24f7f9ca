//! Clouds with known truth, made from seeds.
#![allow(dead_code)] // each test file uses its own part

pub mod silhouette;

use std::path::{Path, PathBuf};

use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use superquadric::cloud::PointCloud;
use superquadric::compare::volume_overlap;
use superquadric::model::Model;
use superquadric::pose::Pose;
use superquadric::shape::Superellipsoid;
use superquadric::surface::sample_surface;

/// Random numbers of one scene.
pub struct Scene(ChaCha8Rng);

impl Scene {
    pub fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0.random_range(low..high)
    }

    /// A standard normal deviate, by Box and Muller's transform.
    pub fn normal(&mut self) -> f64 {
        let radius: f64 = -2.0 * (1.0 - self.0.random::<f64>()).ln();
        radius.sqrt() * (std::f64::consts::TAU * self.0.random::<f64>()).cos()
    }

    pub fn normal_vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.normal())
    }

    /// Semi-axes log-uniform between 1 and `aspect`.
    pub fn size(&mut self, aspect: f64) -> [f64; 3] {
        [0; 3].map(|_| aspect.powf(self.uniform(0.0, 1.0)))
    }

    /// Uniform over all rotations.
    pub fn rotation(&mut self) -> Rotation3<f64> {
        let [x, y, z, w] = [0; 4].map(|_| self.normal());
        UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z)).into()
    }

    /// A model of that shape in a random pose, its centre five mean semi-axes off the origin.
    pub fn place(&mut self, size: [f64; 3], exponents: [f64; 2]) -> Model {
        let shape = Superellipsoid::new(size, exponents).expect("a valid shape");
        let direction = self.normal_vector().normalize();
        let pose = Pose::new(self.rotation(), direction * 5.0 * shape.mean_semi_axis());
        Model { shape, pose }
    }

    /// Size log-uniform up to an aspect of 4, exponents uniform in 0.1..1.9, any pose.
    pub fn random_model(&mut self) -> Model {
        let size = self.size(4.0);
        let exponents = [self.uniform(0.1, 1.9), self.uniform(0.1, 1.9)];
        self.place(size, exponents)
    }

    /// Points uniform by area, with isotropic noise of a share of the mean semi-axis.
    pub fn cloud(&mut self, model: &Model, points: usize, noise: f64) -> Vec<[f64; 3]> {
        let deviation = noise * model.shape.mean_semi_axis();
        let seed = self.0.random();
        let surface = sample_surface(&model.shape, points, seed);
        surface
            .iter()
            .map(|x_model| {
                let x_world = model.pose.world_from_model(x_model);
                (x_world + deviation * self.normal_vector()).into()
            })
            .collect()
    }
}

/// What a distant camera sees of a random shape: the points that face it.
pub fn one_sided_view(
    scene: &mut Scene,
    truth: &Model,
    points: usize,
    noise: f64,
) -> Vec<[f64; 3]> {
    one_sided_view_from(scene, truth, points, noise).0
}

/// The same, and where the camera stands.
pub fn one_sided_view_from(
    scene: &mut Scene,
    truth: &Model,
    points: usize,
    noise: f64,
) -> (Vec<[f64; 3]>, [f64; 3]) {
    let camera_world = truth.pose.translation()
        + 6.0 * truth.shape.mean_semi_axis() * scene.normal_vector().normalize();
    let deviation = noise * truth.shape.mean_semi_axis();
    let surface = scene.cloud(truth, 2 * points, 0.0).into_iter().map(Vector3::from);
    let faces_camera = |x_world: &Vector3<f64>| {
        let normal = truth.shape.gauge_gradient(&truth.pose.model_from_world(x_world));
        (truth.pose.rotation() * normal).dot(&(camera_world - x_world)) > 0.0
    };
    let seen: Vec<Vector3<f64>> = surface.filter(faces_camera).collect();
    let noisy = |x_world: &Vector3<f64>| (x_world + deviation * scene.normal_vector()).into();
    (seen.iter().map(noisy).collect(), camera_world.into())
}

/// Points with noise along the rays of a camera alone, of that standard deviation.
pub fn with_range_noise(
    scene: &mut Scene,
    points: &[[f64; 3]],
    camera_world: [f64; 3],
    deviation: f64,
) -> Vec<[f64; 3]> {
    let moved = |point: &[f64; 3]| {
        let x_world = Vector3::from(*point);
        let ray = (x_world - Vector3::from(camera_world)).normalize();
        (x_world + deviation * scene.normal() * ray).into()
    };
    points.iter().map(moved).collect()
}

/// The points among as many strays, uniform in a box of twice the shape's sides, that they are
/// that share of all.
pub fn with_strays(
    scene: &mut Scene,
    truth: &Model,
    mut points: Vec<[f64; 3]>,
    share: f64,
) -> Vec<[f64; 3]> {
    let strays = (points.len() as f64 * share / (1.0 - share)).round() as usize;
    let [low, high] = truth.bounding_box();
    let (centre, half) = ((low + high) * 0.5, high - low);
    for _ in 0..strays {
        points.push(std::array::from_fn(|k| centre[k] + half[k] * scene.uniform(-1.0, 1.0)));
    }
    points
}

/// Intersection over union of two solids, to about 2e-3.
pub fn iou(a: &Model, b: &Model) -> f64 {
    volume_overlap(a, b, 20_000, 7).iou
}

/// The middle value.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

pub fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

pub fn point_cloud(points: &[[f64; 3]]) -> PointCloud {
    PointCloud::from_rows(points.iter().copied())
}

/// A folder of shared test data; says so and returns none where it is absent.
pub fn shared(folder: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared").join(folder);
    if path.is_dir() {
        return Some(path);
    }
    println!("not tested: {} is absent", path.display());
    None
}
