//! Solids in the world: posed, deformed primitives, and what is made of them.

mod primitive;
mod tree;
mod volume;

pub use primitive::Primitive;
pub use tree::Tree;
pub use volume::volume_bounds;
