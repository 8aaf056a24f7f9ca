//! Surfaces as triangles and as points.

mod boundary;
mod deformed;
pub mod format;
mod grading;
mod lattice;
mod mesh;
mod parameterization;
mod sample;
mod tessellate;

pub use boundary::boundary_mesh;
pub use deformed::{sample_deformed_surface, tessellate_deformed};
pub use mesh::Mesh;
pub use parameterization::Parameterization;
pub use sample::{sample_solid, sample_surface};
pub use tessellate::{Resolution, ResolutionError, tessellate};
