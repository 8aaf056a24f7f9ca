//! Superquadrics: recovery from range points, and their geometry.

pub(crate) mod canonical;
pub mod cloud;
pub mod compare;
pub mod error;
pub mod math;
pub mod model;
pub mod output;
pub mod pose;
#[cfg(feature = "python")]
mod python;
pub mod recover;
pub mod report;
pub mod shape;
pub mod surface;
