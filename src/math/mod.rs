//! Special functions and elementary helpers; no geometry.

mod beta;
mod signed_power;

pub use beta::beta;
pub use signed_power::signed_power;
