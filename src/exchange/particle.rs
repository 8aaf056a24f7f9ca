//! A model as programs for particles describe it: semi-axes, blockiness, quaternion, centre.

use nalgebra::{Quaternion, Rotation3, UnitQuaternion};

use super::error::ImportError;
use super::line::Line;
use crate::error::ModelError;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Superellipsoid;

/// What is read of a particle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Particle {
    pub semi_axes: [f64; 3],
    pub exponents: [f64; 2],
    /// Of any length but zero.
    pub quaternion_wxyz: [f64; 4],
    pub centre: [f64; 3],
}

impl Particle {
    /// The model, of a particle that stands on a line.
    pub fn model(&self, line: &Line<'_>) -> Result<Model, ImportError> {
        let outside =
            |source| ImportError::Parameters { place: format!("line {}", line.number), source };
        let shape = Superellipsoid::new(self.semi_axes, self.exponents).map_err(outside)?;
        let [w, x, y, z] = self.quaternion_wxyz;
        // Scaled first, so that no square overflows or vanishes.
        let greatest = [w, x, y, z].iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        if greatest == 0.0 {
            return Err(outside(ModelError::NotARotation { defect: 1.0 }));
        }
        let [w, x, y, z] = [w, x, y, z].map(|component| component / greatest);
        let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
        Ok(Model { shape, pose: Pose::new(Rotation3::from(rotation), self.centre.into()) })
    }
}

/// The quaternion of the rotation from model to world.
pub(super) fn quaternion_wxyz(model: &Model) -> [f64; 4] {
    let rotation = UnitQuaternion::from_rotation_matrix(model.pose.rotation());
    [rotation.w, rotation.i, rotation.j, rotation.k]
}

/// Blockiness `n = 2 / e`, and back: it is its own inverse.
pub(super) fn blockiness(exponents: [f64; 2]) -> [f64; 2] {
    exponents.map(|e| 2.0 / e)
}

/// Numbers between spaces, in the fewest digits that read back as the same doubles.
pub(super) fn spaced(numbers: &[f64]) -> String {
    joined(numbers, " ")
}

/// Numbers with something between them, in digits that read back as the same doubles.
pub(super) fn joined(numbers: &[f64], separator: &str) -> String {
    numbers.iter().map(|number| format!("{number:?}")).collect::<Vec<_>>().join(separator)
}
