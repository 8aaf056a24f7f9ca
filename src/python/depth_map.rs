//! `superquadric.DepthMap`.

use std::path::PathBuf;

use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::arrays::table;
use crate::view::{Camera, DepthMap, find_plane};

/// A depth map and the object in it, read from files.
///
/// Lengths are metres in the camera's frame: x to the right, y down, z forward.
///
/// Args:
///     path: PNG image of 16 bits a pixel, 0 where there is no depth.
///     camera: JSON with fx, fy, cx, cy, width, height in pixels, and depth_units_m.
///     mask: PNG image, not 0 where the object is; by default it is everywhere.
///     depth_unit: metres to a count of the depth map; by default the camera's.
///
/// Raises:
///     ValueError: if a file is not what it should be.
#[pyclass(frozen, name = "DepthMap", module = "superquadric")]
pub(super) struct PyDepthMap(DepthMap);

#[pymethods]
impl PyDepthMap {
    #[new]
    #[pyo3(signature = (path, camera, *, mask = None, depth_unit = None))]
    fn new(
        py: Python<'_>,
        path: PathBuf,
        camera: PathBuf,
        mask: Option<PathBuf>,
        depth_unit: Option<f64>,
    ) -> PyResult<Self> {
        if depth_unit.is_some_and(|unit| !(unit.is_finite() && unit > 0.0)) {
            return Err(PyValueError::new_err("depth_unit must be a positive number"));
        }
        let read = || {
            let camera = Camera::read(camera)?;
            DepthMap::read(path, camera, mask.as_deref(), depth_unit)
        };
        let map = py.detach(read).map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(Self(map))
    }

    /// Points of the object, float64 of shape (n, 3).
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        table(py, self.0.object_points().points().collect())
    }

    /// Where the camera stood: zeros of shape (3,).
    #[getter]
    fn viewpoint<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.0.sight().viewpoint)
    }

    /// Rays next to the object that came through, float64 of shape (n, 4): directions and how far
    /// each ray came. None without a mask.
    #[getter]
    fn free_rays<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let free = self.0.sight().free;
        let rows: Vec<f64> =
            free.iter().flat_map(|line| line.direction.into_iter().chain([line.reach])).collect();
        PyArray1::from_vec(py, rows).reshape([free.len(), 4])
    }

    /// The plane around the object that it stands on, float64 of shape (4,); None if there is
    /// none.
    #[pyo3(signature = (seed = 0))]
    fn find_support<'py>(&self, py: Python<'py>, seed: u64) -> Option<Bound<'py, PyArray1<f64>>> {
        let plane = find_plane(&self.0.surroundings(), [0.0; 3], seed)?;
        let [a, b, c] = plane.normal();
        Some(PyArray1::from_slice(py, &[a, b, c, plane.offset()]))
    }
}
