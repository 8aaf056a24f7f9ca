//! What `superquadric.overlay` draws besides the contour: lines, axes, distances.

use pyo3::prelude::*;

use super::arrays::{Array, Doubles, shaped};
use super::camera::camera_of;
use super::contour::pixel_arrays;
use super::solid::solid_of;
use crate::outline::{Residual, Wireframe};

/// Lines on the surface of a model as a camera sees them.
///
/// On a solid around its centre they are those of a grid on a box of its semi-axes, projected from
/// the centre; on others lines across and along.
///
/// Args:
///     model: the model of any family, the fit, or a list of them that are seen together, in the
///         camera's frame.
///     camera: the camera, pinhole or orthographic.
///
/// Returns:
///     The lines that are seen and those that are hidden, two lists of arrays (column, row) of
///     shape (n, 2). What is behind the camera is left out.
#[pyfunction]
pub(super) fn wireframe<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    camera: &Bound<'py, PyAny>,
) -> PyResult<(Vec<Array<'py>>, Vec<Array<'py>>)> {
    let (solid, camera) = (solid_of(model)?, camera_of(camera)?);
    let Wireframe { visible, hidden } = py.detach(|| Wireframe::of(&solid, &camera));
    Ok((pixel_arrays(py, &visible)?, pixel_arrays(py, &hidden)?))
}

/// The axes x, y, z of a model, lines from its centre out of it, of shape (3, 2, 3); None for
/// several.
#[pyfunction]
pub(super) fn axes<'py>(model: &Bound<'py, PyAny>) -> PyResult<Option<Array<'py>>> {
    let py = model.py();
    let Some(axes) = crate::outline::axes(&solid_of(model)?) else { return Ok(None) };
    let numbers = axes.as_flattened().iter().flat_map(|x| [x.x, x.y, x.z]).collect();
    shaped(py, numbers, &[3, 2, 3]).map(Some)
}

/// Signed distances of points of shape (..., 3) from a model, in an array of shape (...): radial
/// ones from a superellipsoid with exponents up to 2, from any other of first order.
#[pyfunction]
pub(super) fn residual<'py>(
    model: &Bound<'py, PyAny>,
    points: &Bound<'py, PyAny>,
) -> PyResult<Array<'py>> {
    let solid = solid_of(model)?;
    let residual = Residual::of(&solid);
    Doubles::new("points", points)?.map_rows(points.py(), |x| residual.at(x))
}
