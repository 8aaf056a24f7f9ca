//! Models in the languages of other programs.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::ValueEnum;

use crate::exchange::{ExportFormat, ImportFormat};

/// Write a model for another program.
///
/// A shape that the program cannot express is an error that says why.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct ExportArgs {
    /// A fit or a bare model in JSON; - is stdin.
    pub model: PathBuf,
    /// The program.
    #[arg(long, value_name = "PROGRAM", value_enum)]
    pub to: ExportArg,
    /// File to write; - is stdout.
    #[arg(short, long, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,
}

/// Read a model of another program, or that of a mesh file of ours.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct ImportArgs {
    /// The file; - is stdin.
    pub file: PathBuf,
    /// What wrote it.
    #[arg(long, value_name = "PROGRAM", value_enum)]
    pub from: ImportArg,
    /// Which of several superquadrics, counted from 1.
    #[arg(long, value_name = "N")]
    pub number: Option<NonZeroUsize>,
    /// File of the model, in JSON; - is stdout.
    #[arg(short, long, value_name = "MODEL.json", default_value = "-")]
    pub output: PathBuf,
}

/// A program that is written for, as it is typed.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(in crate::cli) enum ExportArg {
    /// Python program for VTK 9.
    Vtk,
    /// Dump for OVITO.
    Ovito,
    /// Input script for LIGGGHTS (exponents up to 1).
    Liggghts,
    /// Data file for LAMMPS (exponents up to 1).
    Lammps,
    /// Particle of a MercuryDPM restart file (exponents up to 1).
    Mercury,
    /// Scene for POV-Ray 3.7 (exponents from 0.1).
    Pov,
    /// Parameters of EMS (Liu et al. 2022).
    Ems,
    /// JSON of SuperCompose.
    Supercompose,
}

impl From<ExportArg> for ExportFormat {
    fn from(typed: ExportArg) -> Self {
        match typed {
            ExportArg::Vtk => Self::Vtk,
            ExportArg::Ovito => Self::Ovito,
            ExportArg::Liggghts => Self::Liggghts,
            ExportArg::Lammps => Self::Lammps,
            ExportArg::Mercury => Self::Mercury,
            ExportArg::Pov => Self::Pov,
            ExportArg::Ems => Self::Ems,
            ExportArg::Supercompose => Self::SuperCompose,
        }
    }
}

/// What is read, as it is typed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ImportArg {
    /// Mesh file of ours: .ply, .obj, .stl or .glb.
    Mesh,
    /// Dump of OVITO.
    Ovito,
    /// Input script or dump of LIGGGHTS.
    Liggghts,
    /// Data file of LAMMPS.
    Lammps,
    /// Restart file of MercuryDPM.
    Mercury,
    /// Parameters of EMS (Liu et al. 2022).
    Ems,
    /// JSON of SuperCompose.
    Supercompose,
}

impl ImportArg {
    /// The format of a text, or none of a mesh.
    pub fn text_format(self) -> Option<ImportFormat> {
        Some(match self {
            Self::Mesh => return None,
            Self::Ovito => ImportFormat::Ovito,
            Self::Liggghts => ImportFormat::Liggghts,
            Self::Lammps => ImportFormat::Lammps,
            Self::Mercury => ImportFormat::Mercury,
            Self::Ems => ImportFormat::Ems,
            Self::Supercompose => ImportFormat::SuperCompose,
        })
    }
}
