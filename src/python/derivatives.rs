//! Derivatives of posed shapes of any family, on arrays, in the world's axes.

use nalgebra::{Matrix3, Vector3};
use pyo3::prelude::*;

use super::arrays::{Array, Doubles, map_angles_to};
use crate::model::Model;
use crate::shape::{Parametric, Solid};

/// Tangents `r_eta, r_omega`, of shape (..., 2, 3).
pub(super) fn tangents<'py, S: Parametric + Sync>(
    model: &Model<S>,
    eta: &Bound<'py, PyAny>,
    omega: &Bound<'py, PyAny>,
) -> PyResult<Array<'py>> {
    let Model { shape, pose } = model;
    map_angles_to(eta, omega, |eta, omega| {
        shape.tangents(eta, omega).map(|tangent| pose.rotation() * tangent)
    })
}

/// Second derivatives `r_eta_eta, r_eta_omega, r_omega_omega`, of shape (..., 3, 3).
pub(super) fn second_derivatives<'py, S: Parametric + Sync>(
    model: &Model<S>,
    eta: &Bound<'py, PyAny>,
    omega: &Bound<'py, PyAny>,
) -> PyResult<Array<'py>> {
    let Model { shape, pose } = model;
    map_angles_to(eta, omega, |eta, omega| {
        shape.second_derivatives(eta, omega).map(|derivative| pose.rotation() * derivative)
    })
}

/// Second derivatives of F by the coordinates of points of shape (..., 3), of shape (..., 3, 3).
pub(super) fn hessian<'py, S: Solid + Sync>(
    model: &Model<S>,
    points: &Bound<'py, PyAny>,
) -> PyResult<Array<'py>> {
    let Model { shape, pose } = model;
    let rotation = pose.rotation().matrix();
    Doubles::new("points", points)?.map_rows_to_squares(points.py(), |x_world: &Vector3<f64>| {
        let hessian: Matrix3<f64> = shape.inside_outside_hessian(&pose.model_from_world(x_world));
        rotation * hessian * rotation.transpose()
    })
}
