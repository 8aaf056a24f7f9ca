//! Everything that can end a command, each naming the file it is about.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::batch::BatchError;
use crate::cloud::ReadError;
use crate::error::ModelError;
use crate::exchange::{ExportError, ImportError};
use crate::outline::UnknownContourFormat;
use crate::output::OutputError;
use crate::recover::FitError;
use crate::report::{DocumentError, NotUniform, UnknownCurveFormat, UnknownPointTableFormat};
use crate::surface::ToleranceError;
use crate::surface::format::{InscriptionError, UnknownMeshFormat};
use crate::view::{ImageError, RimError};

/// Why a command has failed.
#[derive(Debug, Error)]
pub(super) enum CliError {
    #[error(transparent)]
    Cloud(#[from] ReadError),
    #[error("{name}: {source}")]
    Fit { name: String, source: FitError },
    #[error("cannot read {name}: {source}")]
    Input { name: String, source: io::Error },
    #[error("{name}: {source}")]
    Document { name: String, source: DocumentError },
    #[error("{name}: {source}")]
    Export { name: String, source: ExportError },
    #[error("{name}: {source}")]
    Import { name: String, source: ImportError },
    #[error("{name}: {source}")]
    Inscription { name: String, source: InscriptionError },
    #[error("{name}: holds {count} superquadrics; choose one with --number, 1 to {count}")]
    Number { name: String, count: usize },
    #[error(transparent)]
    Image(#[from] ImageError),
    #[error("{0}: has no camera; give one as --camera")]
    NoCamera(String),
    #[error("--depth needs a pinhole camera, not an orthographic one")]
    DepthOfParallel,
    #[error("--support auto needs --camera or --viewpoint: which side is up?")]
    NoUpside,
    #[error("{0}: no plane found that the object could stand on; give it as --support A,B,C,D")]
    NoPlane(String),
    #[error("{0} is for one cloud: run several one by one")]
    OneCloudOnly(&'static str),
    #[error("{}: no files there that end in {endings}", folder.display())]
    NoFiles { folder: PathBuf, endings: String },
    #[error("cannot make folder {}: {source}", folder.display())]
    Folder { folder: PathBuf, source: io::Error },
    #[error("{}: another file of that name comes before it, and results are named after files", .0.display())]
    SameName(PathBuf),
    #[error("{name}: {source}")]
    Rim { name: String, source: RimError },
    #[error(transparent)]
    ContourFormat(#[from] UnknownContourFormat),
    #[error(transparent)]
    CurveFormat(#[from] UnknownCurveFormat),
    #[error(transparent)]
    MeshFormat(#[from] UnknownMeshFormat),
    #[error(transparent)]
    PointTableFormat(#[from] UnknownPointTableFormat),
    #[error("{name}: {source}")]
    NotUniform { name: String, source: NotUniform },
    #[error("{0}: points are those of one model, this solid is made of several")]
    Several(String),
    #[error("--seed is for --by area: rows are not drawn at random")]
    SeedOfRows,
    #[error("--number {found}: rows have up to {most} steps to a quarter of a turn")]
    Steps { most: u32, found: u32 },
    #[error("model and points cannot both come from stdin")]
    OneStdin,
    #[error("{name}: has no dual, in which {source}")]
    Dual { name: String, source: ModelError },
    #[error(transparent)]
    Tolerance(#[from] ToleranceError),
    #[error("{0}: --tolerance is for one shape, this solid is made of several; take --resolution")]
    NoTolerance(String),
    #[error(transparent)]
    Output(#[from] OutputError),
    #[error(transparent)]
    Batch(#[from] BatchError),
    #[error("cannot start threads: {0}")]
    Threads(String),
    #[error("cannot write to stdout: {0}")]
    Stdout(io::Error),
}

impl CliError {
    /// Whether the reader of stdout has gone away.
    pub fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Stdout(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }
}
