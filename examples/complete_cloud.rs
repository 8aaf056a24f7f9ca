//! Writes a complete cloud of a random superellipsoid with 1 % of noise, as binary PLY.
//!
//! Usage: `cargo run --release --example complete_cloud -- POINTS [SEED] > cloud.ply`

#[path = "../tests/common/mod.rs"]
mod common;

use std::error::Error;
use std::io::{self, BufWriter, Write};

use common::Scene;

const NOISE: f64 = 0.01;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let points: usize = arguments.next().ok_or("expected the number of points")?.parse()?;
    let seed: u64 = arguments.next().map_or(Ok(0), |seed| seed.parse())?;
    let mut scene = Scene::new(seed);
    let truth = scene.random_model();

    let mut ply = BufWriter::new(io::stdout().lock());
    writeln!(ply, "ply\nformat binary_little_endian 1.0\nelement vertex {points}")?;
    writeln!(ply, "property double x\nproperty double y\nproperty double z\nend_header")?;
    for point in scene.cloud(&truth, points, NOISE) {
        for coordinate in point {
            ply.write_all(&coordinate.to_le_bytes())?;
        }
    }
    Ok(ply.flush()?)
}
