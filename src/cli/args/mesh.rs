//! How fine a mesh is to be.

use clap::ValueEnum;

use super::parse::{positive, resolution};
use crate::cli::error::CliError;
use crate::deform::Deformed;
use crate::shape::Shape;
use crate::surface::{
    Mesh, MeshMethod, Resolution, deformed_mesh, tessellate_deformed_within, tessellate_shape,
};

/// How fine a mesh is to be.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct FinenessArgs {
    /// Segments along each edge of the mesh's lattice (even); of a solid, a third of the cells
    /// along its longest side.
    #[arg(long, value_name = "N", default_value = "32", value_parser = resolution)]
    pub resolution: Resolution,
    /// Instead, the greatest distance of mesh and surface, in the model's unit.
    #[arg(long, value_name = "LENGTH", value_parser = positive, conflicts_with = "resolution")]
    pub tolerance: Option<f64>,
    /// How a mesh within a tolerance comes about.
    #[arg(long, value_enum, default_value_t, requires = "tolerance")]
    pub method: MethodArg,
}

impl FinenessArgs {
    /// The mesh of a shape, deformed or not, that is meant.
    ///
    /// # Errors
    /// If the tolerance is none for the shape.
    pub fn mesh(&self, solid: &Deformed<Shape>) -> Result<Mesh, CliError> {
        match self.tolerance {
            None => Ok(deformed_mesh(solid, &tessellate_shape(solid.shape(), self.resolution))),
            Some(tolerance) => {
                Ok(tessellate_deformed_within(solid, tolerance, self.method.into())?)
            }
        }
    }
}

/// A way to a mesh, as it is typed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(in crate::cli) enum MethodArg {
    /// A lattice, as fine everywhere as it must be somewhere.
    Lattice,
    /// The same with its lines closer where the surface bends (Barr 1981).
    Curvature,
    /// Triangles cut in two where normals diverge (Barr 1984): fewest triangles on sharp edges.
    #[default]
    Subdivision,
}

impl From<MethodArg> for MeshMethod {
    fn from(typed: MethodArg) -> Self {
        match typed {
            MethodArg::Lattice => Self::Lattice,
            MethodArg::Curvature => Self::Curvature,
            MethodArg::Subdivision => Self::Subdivision,
        }
    }
}
