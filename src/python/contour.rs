//! `superquadric.contour` and `superquadric.rim`.

use nalgebra::Vector3;
use numpy::PyArray2;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::arrays::{Array, Doubles, Table, require_room, shaped, table};
use super::errors::ViewError;
use super::solid::model_of;
use super::view::PyCamera;
use crate::view::{Contour, RimError, Viewpoint};

impl From<RimError> for PyErr {
    fn from(error: RimError) -> Self {
        ViewError::new_err(error.to_string())
    }
}

/// The occluding contour of a model: its outline as a camera sees it.
///
/// Args:
///     model: the model or the fit, in the camera's frame (x to the right, y down, z forward).
///     camera: the camera.
///
/// Returns:
///     The outline, nowhere more than 0.01 pixels off.
///
/// Raises:
///     ViewError: if an exponent is over 2, the camera is not outside the model, or the model
///         reaches behind it or to where the lens lets no ray through.
///     TypeError: if the model is neither a model nor a fit.
#[pyfunction]
pub(super) fn contour(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    camera: &Bound<'_, PyCamera>,
) -> PyResult<PyContour> {
    let (model, camera) = (model_of(model)?, camera.get().0);
    Ok(PyContour(py.detach(|| Contour::of(&model, &camera))?))
}

/// The outline of a model in an image; made by `contour`.
#[pyclass(frozen, name = "Contour", module = "superquadric")]
pub(super) struct PyContour(Contour);

#[pymethods]
impl PyContour {
    /// Pixels (column, row) once around, float64 of shape (n, 2); the centre of the first pixel is
    /// (0, 0), and they may lie beside the image.
    #[getter]
    fn polygon<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let polygon = self.0.polygon();
        shaped(py, polygon.as_flattened().to_vec(), &[polygon.len(), 2])
    }

    /// The point of the rim, in the camera's frame, that is seen at each pixel of the polygon, of
    /// shape (n, 3).
    #[getter]
    fn rim<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        table(py, self.0.rim_camera().iter().map(|x| (*x).into()).collect())
    }

    /// Area of the silhouette, in square pixels.
    #[getter]
    fn area(&self) -> f64 {
        self.0.area()
    }

    /// The least box around the silhouette, of shape (2, 2): least and greatest column and row.
    #[getter]
    fn bounding_box<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        let rows = self.0.bounding_box().map(Vec::from);
        PyArray2::from_vec2(py, &rows).expect("rows of one length")
    }

    fn __repr__(&self) -> String {
        format!("<Contour of {} pixels, area={:.6}>", self.0.polygon().len(), self.0.area())
    }
}

/// The rim of a model: where lines of sight touch it (JLS section 2.4.3).
///
/// Args:
///     model: the model or the fit.
///     centre: the centre of a pinhole camera, of shape (3,), in the model's world.
///     direction: or else the direction in which an orthographic camera looks.
///     n: number of points.
///
/// Returns:
///     Points once around, evenly spaced, of shape (n, 3), in the model's world.
///
/// Raises:
///     ViewError: if an exponent is over 2, or the camera is not outside the model.
///     TypeError: unless one of centre and direction is given.
#[pyfunction]
#[pyo3(signature = (model, *, centre = None, direction = None, n = 200))]
pub(super) fn rim<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    centre: Option<&Bound<'py, PyAny>>,
    direction: Option<&Bound<'py, PyAny>>,
    n: usize,
) -> PyResult<Table<'py>> {
    let model = model_of(model)?;
    require_room(n)?;
    let viewpoint = match (centre, direction) {
        (Some(centre), None) => {
            let centre: Vector3<f64> = Doubles::new("centre", centre)?.vector()?.into();
            Viewpoint::At(model.pose.model_from_world(&centre))
        }
        (None, Some(direction)) => {
            let direction: Vector3<f64> = Doubles::new("direction", direction)?.vector()?.into();
            Viewpoint::Along(model.pose.rotation().inverse_transform_vector(&direction))
        }
        _ => return Err(PyTypeError::new_err("give either centre or direction")),
    };
    let points = py.detach(|| crate::view::rim(&model.shape, &viewpoint, n))?;
    table(py, points.iter().map(|x| model.pose.world_from_model(x).into()).collect())
}
