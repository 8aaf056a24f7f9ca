//! Surfaces as triangles and as points.

mod boundary;
mod chart;
mod covering;
mod deformed;
mod deviation;
mod families;
pub mod format;
mod grading;
mod lattice;
mod mesh;
mod parameterization;
mod patches;
mod product;
mod sample;
mod sheet;
mod subdivision;
mod tessellate;
mod tolerance;

pub use boundary::boundary_mesh;
pub(crate) use chart::{flattened_cube_point, within_rim};
pub use deformed::{deformed_mesh, sample_deformed_surface, tessellate_deformed};
pub use families::{sample_shape_surface, tessellate_shape};
pub use mesh::Mesh;
pub use parameterization::Parameterization;
pub use product::spherical_product_mesh;
pub use sample::{sample_solid, sample_surface};
pub(crate) use sheet::{ChartSheet, GridSheet, Sheet};
pub use tessellate::{Resolution, ResolutionError, tessellate};
pub use tolerance::{MeshMethod, ToleranceError, tessellate_deformed_within, tessellate_within};
