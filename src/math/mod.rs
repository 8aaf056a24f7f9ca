//! Special functions and elementary helpers; no geometry.

mod beta;
pub(crate) mod elementary;
pub(crate) mod elementary32;
mod gamma_variate;
mod maximum;
mod quadrature;
mod root;
mod signed_power;
pub(crate) mod vectorized;

pub use beta::beta;
pub(crate) use gamma_variate::GammaVariate;
pub(crate) use maximum::maximum;
pub(crate) use quadrature::integral_in_pieces;
pub(crate) use root::increasing_root;
pub use signed_power::signed_power;
