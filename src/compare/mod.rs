//! The geometric difference of two models: parameters are ambiguous, solids are not.

mod labelling;
mod low_discrepancy;
mod nearest;
mod surface_distance;
mod volume_overlap;

pub use labelling::{rotation_error, size_error};
pub use surface_distance::{SurfaceDistance, surface_distance};
pub use volume_overlap::{VolumeOverlap, volume_overlap};

use nalgebra::{Rotation3, Vector3};

use crate::model::Model;

/// The motion from one model's frame to another's, without a detour through coordinates of the
/// world, which lose digits far from its origin.
#[derive(Debug, Clone, Copy)]
struct RelativePose {
    rotation: Rotation3<f64>,
    translation: Vector3<f64>,
}

impl RelativePose {
    /// The motion from the frame of `from` to that of `to`.
    fn new(to: &Model, from: &Model) -> Self {
        let inverse = to.pose.rotation().inverse();
        Self {
            rotation: inverse * from.pose.rotation(),
            translation: inverse * (from.pose.translation() - to.pose.translation()),
        }
    }

    fn apply(&self, x: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * x + self.translation
    }
}
