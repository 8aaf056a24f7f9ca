//! Shapes in their own frame, a file per family.

mod gauge;
mod superellipsoid;

pub(crate) use gauge::{GaugeTerms, LOG_FLOOR, TINY, superellipse_norm};
pub use superellipsoid::Superellipsoid;
