//! A pose from the arguments of `superquadric.Superellipsoid`.

use nalgebra::{Matrix3, Vector3};
use pyo3::prelude::*;

use super::arrays::Doubles;
use super::errors::ModelError;
use crate::error::ModelError as CoreModelError;
use crate::pose::Pose;

/// The pose of a rotation in one of its two forms, or none, and of a centre, or none.
///
/// # Errors
/// [`ModelError`] if both forms are given, a number is not finite, or the matrix is not a
/// rotation; those of the arrays.
pub(super) fn pose_of(
    euler_zyz: Option<&Bound<'_, PyAny>>,
    rotation: Option<&Bound<'_, PyAny>>,
    translation: Option<&Bound<'_, PyAny>>,
) -> PyResult<Pose> {
    let translation = match translation {
        Some(translation) => finite_vector("translation", translation)?,
        None => Vector3::zeros(),
    };
    match (euler_zyz, rotation) {
        (None, None) => Ok(Pose::new(Default::default(), translation)),
        (Some(angles), None) => {
            let angles = finite_vector("euler_zyz", angles)?;
            Ok(Pose::from_euler_zyz(angles.into(), translation))
        }
        (None, Some(rotation)) => Ok(Pose::from_matrix(matrix(rotation)?, translation)?),
        (Some(_), Some(_)) => Err(ModelError::new_err("give euler_zyz or rotation, but not both")),
    }
}

fn finite_vector(name: &'static str, value: &Bound<'_, PyAny>) -> PyResult<Vector3<f64>> {
    let vector: Vector3<f64> = Doubles::new(name, value)?.vector()?.into();
    if vector.iter().all(|component| component.is_finite()) {
        Ok(vector)
    } else {
        Err(CoreModelError::NotFinite { what: name }.into())
    }
}

fn matrix(value: &Bound<'_, PyAny>) -> PyResult<Matrix3<f64>> {
    let matrix = Doubles::new("rotation", value)?;
    match matrix.shape() {
        [3, 3] => Ok(Matrix3::from_row_slice(matrix.values()?)),
        _ => Err(matrix.wrong_shape("(3, 3)")),
    }
}
