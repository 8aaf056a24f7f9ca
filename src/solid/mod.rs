//! Solids in the world: posed, deformed primitives.

mod primitive;

pub use primitive::Primitive;
