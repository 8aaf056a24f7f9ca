//! Special functions and elementary helpers; no geometry.

mod beta;
pub(crate) mod elementary;
pub(crate) mod elementary32;
mod gamma_variate;
mod signed_power;
pub(crate) mod vectorized;

pub use beta::beta;
pub(crate) use gamma_variate::GammaVariate;
pub use signed_power::signed_power;
