//! What a solid of unit density weighs, and how that is spread.

use nalgebra::{Matrix3, Vector3};

use crate::pose::Pose;

/// Volume, centroid and second moments of a solid of unit density.
///
/// Lengths are in the unit of the shape; masses follow by a factor, the density.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    volume: f64,
    centroid: Vector3<f64>,
    second_moments: Matrix3<f64>,
}

impl MassProperties {
    /// Of a solid that is symmetric about the planes of its frame: its volume and the integrals
    /// of `x^2`, `y^2`, `z^2` over it.
    pub(crate) fn of_symmetric(volume: f64, squares: [f64; 3]) -> Self {
        let second_moments = Matrix3::from_diagonal(&squares.into());
        Self { volume, centroid: Vector3::zeros(), second_moments }
    }

    /// Of a solid by its volume and the integrals of `x` and of `x x'` over it.
    pub(crate) fn of_integrals(volume: f64, first: Vector3<f64>, second: Matrix3<f64>) -> Self {
        let centroid = first / volume;
        Self { volume, centroid, second_moments: second - first * centroid.transpose() }
    }

    /// The integral of 1 over the solid.
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// The centre of mass.
    pub fn centroid(&self) -> Vector3<f64> {
        self.centroid
    }

    /// The integral of `u u'` over the solid, u being the offset from the centroid.
    pub fn second_moments(&self) -> Matrix3<f64> {
        self.second_moments
    }

    /// The inertia tensor about the centroid, the integral of `u.u 1 - u u'` (JLS Eqs.
    /// 2.67-2.69), in the frame's axes.
    pub fn inertia(&self) -> Matrix3<f64> {
        inertia_of(&self.second_moments)
    }

    /// The inertia tensor about any point of the frame, by Steiner's theorem.
    pub fn inertia_about(&self, point: &Vector3<f64>) -> Matrix3<f64> {
        let offset = self.centroid - point;
        inertia_of(&(self.second_moments + offset * offset.transpose() * self.volume))
    }

    /// The same solid, moved by an offset.
    pub(crate) fn moved(&self, offset: &Vector3<f64>) -> Self {
        Self { centroid: self.centroid + offset, ..*self }
    }

    /// The same solid moved: from the model's frame to the world.
    pub fn transformed(&self, pose: &Pose) -> Self {
        let rotation = pose.rotation().matrix();
        Self {
            volume: self.volume,
            centroid: pose.world_from_model(&self.centroid),
            second_moments: rotation * self.second_moments * rotation.transpose(),
        }
    }
}

/// The tensor `tr(S) 1 - S` of second moments S.
fn inertia_of(second_moments: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(second_moments.trace()) - second_moments
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cuboid with edges 2, 4, 6.
    fn cuboid() -> MassProperties {
        MassProperties::of_symmetric(48.0, [16.0, 64.0, 144.0])
    }

    #[test]
    fn inertia_of_a_cuboid_is_the_textbooks() {
        let expected = Vector3::new(16.0 + 36.0, 4.0 + 36.0, 4.0 + 16.0) * 48.0 / 12.0;
        assert_eq!(cuboid().inertia(), Matrix3::from_diagonal(&expected));
        assert_eq!(cuboid().inertia_about(&Vector3::zeros()), cuboid().inertia());
    }

    #[test]
    fn about_a_corner_the_edges_count_four_times() {
        let about = cuboid().inertia_about(&Vector3::new(1.0, 2.0, 3.0));
        let diagonal = Vector3::new(52.0, 40.0, 20.0) * 48.0 / 3.0;
        let expected = Matrix3::new(
            diagonal.x,
            -2.0 * 48.0,
            -3.0 * 48.0,
            -2.0 * 48.0,
            diagonal.y,
            -6.0 * 48.0,
            -3.0 * 48.0,
            -6.0 * 48.0,
            diagonal.z,
        );
        assert!((about - expected).amax() < 1e-12);
    }

    #[test]
    fn a_motion_turns_the_tensor_and_moves_the_centroid() {
        let translation = Vector3::new(5.0, -3.0, 2.0);
        let pose = Pose::from_euler_zyz([0.3, 1.1, -0.8], translation);
        let moved = cuboid().transformed(&pose);
        let rotation = pose.rotation().matrix();
        let turned = rotation * cuboid().inertia() * rotation.transpose();
        assert!((moved.inertia() - turned).amax() < 1e-12);
        assert_eq!(moved.centroid(), translation);
        // About a point that moves along, the tensor only turns.
        let point = Vector3::new(1.0, 2.0, 3.0);
        let about = moved.inertia_about(&pose.world_from_model(&point));
        let turned = rotation * cuboid().inertia_about(&point) * rotation.transpose();
        assert!((about - turned).amax() < 1e-11);
    }
}
