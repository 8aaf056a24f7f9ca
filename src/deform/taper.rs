//! Taper along the z axis (B84 section 2.2).

use nalgebra::{Matrix3, Vector3};

use super::error::DeformError;
use super::map::Deform;
use super::profile::Profile;
use crate::math::{Interval, Scalar, Univariate};

/// The taper `X = r x, Y = r y, Z = z` with `r = f(z)` (B84 Eq. 2.2a).
///
/// Domain: `f(z) > 0`. At `f(z) = 0` the map shrinks a plane to a point, and beyond it is
/// everted.
#[derive(Debug, Clone, PartialEq)]
pub struct Taper {
    profile: Profile,
}

impl Taper {
    /// The taper of a profile f.
    pub fn new(profile: impl Into<Profile>) -> Self {
        Self { profile: profile.into() }
    }

    /// The profile f.
    pub fn profile(&self) -> &Profile {
        &self.profile
    }
}

impl Deform for Taper {
    fn forward_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let r = z.through(&self.profile);
        [x * r, y * r, z]
    }

    /// B84 Eq. 2.2c.
    fn inverse_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let inverse = z.through(&self.profile).recip();
        [x * inverse, y * inverse, z]
    }

    fn check(&self, [_, _, z]: [Interval; 3]) -> Result<(), DeformError> {
        let radius = self.profile.value_range(z).lo();
        if radius > 0.0 {
            return Ok(());
        }
        Err(DeformError::TaperFolds { z: z.middle(), radius })
    }

    /// B84 Eq. 2.2b.
    fn jacobian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        let (r, slope) = (self.profile.value(x.z), self.profile.slope(x.z));
        Matrix3::new(r, 0.0, slope * x.x, 0.0, r, slope * x.y, 0.0, 0.0, 1.0)
    }

    /// `r^2`.
    fn determinant(&self, x: &Vector3<f64>) -> f64 {
        self.profile.value(x.z).powi(2)
    }

    fn normal_transform(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        let (r, slope) = (self.profile.value(x.z), self.profile.slope(x.z));
        let shear = -r * slope;
        Matrix3::new(r, 0.0, 0.0, 0.0, r, 0.0, shear * x.x, shear * x.y, r * r)
    }
}
