//! Twist about the z axis (B84 section 2.3).

use nalgebra::{Matrix3, Vector3};

use super::error::DeformError;
use super::map::Deform;
use super::profile::Profile;
use crate::math::{Interval, Scalar, Univariate};

/// The twist by `theta = f(z)` radians: every plane across the z axis turns about it (B84 Eq.
/// 2.3a). Domain: all points; volumes stay.
#[derive(Debug, Clone, PartialEq)]
pub struct Twist {
    profile: Profile,
}

impl Twist {
    /// The twist of a profile f, in radians.
    pub fn new(profile: impl Into<Profile>) -> Self {
        Self { profile: profile.into() }
    }

    /// The profile f, in radians.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }
}

impl Deform for Twist {
    fn forward_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let (s, c) = z.through(&self.profile).sin_cos();
        [x * c - y * s, x * s + y * c, z]
    }

    /// B84 Eq. 2.3b: a twist in the opposite direction.
    fn inverse_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let (s, c) = z.through(&self.profile).sin_cos();
        [x * c + y * s, y * c - x * s, z]
    }

    fn check(&self, _: [Interval; 3]) -> Result<(), DeformError> {
        Ok(())
    }

    fn jacobian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        let (s, c) = self.profile.value(x.z).sin_cos();
        let rate = self.profile.slope(x.z);
        let (turn_x, turn_y) = (-(x.x * s + x.y * c) * rate, (x.x * c - x.y * s) * rate);
        Matrix3::new(c, -s, turn_x, s, c, turn_y, 0.0, 0.0, 1.0)
    }

    fn determinant(&self, _: &Vector3<f64>) -> f64 {
        1.0
    }

    fn normal_transform(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        let (s, c) = self.profile.value(x.z).sin_cos();
        let rate = self.profile.slope(x.z);
        Matrix3::new(c, -s, 0.0, s, c, 0.0, x.y * rate, -x.x * rate, 1.0)
    }
}
