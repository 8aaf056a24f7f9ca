//! Rays.

use nalgebra::Vector3;

use crate::math::{Dual, Scalar};
use crate::pose::Pose;

/// A half-line `origin + t direction`, t in units of the direction's length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Where it begins.
    pub origin: Vector3<f64>,
    /// Where it goes; of any length but 0.
    pub direction: Vector3<f64>,
}

impl Ray {
    /// The point at t.
    pub fn at(&self, t: f64) -> Vector3<f64> {
        self.origin + t * self.direction
    }

    /// The ray in the frame of a model that a pose takes to the ray's; t stays the same.
    pub(super) fn in_frame(&self, pose: &Pose) -> Self {
        let direction = pose.rotation().inverse_transform_vector(&self.direction);
        Self { origin: pose.model_from_world(&self.origin), direction }
    }

    /// The point at t or over a range of it, and its derivative.
    pub(super) fn over<N: Scalar>(&self, t: N) -> [Dual<N>; 3] {
        std::array::from_fn(|i| Dual {
            value: t * self.direction[i] + self.origin[i],
            slope: N::constant(self.direction[i]),
        })
    }

    /// The range of t within a box `[min, max]`, if the ray meets it.
    pub(super) fn clipped(&self, bounds: &[Vector3<f64>; 2]) -> Option<[f64; 2]> {
        self.clipped_within(bounds, [0.0, f64::INFINITY]).filter(|range| range[1].is_finite())
    }

    /// What of a range of t is within a box `[min, max]`.
    pub(super) fn clipped_within(
        &self,
        [min, max]: &[Vector3<f64>; 2],
        mut range: [f64; 2],
    ) -> Option<[f64; 2]> {
        for i in 0..3 {
            let is_parallel = self.direction[i] == 0.0;
            if is_parallel {
                if self.origin[i] < min[i] || self.origin[i] > max[i] {
                    return None;
                }
                continue;
            }
            let inverse = self.direction[i].recip();
            let ends = [min[i], max[i]].map(|end| (end - self.origin[i]) * inverse);
            range = [range[0].max(ends[0].min(ends[1])), range[1].min(ends[0].max(ends[1]))];
        }
        (range[0] <= range[1]).then_some(range)
    }
}
