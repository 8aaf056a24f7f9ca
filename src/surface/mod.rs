//! Surfaces as triangles and as points.

mod boundary;
mod deformed;
mod deviation;
mod families;
pub mod format;
mod grading;
mod lattice;
mod mesh;
mod parameterization;
mod sample;
mod subdivision;
mod tessellate;
mod tolerance;

pub use boundary::boundary_mesh;
pub use deformed::{deformed_mesh, sample_deformed_surface, tessellate_deformed};
pub(crate) use families::bowls::place as bowl_place;
pub use families::tessellate_shape;
pub use mesh::Mesh;
pub use parameterization::Parameterization;
pub use sample::{sample_solid, sample_surface};
pub(crate) use tessellate::flattened_cube_point;
pub use tessellate::{Resolution, ResolutionError, tessellate};
pub use tolerance::{MeshMethod, ToleranceError, tessellate_within};
