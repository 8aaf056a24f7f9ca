//! What can be typed.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use crate::recover::{Constraints, Distance, FitOptions, Plane, Tie};
use crate::surface::Resolution;

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
  superquadric mesh fit.json -o shape.stl
  superquadric info fit.json

Exit codes:
  0  done
  1  done, but the fit cannot be trusted
  2  bad input or usage

A model is a superellipsoid
  ((|x|/a1)^(2/e2) + (|y|/a2)^(2/e2))^(e2/e1) + (|z|/a3)^(2/e1) = 1
with semi-axes a1 a2 a3 in the cloud's own unit and exponents e1 (north-south) and e2
(east-west), turned by Euler angles ZYZ and moved to its centre. Exponents near 0 are boxes, 1 is
round, 2 is bevelled.";

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    Fit(FitArgs),
    Mesh(MeshArgs),
    Info(InfoArgs),
    Batch(BatchArgs),
    Completions(CompletionsArgs),
}

/// Recover a superellipsoid from a point cloud.
///
/// Prints what was found; with -o writes it as JSON too. A fit that cannot be trusted says why,
/// and exits with 1.
#[derive(Debug, clap::Args)]
pub(super) struct FitArgs {
    /// Point cloud: PLY, PCD, NPY or text (XYZ, CSV), told by its content; - is stdin. With
    /// --camera a depth map: PNG of 16 bits.
    pub cloud: PathBuf,
    #[command(flatten)]
    pub sensor: SensorArgs,
    #[command(flatten)]
    pub shape: ShapeArgs,
    /// Write the fit as JSON to this file; - is stdout, in place of the table.
    #[arg(short, long, value_name = "FIT.json")]
    pub output: Option<PathBuf>,
    /// Write a mesh of the recovered surface: .ply, .obj or .stl.
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

/// What the sensor knows besides the points.
#[derive(Debug, clap::Args)]
pub(super) struct SensorArgs {
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
pub(super) enum SupportArg {
    Auto,
    Plane(Plane),
}

/// What is known of the shape.
#[derive(Debug, clap::Args)]
pub(super) struct ShapeArgs {
    /// What kind of shape it is.
    #[arg(long, value_enum, default_value_t)]
    pub class: ClassArg,
    /// Fix a parameter: a1, a2, a3, e1, e2, or the centre's x, y, z. May be repeated.
    #[arg(long, value_name = "NAME=VALUE", value_parser = fixed)]
    pub fix: Vec<(Parameter, f64)>,
    /// Semi-axes are from LOW to HIGH, in the cloud's unit.
    #[arg(long, value_name = "LOW,HIGH", value_parser = vector::<2>)]
    pub size_range: Option<[f64; 2]>,
    /// Exponents are from LOW to HIGH, within 0.05 to 2.
    #[arg(long, value_name = "LOW,HIGH", value_parser = vector::<2>)]
    pub exponent_range: Option<[f64; 2]>,
    /// Semi-axes that are equal.
    #[arg(long, value_enum)]
    pub tie: Option<TieArg>,
}

/// A class of shapes, as it is typed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(super) enum ClassArg {
    /// Any superellipsoid.
    #[default]
    Any,
    /// A box: exponents up to 0.4.
    Box,
    /// A circular cylinder along z: a1 = a2, e2 = 1, e1 up to 0.4.
    Cylinder,
    /// Exponents 1.
    Ellipsoid,
    /// Exponents 1 and equal semi-axes.
    Sphere,
}

/// Semi-axes that are equal, as it is typed.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum TieArg {
    /// a1 = a2.
    Equator,
    /// a1 = a2 = a3.
    All,
}

/// A parameter that can be fixed.
#[derive(Debug, Clone, Copy)]
pub(super) enum Parameter {
    Size(usize),
    Exponent(usize),
    Centre(usize),
}

impl ShapeArgs {
    /// The constraints that are meant: those of the class, then what narrows them.
    pub fn constraints(&self) -> Constraints {
        let mut constraints = match self.class {
            ClassArg::Any => Constraints::NONE,
            ClassArg::Box => Constraints::cuboid(),
            ClassArg::Cylinder => Constraints::cylinder(),
            ClassArg::Ellipsoid => Constraints::ellipsoid(),
            ClassArg::Sphere => Constraints::sphere(),
        };
        if let Some(range) = self.size_range {
            constraints.size = [range; 3];
        }
        if let Some(range) = self.exponent_range {
            constraints.exponents = [range; 2];
        }
        match self.tie {
            Some(TieArg::Equator) => constraints.tie = Tie::Equator,
            Some(TieArg::All) => constraints.tie = Tie::All,
            None => {}
        }
        for (parameter, value) in &self.fix {
            match *parameter {
                Parameter::Size(k) => constraints.size[k] = [*value; 2],
                Parameter::Exponent(k) => constraints.exponents[k] = [*value; 2],
                Parameter::Centre(k) => constraints.centre[k] = Some(*value),
            }
        }
        constraints
    }
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
}

impl SearchArgs {
    /// The options of a fit on so many threads.
    pub fn options(&self, threads: Option<NonZeroUsize>) -> FitOptions {
        FitOptions {
            seed: self.seed,
            distance: self.distance.into(),
            threads,
            ..FitOptions::default()
        }
    }
}

/// Write a mesh of a model's surface.
#[derive(Debug, clap::Args)]
pub(super) struct MeshArgs {
    /// A fit or a bare model in JSON; - is stdin.
    pub model: PathBuf,
    /// File to write: .ply, .obj or .stl.
    #[arg(short, long, value_name = "MESH")]
    pub output: PathBuf,
    /// Segments along each edge of the mesh's lattice (even).
    #[arg(long, value_name = "N", default_value = "32", value_parser = resolution)]
    pub resolution: Resolution,
}

/// Tell what is known of a model: axes, extents, volume, bounding box.
#[derive(Debug, clap::Args)]
pub(super) struct InfoArgs {
    /// A fit or a bare model in JSON; - is stdin.
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

/// Numbers between commas.
fn vector<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let expected = || format!("expected {N} numbers with commas between them");
    let numbers: Result<Vec<f64>, _> =
        text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let numbers: [f64; N] = numbers.map_err(|_| expected())?.try_into().map_err(|_| expected())?;
    let is_finite = numbers.iter().all(|number| number.is_finite());
    if is_finite { Ok(numbers) } else { Err("expected finite numbers".to_owned()) }
}

fn fixed(text: &str) -> Result<(Parameter, f64), String> {
    let expected = || "expected one of a1 a2 a3 e1 e2 x y z, =, and a number".to_owned();
    let (name, value) = text.split_once('=').ok_or_else(expected)?;
    let parameter = match name.trim() {
        "a1" => Parameter::Size(0),
        "a2" => Parameter::Size(1),
        "a3" => Parameter::Size(2),
        "e1" => Parameter::Exponent(0),
        "e2" => Parameter::Exponent(1),
        "x" => Parameter::Centre(0),
        "y" => Parameter::Centre(1),
        "z" => Parameter::Centre(2),
        _ => return Err(expected()),
    };
    let [value] = vector(value).map_err(|_| expected())?;
    Ok((parameter, value))
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "expected a positive number".to_owned())
}

fn support(text: &str) -> Result<SupportArg, String> {
    if text == "auto" {
        return Ok(SupportArg::Auto);
    }
    let [a, b, c, d] = vector(text).map_err(|error| format!("auto, or {error}"))?;
    let plane = Plane::new([a, b, c], d).ok_or("expected a normal A,B,C other than 0")?;
    Ok(SupportArg::Plane(plane))
}

fn resolution(text: &str) -> Result<Resolution, String> {
    let segments = text.parse().map_err(|_| "expected a whole number".to_owned())?;
    Resolution::new(segments).map_err(|error| error.to_string())
}
