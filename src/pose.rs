//! Rigid motion from the model's frame to the world (JLS Eqs. 2.29-2.34).

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::error::ModelError;
use crate::math::Scalar;

/// Largest departure of `R' R` from the identity that still counts as a rotation: a matrix
/// written with eight digits passes.
const ORTHONORMALITY_TOLERANCE: f64 = 1e-6;

/// Largest departure of a matrix whose entries are a rotation's, rounded: it is taken as it is,
/// so that a rotation that was written comes back the same.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Largest `sin(theta)` at which the Euler angles phi and psi cannot be told apart any more:
/// the entries that separate them are then within rounding of zero.
const GIMBAL_TOLERANCE: f64 = 1e-12;

/// Position and orientation: `x_world = R x_model + p`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    rotation: Rotation3<f64>,
    translation: Vector3<f64>,
}

impl Pose {
    /// The motion that changes nothing.
    pub fn identity() -> Self {
        Self::new(Rotation3::identity(), Vector3::zeros())
    }

    /// A pose of a rotation (model to world) and the model's centre in the world.
    pub fn new(rotation: Rotation3<f64>, translation: Vector3<f64>) -> Self {
        Self { rotation, translation }
    }

    /// A pose of Euler angles ZYZ, in radians, and the model's centre: `R = Rz(phi) Ry(theta)
    /// Rz(psi)` (JLS Eq. 2.34, with its second row as in Paul 1981).
    pub fn from_euler_zyz([phi, theta, psi]: [f64; 3], translation: Vector3<f64>) -> Self {
        let z = Vector3::z_axis();
        let y = Vector3::y_axis();
        let rotation = Rotation3::from_axis_angle(&z, phi)
            * Rotation3::from_axis_angle(&y, theta)
            * Rotation3::from_axis_angle(&z, psi);
        Self::new(rotation, translation)
    }

    /// A pose of a rotation matrix, made orthonormal to rounding, and the model's centre.
    ///
    /// # Errors
    /// If the matrix is not a proper rotation to within 1e-6.
    pub fn from_matrix(
        matrix: Matrix3<f64>,
        translation: Vector3<f64>,
    ) -> Result<Self, ModelError> {
        let defect = (matrix.transpose() * matrix - Matrix3::identity()).amax();
        // Written so that NaN is refused too.
        let is_rotation = defect <= ORTHONORMALITY_TOLERANCE && matrix.determinant() > 0.0;
        if !is_rotation {
            return Err(ModelError::NotARotation { defect });
        }
        let is_rounded = defect <= ROUNDING;
        let rotation = if is_rounded {
            Rotation3::from_matrix_unchecked(matrix)
        } else {
            orthonormalized(matrix)
        };
        Ok(Self::new(rotation, translation))
    }

    /// The rotation from model to world; its columns are the model's axes in the world.
    pub fn rotation(&self) -> &Rotation3<f64> {
        &self.rotation
    }

    /// The model's centre in the world.
    pub fn translation(&self) -> &Vector3<f64> {
        &self.translation
    }

    /// Euler angles ZYZ `[phi, theta, psi]`: phi and psi in (-pi, pi], theta in [0, pi].
    ///
    /// Where theta is 0 or pi only phi + psi or phi - psi is determined, and psi is 0.
    pub fn euler_zyz(&self) -> [f64; 3] {
        let m = self.rotation.matrix();
        let sin_theta = m[(0, 2)].hypot(m[(1, 2)]);
        if sin_theta <= GIMBAL_TOLERANCE {
            let upright = m[(2, 2)].signum();
            let theta = if upright > 0.0 { 0.0 } else { std::f64::consts::PI };
            return [(upright * m[(1, 0)]).atan2(m[(1, 1)]), theta, 0.0];
        }
        let theta = sin_theta.atan2(m[(2, 2)]);
        [m[(1, 2)].atan2(m[(0, 2)]), theta, m[(2, 1)].atan2(-m[(2, 0)])]
    }

    /// The motion back.
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.inverse();
        Self::new(rotation, -(rotation * self.translation))
    }

    /// This motion after another one.
    pub fn after(&self, first: &Self) -> Self {
        let translation = self.world_from_model(&first.translation);
        Self::new(self.rotation * first.rotation, translation)
    }

    /// A point of the model's frame, in the world.
    pub fn world_from_model(&self, x_model: &Vector3<f64>) -> Vector3<f64> {
        self.rotation * x_model + self.translation
    }

    /// A point of the world, in the model's frame.
    pub fn model_from_world(&self, x_world: &Vector3<f64>) -> Vector3<f64> {
        self.rotation.inverse_transform_vector(&(x_world - self.translation))
    }

    /// [`world_from_model`](Self::world_from_model) in any numbers.
    pub(crate) fn world_from_model_of<S: Scalar>(&self, x_model: [S; 3]) -> [S; 3] {
        let turned = turned(self.rotation.matrix(), x_model);
        std::array::from_fn(|i| turned[i] + self.translation[i])
    }

    /// [`model_from_world`](Self::model_from_world) in any numbers.
    pub(crate) fn model_from_world_of<S: Scalar>(&self, x_world: [S; 3]) -> [S; 3] {
        let offset = std::array::from_fn(|i| x_world[i] + -self.translation[i]);
        turned(&self.rotation.matrix().transpose(), offset)
    }
}

/// A matrix times a vector in any numbers.
fn turned<S: Scalar>(matrix: &Matrix3<f64>, x: [S; 3]) -> [S; 3] {
    std::array::from_fn(|i| x[0] * matrix[(i, 0)] + x[1] * matrix[(i, 1)] + x[2] * matrix[(i, 2)])
}

/// The rotation nearest to an almost orthonormal matrix.
fn orthonormalized(matrix: Matrix3<f64>) -> Rotation3<f64> {
    let svd = matrix.svd(true, true);
    match (svd.u, svd.v_t) {
        (Some(u), Some(v_t)) => Rotation3::from_matrix_unchecked(u * v_t),
        _ => Rotation3::from_matrix_unchecked(matrix),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    /// A few products of sines and cosines, each of relative rounding 1e-16.
    const TOLERANCE: f64 = 1e-14;

    fn angles() -> Vec<[f64; 3]> {
        let values = [-3.0, -FRAC_PI_2, -0.4, 0.0, 0.7, FRAC_PI_2, 3.1];
        let mut all = Vec::new();
        for phi in values {
            for theta in [0.0, 1e-6, 0.5, FRAC_PI_2, 2.0, PI - 1e-6, PI] {
                all.extend(values.map(|psi| [phi, theta, psi]));
            }
        }
        all
    }

    #[test]
    fn matrix_is_that_of_jls_2_34() {
        for [phi, theta, psi] in angles() {
            let (sf, cf) = phi.sin_cos();
            let (st, ct) = theta.sin_cos();
            let (sp, cp) = psi.sin_cos();
            let printed = Matrix3::new(
                cf * ct * cp - sf * sp,
                -cf * ct * sp - sf * cp,
                cf * st,
                sf * ct * cp + cf * sp,
                -sf * ct * sp + cf * cp,
                sf * st,
                -st * cp,
                st * sp,
                ct,
            );
            let pose = Pose::from_euler_zyz([phi, theta, psi], Vector3::zeros());
            assert!((pose.rotation().matrix() - printed).amax() < TOLERANCE);
        }
    }

    #[test]
    fn euler_angles_give_back_the_rotation() {
        for angles in angles() {
            let pose = Pose::from_euler_zyz(angles, Vector3::zeros());
            let [phi, theta, psi] = pose.euler_zyz();
            assert!(phi.abs() <= PI && psi.abs() <= PI && (0.0..=PI).contains(&theta));
            let again = Pose::from_euler_zyz([phi, theta, psi], Vector3::zeros());
            let error = (again.rotation().matrix() - pose.rotation().matrix()).amax();
            assert!(error < TOLERANCE, "{angles:?}: {error}");
        }
    }

    #[test]
    fn a_rotation_comes_back_from_its_matrix_unchanged_and_a_written_one_orthonormal() {
        for angles in angles() {
            let pose = Pose::from_euler_zyz(angles, Vector3::zeros());
            let matrix = *pose.rotation().matrix();
            assert_eq!(Pose::from_matrix(matrix, Vector3::zeros()), Ok(pose));
            let written = matrix.map(|entry| (entry * 1e8).round() * 1e-8);
            let read = Pose::from_matrix(written, Vector3::zeros()).unwrap();
            let read = read.rotation().matrix();
            assert!((read.transpose() * read - Matrix3::identity()).amax() < TOLERANCE);
            assert!((read - matrix).amax() < 1e-7);
        }
    }

    #[test]
    fn model_from_world_inverts_world_from_model() {
        let pose = Pose::from_euler_zyz([0.3, 1.2, -2.0], Vector3::new(5.0, -3.0, 0.25));
        let x_model = Vector3::new(0.1, -0.7, 2.0);
        let back = pose.model_from_world(&pose.world_from_model(&x_model));
        assert!((back - x_model).norm() < 10.0 * TOLERANCE);
    }

    #[test]
    fn motions_follow_each_other() {
        let first = Pose::from_euler_zyz([0.3, 1.2, -2.0], Vector3::new(5.0, -3.0, 0.25));
        let second = Pose::from_euler_zyz([-1.0, 0.4, 0.7], Vector3::new(0.1, 2.0, -4.0));
        let x = Vector3::new(0.1, -0.7, 2.0);
        let expected = second.world_from_model(&first.world_from_model(&x));
        let found = second.after(&first).world_from_model(&x);
        assert!((found - expected).norm() < 10.0 * TOLERANCE);
    }

    #[test]
    fn a_reflection_and_a_scaling_are_refused() {
        for diagonal in [[1.0, 1.0, -1.0], [2.0, 1.0, 1.0], [f64::NAN, 1.0, 1.0]] {
            let matrix = Matrix3::from_diagonal(&Vector3::from(diagonal));
            assert!(Pose::from_matrix(matrix, Vector3::zeros()).is_err());
        }
    }
}
