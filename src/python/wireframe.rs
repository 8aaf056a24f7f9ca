//! `superquadric.wireframe`.

use pyo3::prelude::*;

use super::arrays::{Array, shaped};
use super::solid::model_of;
use super::view::PyCamera;
use crate::view::Wireframe;

/// Lines on the surface of a model as a camera sees them.
///
/// They are those of a grid on a box of the model's semi-axes, projected from the centre.
///
/// Args:
///     model: the model or the fit, in the camera's frame, with exponents up to 2.
///     camera: the camera.
///
/// Returns:
///     The lines that are seen and those that the model hides, two lists of arrays (column, row) of
///     shape (n, 2). What is behind the camera is left out.
#[pyfunction]
pub(super) fn wireframe<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    camera: &Bound<'py, PyCamera>,
) -> PyResult<(Lines<'py>, Lines<'py>)> {
    let (model, camera) = (model_of(model)?, camera.get().0);
    let Wireframe { visible, hidden } = py.detach(|| Wireframe::of(&model, &camera));
    Ok((arrays(py, &visible)?, arrays(py, &hidden)?))
}

/// Lines in an image.
type Lines<'py> = Vec<Array<'py>>;

fn arrays<'py>(py: Python<'py>, lines: &[Vec<[f64; 2]>]) -> PyResult<Lines<'py>> {
    lines.iter().map(|line| shaped(py, line.as_flattened().to_vec(), &[line.len(), 2])).collect()
}
