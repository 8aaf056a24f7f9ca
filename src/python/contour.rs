//! `superquadric.contour` and `superquadric.rim`.

use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::arrays::{Array, Doubles, Table, require_room, shaped, vectors};
use super::camera::camera_of;
use super::errors::ViewError;
use super::solid::solid_of;
use crate::outline::{Outline, RimCurve, rim_curves};
use crate::view::{RimError, Viewpoint};

impl From<RimError> for PyErr {
    fn from(error: RimError) -> Self {
        ViewError::new_err(error.to_string())
    }
}

/// The occluding contour of a model: its outline as a camera sees it.
///
/// Args:
///     model: the model of any family, the fit, or a list of them that are seen together, in the
///         camera's frame (x to the right, y down, z forward).
///     camera: the camera, pinhole or orthographic.
///
/// Returns:
///     The outline: of a superellipsoid with exponents up to 2 nowhere more than 0.01 pixels off,
///     of others some 0.02.
///
/// Raises:
///     ViewError: if the camera is not outside the model, or the model reaches behind it or to
///         where the lens lets no ray through.
///     TypeError: if the model is neither a model nor a fit.
#[pyfunction]
pub(super) fn contour(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    camera: &Bound<'_, PyAny>,
) -> PyResult<PyContour> {
    let (solid, camera) = (solid_of(model)?, camera_of(camera)?);
    Ok(PyContour(py.detach(|| Outline::of(&solid, &camera))?))
}

/// The outline of a model in an image; made by `contour`.
#[pyclass(frozen, name = "Contour", module = "superquadric")]
pub(super) struct PyContour(Outline);

#[pymethods]
impl PyContour {
    /// The boundary of the silhouette: closed polygons of pixels (column, row), float64 of shape
    /// (n, 2), those around holes the other way around. The centre of the first pixel is (0, 0),
    /// and they may lie beside the image.
    #[getter]
    fn polygons<'py>(&self, py: Python<'py>) -> PyResult<Vec<Array<'py>>> {
        pixel_arrays(py, self.0.polygons())
    }

    /// The rim, in the camera's frame: closed curves.
    #[getter]
    fn rim(&self) -> Vec<PyRimCurve> {
        self.0.rim_camera().iter().cloned().map(PyRimCurve).collect()
    }

    /// Area of the silhouette without its holes, in square pixels.
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
        let count = self.0.polygons().len();
        let polygons = if count == 1 { "polygon" } else { "polygons" };
        format!("<Contour of {count} {polygons}, area={:.6}>", self.0.area())
    }
}

/// A closed curve of a rim; made by `contour` and `rim`.
#[pyclass(frozen, name = "RimCurve", module = "superquadric")]
pub(super) struct PyRimCurve(RimCurve);

#[pymethods]
impl PyRimCurve {
    /// Points once around, evenly spaced, of shape (n, 3); what faces the camera is to the left,
    /// as seen from outside.
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        vectors(py, &self.0.points)
    }

    /// Whether the model hides each point: bool of shape (n,).
    #[getter]
    fn hidden<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<bool>> {
        PyArray1::from_slice(py, &self.0.is_hidden)
    }

    /// The longest runs of neighbours that are all hidden, or all not, each with the point after
    /// it: arrays of shape (n, 3).
    fn runs<'py>(&self, py: Python<'py>, hidden: bool) -> PyResult<Vec<Table<'py>>> {
        self.0.runs(hidden).iter().map(|run| vectors(py, run)).collect()
    }

    fn __repr__(&self) -> String {
        let hidden = self.0.is_hidden.iter().filter(|is_hidden| **is_hidden).count();
        format!("<RimCurve of {} points, {hidden} of them hidden>", self.0.points.len())
    }
}

/// The rim of a model: where lines of sight touch it (JLS section 2.4.3).
///
/// Args:
///     model: the model of any family, the fit, or a list of them that are seen together.
///     centre: the centre of a pinhole camera, of shape (3,), in the model's world.
///     direction: or else the direction in which an orthographic camera looks.
///     n: number of points, of all curves together.
///
/// Returns:
///     Closed curves in the model's world, one of a superellipsoid with exponents up to 2; each of
///     evenly spaced points.
///
/// Raises:
///     ViewError: if the camera is not outside the model.
///     TypeError: unless one of centre and direction is given.
#[pyfunction]
#[pyo3(signature = (model, *, centre = None, direction = None, n = 200))]
pub(super) fn rim(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    centre: Option<&Bound<'_, PyAny>>,
    direction: Option<&Bound<'_, PyAny>>,
    n: usize,
) -> PyResult<Vec<PyRimCurve>> {
    let solid = solid_of(model)?;
    require_room(n)?;
    let viewpoint = match (centre, direction) {
        (Some(centre), None) => Viewpoint::At(Doubles::new("centre", centre)?.vector()?.into()),
        (None, Some(direction)) => {
            Viewpoint::Along(Doubles::new("direction", direction)?.vector()?.into())
        }
        _ => return Err(PyTypeError::new_err("give either centre or direction")),
    };
    let curves = py.detach(|| rim_curves(&solid, &viewpoint, n))?;
    Ok(curves.into_iter().map(PyRimCurve).collect())
}

/// Polygons and lines in an image, each of shape (n, 2).
pub(super) fn pixel_arrays<'py>(
    py: Python<'py>,
    lines: &[Vec<[f64; 2]>],
) -> PyResult<Vec<Array<'py>>> {
    lines.iter().map(|line| shaped(py, line.as_flattened().to_vec(), &[line.len(), 2])).collect()
}
