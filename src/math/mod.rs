//! Special functions, intervals and elementary helpers; no geometry.

mod beta;
mod dual;
pub(crate) mod elementary;
pub(crate) mod elementary32;
mod gamma_variate;
mod gauss_kronrod;
mod half_space;
mod interval;
pub(crate) mod lane;
mod lane_sum;
mod least_eigenvalue;
mod maximum;
mod quadrature;
mod root;
mod scalar;
mod signed_power;
mod sloped;
mod superellipse_norm;
mod univariate;

pub use beta::beta;
pub use dual::Dual;
pub(crate) use gamma_variate::GammaVariate;
pub use gauss_kronrod::{VectorIntegral, integrate};
pub(crate) use half_space::{SHARE_ROUNDING, left_out, share_below};
pub use interval::Interval;
pub(crate) use lane_sum::{lane_dot, lane_sum};
pub(crate) use least_eigenvalue::least_eigenvalue;
pub(crate) use maximum::maximum;
pub(crate) use quadrature::{DOUBLE_EXPONENTIAL, double_exponential, integral_in_pieces};
pub(crate) use root::increasing_root;
pub use scalar::Scalar;
pub use signed_power::signed_power;
pub use sloped::Sloped;
pub(crate) use superellipse_norm::superellipse_norm;
pub use univariate::Univariate;
