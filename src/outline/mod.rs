//! The outline of a solid of any family, deformed or not, or of several, as a camera sees it: the
//! rim, what of that is hidden, and the boundary of the silhouette.

mod axes;
mod curve;
mod document;
mod facing;
#[cfg(feature = "overlay")]
mod overlay;
mod part;
mod path;
mod polish;
mod residual;
mod rim_curve;
mod silhouette;
mod trace;
mod visibility;
mod wireframe;

pub use axes::axes;
pub use document::{ContourFormat, UnknownContourFormat};
#[cfg(feature = "overlay")]
pub use overlay::Picture;
pub use residual::Residual;
pub use rim_curve::{RimCurve, rim_curves};
pub use silhouette::Outline;
pub use wireframe::Wireframe;

#[cfg(test)]
mod tests;
