//! Global deformations of space (B84 section 2): scaling, taper, twist and bend.
//!
//! A deformation maps a point `x` of the undeformed object to `X = F(x)`. Tangents follow by the
//! Jacobian `J`, normals by its cofactors `det J J^-T` (B84 Eq. 1.2a and appendix A), volumes by
//! `det J`, which is positive throughout a deformation's domain. Coordinates are in the object's
//! own unit. [`Deformed`] is a shape after a chain of deformations.

mod bend;
mod chain;
mod crease;
mod deformation;
mod deformed;
mod error;
mod local_to_global;
mod map;
mod profile;
mod scale;
mod taper;
mod twist;

pub use bend::Bend;
pub use chain::Chain;
pub use deformation::{Deformation, Kind};
pub use deformed::{Deformed, MassEstimate};
pub use error::DeformError;
pub use local_to_global::{
    JacobianField, curve_curvature, deformed_curve, zxz_curvatures, zxz_rotation,
};
pub use map::Deform;
pub use profile::{Line, Polyline, Profile, Spline};
pub use scale::Scale;
pub use taper::Taper;
pub use twist::Twist;

#[cfg(test)]
mod laws;
