//! Special functions and elementary helpers; no geometry.

mod beta;
mod gamma_variate;
mod maximum;
mod quadrature;
mod signed_power;

pub use beta::beta;
pub(crate) use gamma_variate::GammaVariate;
pub(crate) use maximum::maximum;
pub(crate) use quadrature::{integral, integral_in_pieces};
pub use signed_power::signed_power;
