//! `superquadric.Polyline`: a free curve of straight edges.

use pyo3::prelude::*;

use super::arrays::{Array, Doubles, shaped};
use super::curves::map_parameters;
use crate::shape::Polyline;

/// A curve of straight edges from point to point, open or closed, by a parameter that counts the
/// points: k at the point of index k, evenly along the edges between. It ends at the number of
/// edges; beyond, a closed one goes round again, and an open one has no points, but NaN.
///
/// Args:
///     points: from 2 to 10,000 points of shape (n, 2), none the same as the next.
///     closed: whether the first follows the last; it is not repeated then.
///
/// Raises:
///     ModelError: if there are too few points or too many, one is not finite, or is the same as
///         the next.
///     ArrayError: if the points have another shape.
#[pyclass(frozen, name = "Polyline", module = "superquadric")]
pub(super) struct PyPolyline(pub Polyline);

#[pymethods]
impl PyPolyline {
    #[new]
    #[pyo3(signature = (points, closed = false))]
    fn new(points: &Bound<'_, PyAny>, closed: bool) -> PyResult<Self> {
        let points = Doubles::new("points", points)?;
        let [_, 2] = points.shape() else { return Err(points.wrong_shape("(n, 2)")) };
        let (pairs, _) = points.values()?.as_chunks::<2>();
        Ok(Self(Polyline::new(pairs.iter().map(|&pair| pair.into()).collect(), closed)?))
    }

    /// The points: float64 of shape (n, 2).
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let points = self.0.points();
        shaped(py, points.iter().flatten().copied().collect(), &[points.len(), 2])
    }

    /// Whether the first point follows the last.
    #[getter]
    fn closed(&self) -> bool {
        self.0.is_closed()
    }

    /// Points, of shape (..., 2), at parameters of shape (...).
    fn position<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        map_parameters(theta, &self.0, |point| point.position)
    }

    /// First derivatives, of shape (..., 2), at parameters of shape (...): the edges. At a point,
    /// that of the edge that begins there.
    fn tangent<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        map_parameters(theta, &self.0, |point| point.tangent)
    }

    /// Second derivatives, of shape (..., 2), at parameters of shape (...): 0.
    fn second_derivative<'py>(&self, theta: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        map_parameters(theta, &self.0, |point| point.second)
    }
}
