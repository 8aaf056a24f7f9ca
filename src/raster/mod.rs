//! Faster calculation of superquadric shapes (FB81): many points of a superellipsoid, one step
//! apart, written straight to where they are wanted, into a z-buffer or a vertex array, without
//! a list of points between.
//!
//! [`method`] holds the paper's six ways of calculating a point. What the library itself uses,
//! and why, stands in `docs/faster_calculation.md`.

mod height;
pub mod method;
mod scatter;
mod symmetry;
mod vertex_array;
mod z_buffer;

pub use height::{Placement, write_heights};
pub use scatter::scatter;
pub use symmetry::{octant_reflections, write_reflections};
pub use vertex_array::{VertexArray, write_product};
pub use z_buffer::{ZBuffer, ZBufferError};
