//! Makes the sample cloud `samples/one_sided_view.ply`: what a range camera sees of a rounded
//! box, with noise.
//!
//! Usage: `cargo run --release --example one_sided_view > samples/one_sided_view.ply`

use std::error::Error;
use std::io::{self, Write};

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use superquadric::model::Model;
use superquadric::pose::Pose;
use superquadric::shape::Superellipsoid;
use superquadric::surface::sample_surface;

/// Points sampled on the whole surface; about half of them are seen.
const POINTS: usize = 4000;
/// Standard deviation of the noise along the viewing ray, in metres.
const NOISE: f64 = 0.001;
const SEED: u64 = 1981;

fn main() -> Result<(), Box<dyn Error>> {
    let shape = Superellipsoid::new([0.10, 0.07, 0.045], [0.3, 0.5])?;
    let pose = Pose::from_euler_zyz([0.4, 0.9, 0.7], Vector3::new(0.05, -0.02, 0.80));
    let points = view(&Model { shape, pose }, &Vector3::zeros());

    let mut ply = io::stdout().lock();
    writeln!(ply, "ply\nformat ascii 1.0")?;
    writeln!(ply, "comment a rounded box seen from the origin, metres")?;
    writeln!(ply, "element vertex {}", points.len())?;
    writeln!(ply, "property double x\nproperty double y\nproperty double z\nend_header")?;
    for point in points {
        writeln!(ply, "{:.5} {:.5} {:.5}", point.x, point.y, point.z)?;
    }
    Ok(())
}

/// Points of the surface that face the camera, moved along their rays by noise.
fn view(model: &Model, camera_world: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let surface = sample_surface(&model.shape, POINTS, SEED).into_iter();
    let seen = surface.filter_map(|x_model| {
        let x_world = model.pose.world_from_model(&x_model);
        let ray = (x_world - camera_world).normalize();
        let normal = model.pose.rotation() * model.shape.gauge_gradient(&x_model);
        (normal.dot(&ray) < 0.0).then_some((x_world, ray))
    });
    seen.map(|(x_world, ray)| x_world + ray * NOISE * normal_deviate(&mut rng)).collect()
}

/// A standard normal deviate, by Box and Muller's transform.
fn normal_deviate(rng: &mut ChaCha8Rng) -> f64 {
    let radius: f64 = -2.0 * (1.0 - rng.random::<f64>()).ln();
    radius.sqrt() * (std::f64::consts::TAU * rng.random::<f64>()).cos()
}
