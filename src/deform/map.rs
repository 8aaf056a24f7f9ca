//! What every deformation can be asked.

use nalgebra::{Matrix3, Vector3};

use super::error::DeformError;
use crate::math::{Interval, Scalar};

/// A deformation of space: its map, the inverse, and how tangents, normals and volumes change.
///
/// [`forward`](Self::forward) and [`inverse`](Self::inverse) take points; the forms `_of` take
/// any [`Scalar`] and do not look whether a point is of the domain.
pub trait Deform {
    /// The deformed point of `x`, whatever the domain.
    fn forward_of<S: Scalar>(&self, x: [S; 3]) -> [S; 3];

    /// The point whose deformed one is `x_deformed`, whatever the domain: a point outside it,
    /// where no point of the domain has that image.
    fn inverse_of<S: Scalar>(&self, x_deformed: [S; 3]) -> [S; 3];

    /// Makes sure that a box of points belongs to the domain, where the map is one to one and
    /// its determinant positive.
    ///
    /// # Errors
    /// If a point of the box does not belong to it, or lies within rounding of one that does not.
    fn check(&self, region: [Interval; 3]) -> Result<(), DeformError>;

    /// The Jacobian `dX_i / dx_j` at `x` (B84 Eq. 1.1b); it maps tangents.
    fn jacobian(&self, x: &Vector3<f64>) -> Matrix3<f64>;

    /// The determinant of the Jacobian at `x`: the local ratio of volumes.
    fn determinant(&self, x: &Vector3<f64>) -> f64;

    /// The cofactors `det J J^-T` of the Jacobian at `x`; they map normals times areas (B84
    /// appendix A).
    fn normal_transform(&self, x: &Vector3<f64>) -> Matrix3<f64>;

    /// The deformed point of `x`.
    ///
    /// # Errors
    /// If `x` is not of the domain.
    fn forward(&self, x: &Vector3<f64>) -> Result<Vector3<f64>, DeformError> {
        self.check(point(x))?;
        Ok(self.forward_of((*x).into()).into())
    }

    /// The point of the domain whose deformed one is `x_deformed`.
    ///
    /// # Errors
    /// If there is none.
    fn inverse(&self, x_deformed: &Vector3<f64>) -> Result<Vector3<f64>, DeformError> {
        let x = self.inverse_of((*x_deformed).into()).into();
        self.check(point(&x))?;
        Ok(x)
    }
}

/// A point as a box.
pub(super) fn point(x: &Vector3<f64>) -> [Interval; 3] {
    [Interval::point(x.x), Interval::point(x.y), Interval::point(x.z)]
}
