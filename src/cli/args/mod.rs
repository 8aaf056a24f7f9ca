//! What can be typed.

mod curve;
mod exchange;
mod fit;
mod mesh;
mod parse;
mod points;
mod sensor;
mod shape;
mod view;

use std::num::NonZeroUsize;
use std::path::PathBuf;

pub(super) use curve::{CurveArgs, ProductArgs};
pub(super) use exchange::{ExportArgs, ImportArgs};
pub(super) use fit::FitArgs;
pub(super) use mesh::FinenessArgs;
pub(super) use points::{DualArgs, EvaluateArgs, SampleArgs};
pub(super) use sensor::{SensorArgs, SupportArg};
pub(super) use view::{ContourArgs, OverlayArgs, RenderArgs, ViewArgs};

use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use crate::recover::{Distance, FitOptions, Precision};

/// Recovers superquadrics from range points, and tells what there is to know of them.
#[derive(Debug, Parser)]
#[command(name = "superquadric", version, about, after_long_help = AFTER_HELP)]
pub(super) struct Args {
    #[command(subcommand)]
    pub command: Command,
}

const AFTER_HELP: &str = "\
Examples:
  superquadric fit cloud.ply                       what shape is it?
  superquadric fit cloud.ply -o fit.json --mesh fit.ply
  superquadric fit - -o - < cloud.xyz              from stdin, JSON to stdout
  superquadric mesh fit.json -o shape.stl --tolerance 0.001
  superquadric info fit.json
  superquadric sample fit.json -n 5000 -o points.ply
  superquadric evaluate fit.json cloud.ply -o distances.csv
  superquadric dual model.json -o dual.json
  superquadric contour fit.json --camera camera.json -o outline.svg
  superquadric overlay fit.json --camera camera.json --image photo.png -o overlay.png
  superquadric render fit.json --camera camera.json --shaded picture.png
  superquadric render scene.toml --shaded picture.png --depth depth.npy
  superquadric curve superellipse.json -o curve.svg
  superquadric product north.json east.json -o surface.ply
  superquadric export fit.json --to lammps -o particle.data
  superquadric import particle.data --from lammps -o model.json

Exit codes:
  0  done
  1  done, but the fit cannot be trusted
  2  bad input or usage

A model is a superellipsoid
  ((|x|/a1)^(2/e2) + (|y|/a2)^(2/e2))^(e2/e1) + (|z|/a3)^(2/e1) = 1
with semi-axes a1 a2 a3 in the cloud's own unit and exponents e1 (north-south) and e2
(east-west), turned by Euler angles ZYZ and moved to its centre. Exponents near 0 are boxes, 1 is
round, 2 is bevelled. Models of the other families (superhyperboloid_one_sheet,
superhyperboloid_two_sheets, supertoroid, three_exponent) can be given wherever a model is read.

A curve is {\"curve\": \"superellipse\", \"size\": [a, b], \"exponent\": e}, a \"superhyperbola\" with the
same, or {\"curve\": \"lame\", \"size\": [a, b], \"numerator\": p, \"denominator\": q}. Branches without end
stop at \"clip\" times the semi-axes, if that is given, else at a clip of their own. Any other curve is
{\"curve\": \"polyline\", \"points\": [[x, y], ..], \"closed\": true or false}.";

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    Fit(Box<FitArgs>),
    Mesh(MeshArgs),
    Info(InfoArgs),
    Sample(SampleArgs),
    Evaluate(EvaluateArgs),
    Dual(DualArgs),
    Contour(ContourArgs),
    Curve(CurveArgs),
    Product(ProductArgs),
    Overlay(OverlayArgs),
    Render(RenderArgs),
    Export(ExportArgs),
    Import(ImportArgs),
    Batch(BatchArgs),
    Completions(CompletionsArgs),
}

/// How the model is searched for.
#[derive(Debug, clap::Args)]
pub(super) struct SearchArgs {
    /// Seed of the choice of points that the coarse search looks at.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// The distance whose squares are minimised.
    #[arg(long, value_enum, default_value_t)]
    pub distance: DistanceArg,
    /// The numbers in which the rows of the points are evaluated.
    #[arg(long, value_enum, default_value_t)]
    pub precision: PrecisionArg,
}

impl SearchArgs {
    /// The options of a fit on so many threads.
    pub fn options(&self, threads: Option<NonZeroUsize>) -> FitOptions {
        FitOptions {
            seed: self.seed,
            distance: self.distance.into(),
            precision: self.precision.into(),
            threads,
            ..FitOptions::default()
        }
    }
}

/// Write a mesh of the surface of a model, with its parameters in the file, or of a solid or scene.
#[derive(Debug, clap::Args)]
pub(super) struct MeshArgs {
    /// A fit, a bare model, a solid or a scene, .json or .toml; - is stdin, for JSON.
    pub model: PathBuf,
    /// File to write: .ply, .obj, .stl or .glb.
    #[arg(short, long, value_name = "MESH")]
    pub output: PathBuf,
    #[command(flatten)]
    pub fineness: FinenessArgs,
}

/// Tell what is known of a model: axes, extents, volume, area, inertia, bounding box.
///
/// Of what is made of several models, a solid or a scene: volume, between bounds, and bounding box.
#[derive(Debug, clap::Args)]
pub(super) struct InfoArgs {
    /// A fit, a bare model, a solid or a scene, .json or .toml; - is stdin, for JSON.
    pub model: PathBuf,
    /// Print JSON instead of a table.
    #[arg(long)]
    pub json: bool,
}

/// Fit and score every scene of a suite whose truth is known.
///
/// Writes a row a scene and a summary by level, and prints the summary. A run that was
/// interrupted goes on where it ended.
#[derive(Debug, clap::Args)]
pub(super) struct BatchArgs {
    /// Folder of the suite: suite.json, and scenes/NAME/ with cloud.ply and truth.json.
    pub suite: PathBuf,
    /// Folder of the results: scenes.csv, summary.json, and a document a scene.
    #[arg(short, long, value_name = "RESULTS")]
    pub output: PathBuf,
    #[command(flatten)]
    pub search: SearchArgs,
    /// Threads to use [default: as many as the machine offers].
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
}

/// Print shell completions.
#[derive(Debug, clap::Args)]
pub(super) struct CompletionsArgs {
    /// Shell to complete for.
    pub shell: Shell,
}

/// A distance, as it is typed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(super) enum DistanceArg {
    /// Along the ray from the centre (JLS Eq. 2.43).
    Radial,
    /// The radial one first, then the first-order geometric one.
    #[default]
    Geometric,
}

impl From<DistanceArg> for Distance {
    fn from(typed: DistanceArg) -> Self {
        match typed {
            DistanceArg::Radial => Self::Radial,
            DistanceArg::Geometric => Self::Geometric,
        }
    }
}

/// A precision, as it is typed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(super) enum PrecisionArg {
    /// That of f64.
    #[default]
    Double,
    /// That of f32, faster: residuals are rounded by 1e-7 of the cloud's radius.
    Single,
}

impl From<PrecisionArg> for Precision {
    fn from(typed: PrecisionArg) -> Self {
        match typed {
            PrecisionArg::Double => Self::Double,
            PrecisionArg::Single => Self::Single,
        }
    }
}
