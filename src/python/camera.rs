//! `superquadric.OrthographicCamera`, and cameras of either kind.

use std::path::PathBuf;

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::arrays::{Array, Doubles, shaped};
use super::errors::ModelError;
use super::view::PyCamera;
use crate::view::{AnyCamera, OrthographicCamera, Projection};

/// A camera of either kind.
pub(super) fn camera_of(value: &Bound<'_, PyAny>) -> PyResult<AnyCamera> {
    if let Ok(camera) = value.cast::<PyCamera>() {
        return Ok(camera.get().0.into());
    }
    if let Ok(camera) = value.cast::<PyOrthographicCamera>() {
        return Ok(camera.get().0.into());
    }
    let found = value.get_type().name()?;
    Err(PyTypeError::new_err(format!("expected a Camera or an OrthographicCamera, found {found}")))
}

/// The camera in a file: an orthographic one in JSON or YAML, `{"model": "orthographic", "scale":
/// [..], "origin": [..], "width": .., "height": ..}`, or a pinhole one as `Camera.load` reads it.
///
/// Raises:
///     ImageError: if the file holds no camera.
///     OSError: if it cannot be read.
#[pyfunction]
pub(super) fn load_camera(py: Python<'_>, path: PathBuf) -> PyResult<Py<PyAny>> {
    Ok(match AnyCamera::read(path)? {
        AnyCamera::Pinhole(camera) => Py::new(py, PyCamera(camera))?.into_any(),
        AnyCamera::Orthographic(camera) => Py::new(py, PyOrthographicCamera(camera))?.into_any(),
    })
}

/// A camera that looks along z everywhere, as if from far away: x to the right, y down.
///
/// Args:
///     scale: pixels to a unit of length along rows and columns.
///     origin: column and row at which the origin is seen.
///     width: number of columns.
///     height: number of rows.
///
/// Raises:
///     ModelError: if a number is one that no camera has.
#[pyclass(frozen, eq, name = "OrthographicCamera", module = "superquadric")]
#[derive(Clone, PartialEq)]
pub(super) struct PyOrthographicCamera(pub OrthographicCamera);

#[pymethods]
impl PyOrthographicCamera {
    #[new]
    fn new(scale: [f64; 2], origin: [f64; 2], width: u32, height: u32) -> PyResult<Self> {
        let camera = OrthographicCamera { scale, origin, width, height };
        Ok(Self(camera.checked().map_err(|error| ModelError::new_err(error.to_string()))?))
    }

    /// Pixels to a unit of length along rows and columns.
    #[getter]
    fn scale(&self) -> [f64; 2] {
        self.0.scale
    }

    /// Column and row at which the origin is seen.
    #[getter]
    fn origin(&self) -> [f64; 2] {
        self.0.origin
    }

    /// Number of columns.
    #[getter]
    fn width(&self) -> u32 {
        self.0.width
    }

    /// Number of rows.
    #[getter]
    fn height(&self) -> u32 {
        self.0.height
    }

    /// Pixels (column, row), of shape (n, 2), at which points of the camera's frame, of shape
    /// (n, 3), are seen.
    fn project<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        project(&self.0, points)
    }

    fn __repr__(&self) -> String {
        let OrthographicCamera { scale, origin, width, height } = self.0;
        format!("<OrthographicCamera {width} x {height}, scale={scale:?}, origin={origin:?}>")
    }
}

/// Pixels at which points of a camera's frame are seen; not numbers where they are not.
pub(super) fn project<'py>(
    camera: &impl Projection,
    points: &Bound<'py, PyAny>,
) -> PyResult<Array<'py>> {
    let py = points.py();
    let points = Doubles::new("points", points)?;
    let [count, 3] = *points.shape() else { return Err(points.wrong_shape("(n, 3)")) };
    let pixel = |row: &[f64; 3]| camera.project(&(*row).into()).unwrap_or([f64::NAN; 2]);
    let pixels: Vec<[f64; 2]> = points.rows()?.iter().map(pixel).collect();
    shaped(py, pixels.into_flattened(), &[count, 2])
}
