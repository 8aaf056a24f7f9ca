//! Models in the languages of other programs, a file a program.
//!
//! What a program cannot express is an [`ExportError`], never another shape. Texts of others are
//! read with the same care: an [`ImportError`] names the place and what was expected there.
//! `docs/exchange.md` tells every mapping and its limits.

mod dump;
mod ems;
mod error;
mod lammps;
mod liggghts;
mod line;
mod mercury;
mod ovito;
mod particle;
mod pov;
mod supercompose;
mod vtk;

pub use error::{ExportError, ImportError};

use crate::model::Model;

/// A program that a model is written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ExportFormat {
    /// VTK 9: a Python program that builds `vtkSuperquadricSource` and
    /// `vtkParametricSuperEllipsoid`.
    Vtk,
    /// OVITO: a dump whose columns it takes for its own properties.
    Ovito,
    /// LIGGGHTS: commands of an input script. Exponents up to 1.
    Liggghts,
    /// LAMMPS: a data file for `atom_style ellipsoid superellipsoid`. Exponents up to 1.
    Lammps,
    /// MercuryDPM: the particles of a restart file. Exponents up to 1.
    Mercury,
    /// POV-Ray 3.7: a scene. Exponents from 0.1.
    Pov,
    /// EMS (Liu et al. 2022): its eleven parameters on a line.
    Ems,
    /// SuperCompose: its JSON.
    SuperCompose,
}

impl ExportFormat {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Vtk,
        Self::Ovito,
        Self::Liggghts,
        Self::Lammps,
        Self::Mercury,
        Self::Pov,
        Self::Ems,
        Self::SuperCompose,
    ];

    /// The text that makes this model in the program. Numbers read back as the same doubles.
    ///
    /// # Errors
    /// If the program cannot express the shape.
    pub fn text(self, model: &Model) -> Result<String, ExportError> {
        match self {
            Self::Vtk => Ok(vtk::write(model)),
            Self::Ovito => Ok(ovito::write(model)),
            Self::Liggghts => liggghts::write(model),
            Self::Lammps => lammps::write(model),
            Self::Mercury => mercury::write(model),
            Self::Pov => pov::write(model),
            Self::Ems => Ok(ems::write(model)),
            Self::SuperCompose => Ok(supercompose::write(model)),
        }
    }
}

/// A program whose texts are read. Those of VTK and POV-Ray are programs, and are not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ImportFormat {
    /// OVITO: the last snapshot of a dump.
    Ovito,
    /// LIGGGHTS: commands of an input script, or the last snapshot of a dump.
    Liggghts,
    /// LAMMPS: a data file.
    Lammps,
    /// MercuryDPM: a restart file.
    Mercury,
    /// EMS (Liu et al. 2022): eleven parameters a line.
    Ems,
    /// SuperCompose: its JSON.
    SuperCompose,
}

impl ImportFormat {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Ovito, Self::Liggghts, Self::Lammps, Self::Mercury, Self::Ems, Self::SuperCompose];

    /// The models of a text, in its order: at least one.
    ///
    /// # Errors
    /// If the text is of another format, holds no superquadric, or one whose parameters are
    /// outside their domain.
    pub fn models(self, text: &str) -> Result<Vec<Model>, ImportError> {
        let (models, expected) = match self {
            Self::Ovito => (ovito::read(text)?, ovito::EXPECTED),
            Self::Liggghts => (liggghts::read(text)?, liggghts::EXPECTED),
            Self::Lammps => (lammps::read(text)?, lammps::EXPECTED),
            Self::Mercury => (mercury::read(text)?, mercury::EXPECTED),
            Self::Ems => (ems::read(text)?, ems::EXPECTED),
            Self::SuperCompose => (supercompose::read(text)?, supercompose::EXPECTED),
        };
        if models.is_empty() { Err(ImportError::None(expected)) } else { Ok(models) }
    }
}
