//! Shapes in their own frame, a file per family.

mod gauge;
mod superellipsoid;

pub(crate) use gauge::{GaugeTerms, superellipse_norm};
pub use superellipsoid::Superellipsoid;
