//! Plane curves and their products.

use std::path::PathBuf;

use super::parse::resolution;
use crate::surface::Resolution;

/// Most points of a closed curve.
const MOST_POINTS: i64 = 4_000_000;

/// Write points of a plane curve: of all of a bounded one, and of the branches of others as far
/// as the curve's clip.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct CurveArgs {
    /// A superellipse, superhyperbola, Lame curve or polyline, .json; - is stdin.
    pub curve: PathBuf,
    /// Points around a closed curve; a fourth of them, rounded up, is the number of segments to
    /// each quadrant of any. Of a polyline, its own points are written.
    #[arg(
        short = 'n', long, value_name = "N", default_value_t = 200,
        value_parser = clap::value_parser!(u32).range(4..=MOST_POINTS)
    )]
    pub points: u32,
    /// File to write: .csv (branch, x, y) or .svg; - is stdout, as CSV.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// Write a mesh of the spherical product of two plane curves (Barr 1981), open where they are.
///
/// The northward curve scales and raises the eastward one: (x, y) and (u, v) make (x u, x v, y).
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct ProductArgs {
    /// The northward curve, .json; of one that is symmetric the right half, but of a polyline all.
    pub north: PathBuf,
    /// The eastward curve, .json.
    pub east: PathBuf,
    /// Segments to each quadrant of both curves (even); polylines have their own.
    #[arg(long, value_name = "N", default_value = "32", value_parser = resolution)]
    pub resolution: Resolution,
    /// File to write: .ply, .obj, .stl or .glb.
    #[arg(short, long, value_name = "MESH")]
    pub output: PathBuf,
}
