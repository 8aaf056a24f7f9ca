//! Recovery of a shape from points of its surface.
//!
//! Read [`fit`] straight down: normalise, search on few points, finish on all, tell strays from
//! the surface, go by noise along a sensor's rays, canonical form, doubts.

mod alternation;
mod chart;
mod clutter;
mod compressed;
mod concentration;
mod constraints;
mod core_search;
mod covariance;
mod descent;
mod doubt;
mod ends;
mod error;
mod evidence;
mod fit;
mod found;
mod geometric;
mod kernel;
mod mixture;
mod neighbours;
mod normalization;
mod one_side;
mod options;
mod plane;
mod radial;
mod ray_noise;
mod result;
mod search;
mod sight;
#[cfg(feature = "internals")]
#[doc(hidden)]
pub mod stages;
mod start;
mod strays;
mod subset;
mod survey;
mod switches;
mod uncertainty;

pub use constraints::{Bounds, Constraints, Tie};
pub use covariance::Covariance;
pub use error::FitError;
pub use fit::{fit, fit_unless};
pub use geometric::geometric_row;
pub use options::{Distance, FitOptions, Precision};
pub use plane::Plane;
pub use radial::{PARAMETERS, Row, radial_row};
pub use result::{Doubt, Fit, RangeNoise, Termination};
pub use sight::{Sight, SightLine};
