//! Surfaces as triangles and as points.

mod grading;
mod lattice;
mod mesh;
mod tessellate;

pub use mesh::Mesh;
pub use tessellate::{Resolution, ResolutionError, tessellate};
