//! NumPy arrays of any real type and memory order in, arrays of doubles out.

use nalgebra::{Matrix3, Vector3};
use numpy::{
    Element, PyArray1, PyArray2, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods,
    PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods, dtype,
};
use pyo3::exceptions::{PyMemoryError, PyTypeError};
use pyo3::prelude::*;

use super::errors::ArrayError;
use crate::cloud::PointCloud;

/// Angles as an argument: anything that `numpy.asarray` takes.
pub(super) type Angles<'a, 'py> = &'a Bound<'py, PyAny>;

/// Doubles of any shape.
pub(super) type Array<'py> = Bound<'py, PyArrayDyn<f64>>;

/// Doubles of shape (n,).
pub(super) type Vector<'py> = Bound<'py, PyArray1<f64>>;

/// Numbers of shape (n, 3).
pub(super) type Table<'py, T = f64> = Bound<'py, PyArray2<T>>;

/// Doubles in C order, with the name they have in messages. They are copied only where the array
/// is of another type, order or alignment.
pub(super) struct Doubles<'py> {
    name: &'static str,
    array: PyReadonlyArrayDyn<'py, f64>,
}

impl<'py> Doubles<'py> {
    /// The numbers of anything that `numpy.asarray` takes.
    ///
    /// # Errors
    /// `TypeError` if they are not real numbers; whatever `numpy.asarray` raises.
    pub fn new(name: &'static str, value: &Bound<'py, PyAny>) -> PyResult<Self> {
        let py = value.py();
        let numpy = py.import("numpy")?;
        let array = numpy.call_method1("asarray", (value,))?.cast_into::<PyUntypedArray>()?;
        if !b"fiu".contains(&array.dtype().kind()) {
            let found = array.dtype();
            let message = format!("{name}: expected an array of real numbers, found dtype {found}");
            return Err(PyTypeError::new_err(message));
        }
        let array = numpy.call_method1("require", (array, dtype::<f64>(py), "CA"))?;
        Ok(Self { name, array: array.cast_into::<PyArrayDyn<f64>>()?.try_readonly()? })
    }

    pub fn shape(&self) -> &[usize] {
        self.array.shape()
    }

    pub fn values(&self) -> PyResult<&[f64]> {
        Ok(self.array.as_slice()?)
    }

    /// The error that tells this shape from the one that is needed.
    pub fn wrong_shape(&self, expected: &str) -> PyErr {
        let found: Vec<String> = self.shape().iter().map(usize::to_string).collect();
        let comma = if found.len() == 1 { "," } else { "" };
        ArrayError::new_err(format!(
            "{}: expected an array of shape {expected}, found ({}{comma})",
            self.name,
            found.join(", ")
        ))
    }

    /// The numbers of a vector.
    ///
    /// # Errors
    /// [`ArrayError`] if its shape is not (N,).
    pub fn vector<const N: usize>(&self) -> PyResult<[f64; N]> {
        match (self.shape(), self.values()?.try_into()) {
            ([_], Ok(vector)) => Ok(vector),
            _ => Err(self.wrong_shape(&format!("({N},)"))),
        }
    }

    /// The rows of an array of shape (..., 3).
    ///
    /// # Errors
    /// [`ArrayError`] if its last axis is not of length three.
    pub fn rows(&self) -> PyResult<&[[f64; 3]]> {
        match self.shape() {
            [.., 3] => Ok(self.values()?.as_chunks().0),
            _ => Err(self.wrong_shape("(..., 3)")),
        }
    }

    /// One number for each row, in an array of shape (...); not a number for rows that are not
    /// finite.
    ///
    /// # Errors
    /// Those of [`rows`](Self::rows).
    pub fn map_rows(
        &self,
        py: Python<'py>,
        map: impl Fn(&Vector3<f64>) -> f64 + Sync,
    ) -> PyResult<Array<'py>> {
        let results = self.finite_rows(py, f64::NAN, map)?;
        shaped(py, results, &self.shape()[..self.shape().len() - 1])
    }

    /// 1 or 0 for each row, in an array of shape (...); not a number for rows that are not finite.
    ///
    /// # Errors
    /// Those of [`rows`](Self::rows).
    pub fn map_rows_to_flags(
        &self,
        py: Python<'py>,
        is_true: impl Fn(&Vector3<f64>) -> bool + Sync,
    ) -> PyResult<Array<'py>> {
        self.map_rows(py, |row| f64::from(u8::from(is_true(row))))
    }

    /// A vector for each row, in an array of the same shape; not numbers for rows that are not
    /// finite.
    ///
    /// # Errors
    /// Those of [`rows`](Self::rows).
    pub fn map_rows_to_rows(
        &self,
        py: Python<'py>,
        map: impl Fn(&Vector3<f64>) -> Vector3<f64> + Sync,
    ) -> PyResult<Array<'py>> {
        let results = self.finite_rows(py, [f64::NAN; 3], |row| map(row).into())?;
        shaped(py, results.into_flattened(), self.shape())
    }

    /// A pair of numbers for each row, in an array of shape (..., 2); not numbers for rows that are
    /// not finite.
    ///
    /// # Errors
    /// Those of [`rows`](Self::rows).
    pub fn map_rows_to_pairs(
        &self,
        py: Python<'py>,
        map: impl Fn(&Vector3<f64>) -> [f64; 2] + Sync,
    ) -> PyResult<Array<'py>> {
        let results = self.finite_rows(py, [f64::NAN; 2], map)?;
        let rows = &self.shape()[..self.shape().len() - 1];
        shaped(py, results.into_flattened(), &[rows, &[2]].concat())
    }

    /// A symmetric matrix for each row, in an array of shape (..., 3, 3); not numbers for rows that
    /// are not finite.
    ///
    /// # Errors
    /// Those of [`rows`](Self::rows).
    pub fn map_rows_to_squares(
        &self,
        py: Python<'py>,
        map: impl Fn(&Vector3<f64>) -> Matrix3<f64> + Sync,
    ) -> PyResult<Array<'py>> {
        let results = self.finite_rows(py, [[f64::NAN; 3]; 3], |row| map(row).into())?;
        let values = results.into_flattened().into_flattened();
        shaped(py, values, &[self.shape(), &[3]].concat())
    }

    /// What `map` makes of the rows that are finite, and `otherwise` in place of the others.
    fn finite_rows<T: Copy + Send + Sync>(
        &self,
        py: Python<'_>,
        otherwise: T,
        map: impl Fn(&Vector3<f64>) -> T + Sync,
    ) -> PyResult<Vec<T>> {
        let map_row = |&row: &[f64; 3]| match row.iter().all(|coordinate| coordinate.is_finite()) {
            true => map(&row.into()),
            false => otherwise,
        };
        let rows = self.rows()?;
        Ok(py.detach(|| rows.iter().map(map_row).collect()))
    }
}

/// The points of an array of shape (n, 3); rows that are not finite are skipped and counted.
///
/// # Errors
/// [`ArrayError`] for another shape, `TypeError` if these are not real numbers.
pub(super) fn point_cloud(name: &'static str, value: &Bound<'_, PyAny>) -> PyResult<PointCloud> {
    let points = Doubles::new(name, value)?;
    match points.shape() {
        [_, 3] => Ok(PointCloud::from_rows(points.rows()?.iter().copied())),
        _ => Err(points.wrong_shape("(n, 3)")),
    }
}

/// A vector for each latitude and longitude, broadcast together to shape (...), in an array of
/// shape (..., 3).
///
/// # Errors
/// `TypeError` if these are not real numbers, `ValueError` if they cannot be broadcast.
pub(super) fn map_angles<'py>(
    eta: Angles<'_, 'py>,
    omega: Angles<'_, 'py>,
    map: impl Fn(f64, f64) -> Vector3<f64> + Sync,
) -> PyResult<Array<'py>> {
    let (vectors, shape) = at_angles(eta, omega, |eta, omega| <[f64; 3]>::from(map(eta, omega)))?;
    shaped(eta.py(), vectors.into_flattened(), &[&shape[..], &[3]].concat())
}

/// M rows of N numbers for each latitude and longitude, broadcast together to shape (...), in an
/// array of shape (..., M, N).
///
/// # Errors
/// Those of [`map_angles`].
pub(super) fn map_angles_to_rows<'py, const M: usize, const N: usize>(
    eta: Angles<'_, 'py>,
    omega: Angles<'_, 'py>,
    map: impl Fn(f64, f64) -> [[f64; N]; M] + Sync,
) -> PyResult<Array<'py>> {
    let (rows, shape) = at_angles(eta, omega, map)?;
    let values = rows.into_flattened().into_flattened();
    shaped(eta.py(), values, &[&shape[..], &[M, N]].concat())
}

/// What `map` makes of each latitude and longitude, in C order, and the shape that these have
/// together.
fn at_angles<T: Send>(
    eta: Angles,
    omega: Angles,
    map: impl Fn(f64, f64) -> T + Sync,
) -> PyResult<(Vec<T>, Vec<usize>)> {
    let py = eta.py();
    let pair = py.import("numpy")?.call_method1("broadcast_arrays", (eta, omega))?;
    let eta = Doubles::new("eta", &pair.get_item(0)?)?;
    let omega = Doubles::new("omega", &pair.get_item(1)?)?;
    let (etas, omegas) = (eta.values()?, omega.values()?);
    let at = |(&eta, &omega): (&f64, &f64)| map(eta, omega);
    let results = py.detach(|| etas.iter().zip(omegas).map(at).collect());
    Ok((results, eta.shape().to_vec()))
}

/// Numbers as an array of shape (n,).
pub(super) fn vector<'py>(py: Python<'py>, values: &[f64]) -> Vector<'py> {
    PyArray1::from_slice(py, values)
}

/// Numbers in C order as an array of a shape.
pub(super) fn shaped<'py, T: Element>(
    py: Python<'py>,
    values: Vec<T>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    PyArray1::from_vec(py, values).reshape(shape)
}

/// Rows as an array of shape (n, 3).
pub(super) fn table<T: Element>(py: Python<'_>, rows: Vec<[T; 3]>) -> PyResult<Table<'_, T>> {
    let count = rows.len();
    PyArray1::from_vec(py, rows.into_flattened()).reshape([count, 3])
}

/// A matrix as an array of shape (3, 3).
pub(super) fn square<'py>(py: Python<'py>, matrix: &Matrix3<f64>) -> PyResult<Table<'py>> {
    table(py, <[[f64; 3]; 3]>::from(matrix.transpose()).to_vec())
}

/// Vectors as an array of shape (n, 3).
pub(super) fn vectors<'py>(py: Python<'py>, vectors: &[Vector3<f64>]) -> PyResult<Table<'py>> {
    table(py, vectors.iter().map(|&vector| vector.into()).collect())
}

/// Makes sure that so many points have room in memory.
///
/// # Errors
/// `MemoryError`, rather than the end of the process.
pub(super) fn require_room(points: usize) -> PyResult<()> {
    let reserved = Vec::<[f64; 3]>::new().try_reserve_exact(points);
    reserved.map_err(|_| PyMemoryError::new_err(format!("no room for {points} points")))
}
