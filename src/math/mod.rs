//! Special functions, intervals and elementary helpers; no geometry.

mod beta;
mod dual;
mod gamma_variate;
mod interval;
mod scalar;
mod signed_power;
mod superellipse_norm;
mod univariate;

pub use beta::beta;
pub use dual::Dual;
pub(crate) use gamma_variate::GammaVariate;
pub use interval::Interval;
pub use scalar::Scalar;
pub use signed_power::signed_power;
pub(crate) use superellipse_norm::superellipse_norm;
pub use univariate::Univariate;
