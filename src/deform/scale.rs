//! Scaling along the axes (B84 section 2.1).

use nalgebra::{Matrix3, Vector3};

use super::error::DeformError;
use super::map::Deform;
use crate::math::{Interval, Scalar};

/// The scaling `X = a1 x, Y = a2 y, Z = a3 z` (B84 Eq. 2.1a). Domain: all points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    factors: [f64; 3],
}

impl Scale {
    /// The scaling by three factors.
    ///
    /// # Errors
    /// If one of them is not a positive, finite number.
    pub fn new(factors: [f64; 3]) -> Result<Self, DeformError> {
        match factors.into_iter().find(|&factor| !(factor > 0.0 && factor.is_finite())) {
            Some(found) => {
                let (what, expected) = ("a factor of a scaling", "a positive number");
                Err(DeformError::Parameter { what, expected, found })
            }
            None => Ok(Self { factors }),
        }
    }

    /// The three factors.
    pub fn factors(&self) -> [f64; 3] {
        self.factors
    }
}

impl Deform for Scale {
    fn forward_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let [a1, a2, a3] = self.factors;
        [x * a1, y * a2, z * a3]
    }

    fn inverse_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        let [a1, a2, a3] = self.factors.map(|factor| S::constant(factor).recip());
        [x * a1, y * a2, z * a3]
    }

    fn check(&self, _: [Interval; 3]) -> Result<(), DeformError> {
        Ok(())
    }

    /// B84 Eq. 2.1b.
    fn jacobian(&self, _: &Vector3<f64>) -> Matrix3<f64> {
        Matrix3::from_diagonal(&self.factors.into())
    }

    fn determinant(&self, _: &Vector3<f64>) -> f64 {
        self.factors.iter().product()
    }

    fn normal_transform(&self, _: &Vector3<f64>) -> Matrix3<f64> {
        let [a1, a2, a3] = self.factors;
        Matrix3::from_diagonal(&Vector3::new(a2 * a3, a1 * a3, a1 * a2))
    }
}
