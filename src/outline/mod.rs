//! The outline of a solid of any family, deformed or not, as a camera sees it: its rim, what of
//! that the solid itself hides, and the boundary of its silhouette.

mod document;
mod facing;
mod rim_curve;
mod silhouette;
mod visibility;

pub use document::{ContourFormat, UnknownContourFormat};
pub use rim_curve::{RimCurve, rim_curves};
pub use silhouette::Outline;

#[cfg(test)]
mod tests;
