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

use std::ops::RangeInclusive;

use crate::model::Model;
use crate::shape::Shape;

/// A program that a model is written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ExportFormat {
    /// VTK 9: a Python program that builds the surface by either of its sources. Supertoroids
    /// too.
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

    /// The name that the program goes by, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Vtk => "vtk",
            Self::Ovito => "ovito",
            Self::Liggghts => "liggghts",
            Self::Lammps => "lammps",
            Self::Mercury => "mercury",
            Self::Pov => "pov",
            Self::Ems => "ems",
            Self::SuperCompose => "supercompose",
        }
    }

    /// The text that makes this model in the program. Numbers read back as the same doubles.
    ///
    /// # Errors
    /// If the program cannot express the shape: another family than the superellipsoid (VTK has
    /// the supertoroid too), or exponents outside its range.
    pub fn text(self, model: impl Into<Model<Shape>>) -> Result<String, ExportError> {
        let Model { shape, pose } = model.into();
        let model = match shape {
            Shape::Superellipsoid(shape) => Model { shape, pose },
            Shape::Supertoroid(shape) if self == Self::Vtk => {
                return vtk::write_toroid(&shape, &pose);
            }
            _ => {
                let (program, family) = (self.title(), shape.family());
                return Err(ExportError::Family { program, family });
            }
        };
        self.require_exponents(&model)?;
        Ok(match self {
            Self::Vtk => vtk::write(&model),
            Self::Ovito => ovito::write(&model),
            Self::Liggghts => liggghts::write(&model),
            Self::Lammps => lammps::write(&model),
            Self::Mercury => mercury::write(&model),
            Self::Pov => pov::write(&model),
            Self::Ems => ems::write(&model),
            Self::SuperCompose => supercompose::write(&model),
        })
    }

    /// Makes sure that the program takes both exponents.
    fn require_exponents(self, model: &Model) -> Result<(), ExportError> {
        let range = self.exponents();
        let exponents = model.shape.exponents();
        match exponents.iter().position(|e| !range.contains(e)) {
            Some(index) => Err(ExportError::Exponent {
                program: self.title(),
                least: *range.start(),
                greatest: *range.end(),
                index,
                value: exponents[index],
            }),
            None => Ok(()),
        }
    }

    /// The exponents that the program takes: contact solvers need convex, smooth solids, and
    /// POV-Ray's root finder loses the surface of sharper ones.
    fn exponents(self) -> RangeInclusive<f64> {
        match self {
            Self::Liggghts | Self::Lammps | Self::Mercury => 0.0..=1.0,
            Self::Pov => 0.1..=f64::INFINITY,
            Self::Vtk | Self::Ovito | Self::Ems | Self::SuperCompose => 0.0..=f64::INFINITY,
        }
    }

    /// The program's name as it writes it.
    fn title(self) -> &'static str {
        match self {
            Self::Vtk => "VTK",
            Self::Ovito => "OVITO",
            Self::Liggghts => "LIGGGHTS",
            Self::Lammps => "LAMMPS",
            Self::Mercury => "MercuryDPM",
            Self::Pov => "POV-Ray",
            Self::Ems => "EMS",
            Self::SuperCompose => "SuperCompose",
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

    /// The name that the program goes by, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ovito => "ovito",
            Self::Liggghts => "liggghts",
            Self::Lammps => "lammps",
            Self::Mercury => "mercury",
            Self::Ems => "ems",
            Self::SuperCompose => "supercompose",
        }
    }

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
