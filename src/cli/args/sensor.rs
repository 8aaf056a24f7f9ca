//! What the sensor knows besides the points.

use std::path::PathBuf;

use super::parse::{positive, vector};
use crate::recover::Plane;

/// What the sensor knows besides the points.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct SensorArgs {
    /// The input is a depth map of this camera: JSON with fx, fy, cx, cy, width, height in pixels
    /// and depth_units_m. Lengths in the result are metres in the camera's frame.
    #[arg(long, value_name = "CAM.json", conflicts_with = "viewpoint")]
    pub camera: Option<PathBuf>,
    /// The object in the depth map: PNG, not 0 where it is. Where the camera saw past it there is
    /// nothing of the model.
    #[arg(long, value_name = "MASK.png", requires = "camera")]
    pub mask: Option<PathBuf>,
    /// Metres to a count of the depth map [default: depth_units_m of the camera].
    #[arg(long, value_name = "METRES", requires = "camera", value_parser = positive)]
    pub depth_unit: Option<f64>,
    /// Where the sensor stood, in the cloud's frame: nothing was in the way of its points.
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = vector::<3>)]
    pub viewpoint: Option<[f64; 3]>,
    /// The plane that the object stands on: A,B,C,D for A x + B y + C z + D = 0, the object where
    /// this is positive; or auto, to find it around the object (needs --camera or --viewpoint).
    #[arg(long, value_name = "PLANE", allow_hyphen_values = true, value_parser = support)]
    pub support: Option<SupportArg>,
}

/// A support, as it is typed.
#[derive(Debug, Clone, Copy)]
pub(in crate::cli) enum SupportArg {
    Auto,
    Plane(Plane),
}

fn support(text: &str) -> Result<SupportArg, String> {
    if text == "auto" {
        return Ok(SupportArg::Auto);
    }
    let [a, b, c, d] = vector(text).map_err(|error| format!("auto, or {error}"))?;
    let plane = Plane::new([a, b, c], d).ok_or("expected a normal A,B,C other than 0")?;
    Ok(SupportArg::Plane(plane))
}
