//! `superquadric fit`, as it is typed.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use super::SearchArgs;
use super::parse::resolution;
use super::sensor::SensorArgs;
use super::shape::ShapeArgs;
use crate::surface::Resolution;

/// Recover a superellipsoid from a point cloud.
///
/// Prints what was found; with -o writes it as JSON too. A fit that cannot be trusted says why,
/// and exits with 1. Of several clouds, or a folder, prints a line each.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct FitArgs {
    /// Point clouds: PLY, PCD, NPY or text (XYZ, CSV), told by their content; - is stdin. With
    /// --camera depth maps: PNG of 16 bits. A folder stands for the clouds or depth maps in it.
    #[arg(required = true, value_name = "CLOUD")]
    pub clouds: Vec<PathBuf>,
    #[command(flatten)]
    pub sensor: SensorArgs,
    #[command(flatten)]
    pub shape: ShapeArgs,
    /// Write the fit as JSON to this file; - is stdout, in place of the table. Of several clouds
    /// or a folder: a folder, for NAME.json each.
    #[arg(short, long, value_name = "FIT.json")]
    pub output: Option<PathBuf>,
    /// Write a mesh of the recovered surface: .ply, .obj, .stl or .glb.
    #[arg(long, value_name = "MESH")]
    pub mesh: Option<PathBuf>,
    /// Segments along each edge of the mesh's lattice (even).
    #[arg(long, value_name = "N", default_value = "32", value_parser = resolution)]
    pub resolution: Resolution,
    /// Write the points as PLY with `inlier`, 1 for those of the surface and 0 for strays.
    #[arg(long, value_name = "POINTS.ply")]
    pub inliers: Option<PathBuf>,
    #[command(flatten)]
    pub search: SearchArgs,
    /// Threads to use [default: as many as the machine offers]. They change the time, not the
    /// result.
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
}
