//! `superquadric.read`.

use std::path::PathBuf;

use numpy::PyArray1;
use pyo3::prelude::*;

use super::arrays::table;
use crate::cloud;

/// Read a point cloud from a PLY, PCD, NPY or text file.
///
/// The content tells the format. Rows with a coordinate that is not finite are left out.
///
/// Args:
///     path: the file.
///     return_skipped: also return which rows of the file were left out.
///
/// Returns:
///     The points, float64 of shape (n, 3), in the file's unit; with `return_skipped` a pair of
///     these and the indices, int64 of shape (k,), of the rows that were left out.
///
/// Raises:
///     CloudError: if the file does not hold a point cloud.
///     OSError: if it cannot be read.
#[pyfunction]
#[pyo3(signature = (path, *, return_skipped = false))]
pub(super) fn read(
    py: Python<'_>,
    path: PathBuf,
    return_skipped: bool,
) -> PyResult<Bound<'_, PyAny>> {
    let (points, skipped) = py.detach(|| {
        let rows = cloud::read_rows(&path)?;
        let skipped = rows.skipped_rows.iter().map(|&row| row as i64).collect();
        Ok::<_, PyErr>((rows.points, skipped))
    })?;
    let points = table(py, points)?;
    if !return_skipped {
        return Ok(points.into_any());
    }
    let skipped: Bound<'_, PyArray1<i64>> = PyArray1::from_vec(py, skipped);
    Ok((points, skipped).into_pyobject(py)?.into_any())
}
