//! Points of models, and models at points.

use std::path::PathBuf;

use clap::ValueEnum;

use crate::cli::error::CliError;
use crate::report::Spread;
use crate::surface::Parameterization;

/// Most points that are written.
const MOST_POINTS: i64 = 10_000_000;
/// Points by area, if no number is given.
const POINTS: u32 = 1000;
/// Steps to a quarter of a turn, if no number is given.
const STEPS: u32 = 16;
/// Most steps to a quarter of a turn: rows of them have some 10 million points.
const MOST_STEPS: u32 = 750;

/// Write points of the surface of a model, with its normals and curvatures.
///
/// Columns are x y z, the outward normal nx ny nz and, of what is not deformed, the principal
/// curvatures k1 k2, the greater first, positive where the surface bends away from its normal. The
/// caps of a clip are part of the surface.
#[derive(Debug, clap::Args)]
#[command(after_help = SAMPLE_EXAMPLES)]
pub(in crate::cli) struct SampleArgs {
    /// A fit, or a bare model of any family, deformed or not, in JSON; - is stdin.
    pub model: PathBuf,
    /// How the points are spread: at random by area, or in rows (JLS section 2.5).
    #[arg(long, value_enum, default_value_t)]
    pub by: SpreadArg,
    /// Number of points by area [default: 1000], or of steps to each quarter of a turn of the rows,
    /// up to 750 [default: 16].
    #[arg(
        short = 'n', long, value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=MOST_POINTS)
    )]
    pub number: Option<u32>,
    /// Seed of the points by area [default: 0].
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// File to write: .csv or .ply; - is stdout, as CSV.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

const SAMPLE_EXAMPLES: &str = "\
Examples:
  superquadric sample fit.json -n 5000 -o points.ply
  superquadric sample torus.json --by equal-distance -n 32 -o rows.csv
  superquadric sample fit.json -o - | superquadric fit - ";

impl SampleArgs {
    /// The spread that is meant.
    ///
    /// # Errors
    /// If the rows are to have too many steps, or a seed.
    pub fn spread(&self) -> Result<Spread, CliError> {
        let Some(parameterization) = self.by.parameterization() else {
            let count = self.number.unwrap_or(POINTS) as usize;
            return Ok(Spread::Area { count, seed: self.seed.unwrap_or(0) });
        };
        if self.seed.is_some() {
            return Err(CliError::SeedOfRows);
        }
        match self.number.unwrap_or(STEPS) {
            steps @ ..=MOST_STEPS => Ok(Spread::Rows { parameterization, steps: steps as usize }),
            steps => Err(CliError::Steps { most: MOST_STEPS, found: steps }),
        }
    }
}

/// How points are spread over a surface, as it is typed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(in crate::cli) enum SpreadArg {
    /// At random, uniform by area.
    #[default]
    Area,
    /// Rows at equal steps of latitude and longitude.
    Trigonometric,
    /// Rows at equal angles from the centre.
    AngleCentre,
    /// Rows at equal steps of the coordinate that changes faster.
    Explicit,
    /// Rows at equal distances.
    EqualDistance,
}

impl SpreadArg {
    fn parameterization(self) -> Option<Parameterization> {
        Some(match self {
            Self::Area => return None,
            Self::Trigonometric => Parameterization::Trigonometric,
            Self::AngleCentre => Parameterization::AngleCentre,
            Self::Explicit => Parameterization::Explicit,
            Self::EqualDistance => Parameterization::EqualDistance,
        })
    }
}

/// Tell where points lie to a model, a solid or a scene, a row each.
///
/// Columns are x y z, and inside, 1 or 0. Of one model, deformed or not, also inside_outside, which is
/// below 1 inside, and its gradient_x gradient_y gradient_z; of one that is not deformed the signed
/// radial_distance; of a superellipsoid with exponents up to 2 the signed euclidean_distance and the
/// nearest point, nearest_x nearest_y nearest_z. Of what is made of several, level, which is below 1
/// inside. Rows that are not finite are rows of NaN.
#[derive(Debug, clap::Args)]
#[command(after_help = EVALUATE_EXAMPLES)]
pub(in crate::cli) struct EvaluateArgs {
    /// A fit, a bare model, a solid or a scene, .json or .toml; - is stdin, for JSON.
    pub model: PathBuf,
    /// The points, in the world: PLY, PCD, NPY or text; - is stdin.
    pub points: PathBuf,
    /// File to write: .csv or .ply; - is stdout, as CSV.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

const EVALUATE_EXAMPLES: &str = "\
Examples:
  superquadric evaluate fit.json cloud.ply -o distances.csv
  superquadric evaluate scene.toml cloud.xyz -o inside.ply";

/// Write the dual of a model: the shape on which its normals lie (Barr 1981), at the origin.
///
/// That of a supertoroid is a superellipsoid, its tube's. The dual of the dual is the shape again, but
/// of a supertoroid, and of three exponents that differ. Exponents of 2 or more, of three 1 or less,
/// have none.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  superquadric dual model.json -o dual.json")]
pub(in crate::cli) struct DualArgs {
    /// A fit, or a bare model of any family, in JSON; - is stdin.
    pub model: PathBuf,
    /// File of the dual, in JSON; - is stdout.
    #[arg(short, long, value_name = "MODEL.json", default_value = "-")]
    pub output: PathBuf,
}
