//! Derivatives of posed shapes of any family, on arrays, in the world's axes.

use nalgebra::{Matrix3, Vector3};
use pyo3::prelude::*;

use super::arrays::{Angles, Array, Doubles, map_angles_to_rows};
use crate::model::Model;
use crate::shape::{FundamentalForms, Parametric, Solid};

/// Tangents `r_eta, r_omega`, of shape (..., 2, 3).
pub(super) fn tangents<'py, S: Parametric + Sync>(
    model: &Model<S>,
    eta: Angles<'_, 'py>,
    omega: Angles<'_, 'py>,
) -> PyResult<Array<'py>> {
    let Model { shape, pose } = model;
    map_angles_to_rows(eta, omega, |eta, omega| {
        shape.tangents(eta, omega).map(|tangent| (pose.rotation() * tangent).into())
    })
}

/// Second derivatives `r_eta_eta, r_eta_omega, r_omega_omega`, of shape (..., 3, 3).
pub(super) fn second_derivatives<'py, S: Parametric + Sync>(
    model: &Model<S>,
    eta: Angles<'_, 'py>,
    omega: Angles<'_, 'py>,
) -> PyResult<Array<'py>> {
    let Model { shape, pose } = model;
    map_angles_to_rows(eta, omega, |eta, omega| {
        let derivatives = shape.second_derivatives(eta, omega);
        derivatives.map(|derivative| (pose.rotation() * derivative).into())
    })
}

/// One of the fundamental forms, of shape (..., 2, 2): the same in every pose.
pub(super) fn fundamental_form<'py>(
    surface: &(impl Parametric + Sync),
    eta: Angles<'_, 'py>,
    omega: Angles<'_, 'py>,
    which: impl Fn(&FundamentalForms) -> [f64; 3] + Sync,
) -> PyResult<Array<'py>> {
    map_angles_to_rows(eta, omega, |eta, omega| {
        symmetric(which(&FundamentalForms::at(surface, eta, omega)))
    })
}

/// The matrix of a quadratic form `a eta^2 + 2 b eta omega + c omega^2`.
fn symmetric([a, b, c]: [f64; 3]) -> [[f64; 2]; 2] {
    [[a, b], [b, c]]
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
