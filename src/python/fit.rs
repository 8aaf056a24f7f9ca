//! `superquadric.fit` and what it finds.

use std::collections::HashMap;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Instant;

use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::arrays::point_cloud;
use super::interrupt::interruptible;
use super::knowledge::{constraints, plane, sight};
use super::model::PyModel;
use crate::model::Model;
use crate::output::write_whole;
use crate::recover::{Distance, Fit, FitOptions, Precision, fit_unless};
use crate::report::FitDocument;

/// Recover a superellipsoid from points of its surface.
///
/// It is the one in general position that minimises the sum of squared distances. The
/// interpreter is released meanwhile, and Ctrl-C ends the fit.
///
/// Args:
///     points: array of shape (n, 3), of any real type and memory order, in any unit. Rows that
///         are not finite are skipped and counted.
///     seed: chooses the points that the first, coarse fits look at.
///     distance: `radial` for that along the ray from the centre (JLS Eq. 2.43), `geometric` to
///         go on from its best minima with the first-order geometric distance.
///     precision: `double` or `single`, that of the rows of the points; single is faster, and rounds
///         residuals by 1e-7 of the cloud's radius.
///     threads: how many to use; by default as many as the machine offers. The result does not
///         depend on it.
///     viewpoint: where the sensor stood, of shape (3,), in the points' frame.
///     free_rays: rays of the sensor beside the object that came through, of shape (n, 4): a
///         direction, and how far the ray came (infinite if it met nothing). They need a
///         viewpoint; `DepthMap.free_rays` has them.
///     support: the plane that the object stands on, (a, b, c, d) for `a x + b y + c z + d = 0`,
///         positive on the object's side.
///     shape: what kind of shape it is: `any`, `box`, `cylinder`, `ellipsoid` or `sphere`.
///     fix: values of parameters that are known, by name: a1 a2 a3 e1 e2, and x y z of the centre.
///     size_range: least and greatest semi-axis.
///     exponent_range: least and greatest exponent, within 0.05 to 2.
///     tie: semi-axes that are equal: `none`, `equator` (a1 = a2) or `all`; by default as `shape`
///         has it.
///
/// Returns:
///     The model with the evidence for it. A fit that deserves no trust is no error: see
///     `Fit.trusted`.
///
/// Raises:
///     ArrayError: if the shape is not (n, 3).
///     TypeError: if the points are not real numbers.
///     ValueError: if there is no such distance, precision, shape, tie or parameter, or no such plane.
///     FitError: if the points are fewer than the parameters, coincide, lie on one line, or have
///         coordinates that cannot be squared; if what is known of the parameters cannot hold.
#[pyfunction]
#[pyo3(signature = (
    points, *, seed = 0, distance = "geometric", precision = "double", threads = None,
    viewpoint = None, free_rays = None, support = None, shape = "any", fix = None,
    size_range = None, exponent_range = None, tie = None
))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
pub(super) fn fit(
    points: &Bound<'_, PyAny>,
    seed: u64,
    distance: &str,
    precision: &str,
    threads: Option<NonZeroUsize>,
    viewpoint: Option<&Bound<'_, PyAny>>,
    free_rays: Option<&Bound<'_, PyAny>>,
    support: Option<&Bound<'_, PyAny>>,
    shape: &str,
    fix: Option<HashMap<String, f64>>,
    size_range: Option<[f64; 2]>,
    exponent_range: Option<[f64; 2]>,
    tie: Option<&str>,
) -> PyResult<PyFit> {
    let cloud = point_cloud("points", points)?;
    let options = FitOptions {
        seed,
        distance: distance_named(distance)?,
        precision: precision_named(precision)?,
        threads,
        sight: sight(viewpoint, free_rays)?,
        support: support.map(plane).transpose()?,
        constraints: constraints(shape, &fix.unwrap_or_default(), size_range, exponent_range, tie)?,
    };
    let start = Instant::now();
    let fit =
        interruptible(points.py(), |is_interrupted| fit_unless(&cloud, &options, is_interrupted))??;
    let seconds = start.elapsed().as_secs_f64();
    Ok(PyFit { fit, seconds, skipped_rows: cloud.skipped_rows().to_vec() })
}

/// The distance of a name.
///
/// # Errors
/// `ValueError` if there is none.
pub(super) fn distance_named(name: &str) -> PyResult<Distance> {
    match name {
        "radial" => Ok(Distance::Radial),
        "geometric" => Ok(Distance::Geometric),
        _ => {
            let message = format!("distance must be 'radial' or 'geometric', found '{name}'");
            Err(PyValueError::new_err(message))
        }
    }
}

/// The precision of a name.
///
/// # Errors
/// `ValueError` if there is none.
pub(super) fn precision_named(name: &str) -> PyResult<Precision> {
    match name {
        "double" => Ok(Precision::Double),
        "single" => Ok(Precision::Single),
        _ => {
            let message = format!("precision must be 'double' or 'single', found '{name}'");
            Err(PyValueError::new_err(message))
        }
    }
}

/// A recovered model with the evidence for it; made by `fit`.
#[pyclass(frozen, name = "Fit", module = "superquadric")]
pub(super) struct PyFit {
    fit: Fit,
    seconds: f64,
    skipped_rows: Vec<usize>,
}

impl PyFit {
    /// The recovered model.
    pub fn model(&self) -> &Model {
        &self.fit.model
    }

    fn document(&self) -> String {
        FitDocument::new(&self.fit, self.seconds).to_json()
    }
}

#[pymethods]
impl PyFit {
    /// The recovered model, in the points' frame and unit and in canonical form.
    #[getter(model)]
    fn py_model(&self, py: Python<'_>) -> PyResult<Py<PyModel>> {
        PyModel::object(py, self.fit.model)
    }

    /// Whether there is no reason to doubt the model.
    #[getter]
    fn trusted(&self) -> bool {
        self.fit.is_trusted()
    }

    /// Reasons not to trust the model: pairs of a kind (`not_converged`, `poor_fit`, `flat`,
    /// `other_surfaces` or `uncertain_size`) and a message.
    #[getter]
    fn doubts(&self) -> Vec<(&'static str, String)> {
        self.fit.doubts.iter().map(|doubt| (doubt.name(), doubt.to_string())).collect()
    }

    /// `converged` if the last descent ended at a minimum, else `stopped`.
    #[getter]
    fn status(&self) -> &'static str {
        self.fit.termination.status()
    }

    /// Why the optimiser ended, in one word.
    #[getter]
    fn termination(&self) -> &'static str {
        self.fit.termination.reason
    }

    /// Root mean square of the radial Euclidean distances (JLS Eq. 2.43), in the points' unit.
    #[getter]
    fn rms_radial(&self) -> f64 {
        self.fit.rms_radial
    }

    /// Root mean square of the first-order geometric distances, in the points' unit.
    #[getter]
    fn rms_geometric(&self) -> f64 {
        self.fit.rms_geometric
    }

    /// `rms_radial` over the mean semi-axis.
    #[getter]
    fn relative_rms(&self) -> f64 {
        self.fit.relative_rms()
    }

    /// Standard deviation of the surface points' geometric distances, in the points' unit.
    #[getter]
    fn noise(&self) -> f64 {
        self.fit.noise
    }

    /// Standard deviations of the noise along a sensor's rays and across them, in the points' unit;
    /// None unless the points tell that it is not alike in all directions.
    #[getter]
    fn range_noise(&self) -> Option<(f64, f64)> {
        self.fit.range_noise.map(|noise| (noise.along, noise.across))
    }

    /// Estimated share of strays, points that are not of the surface, among all.
    #[getter]
    fn stray_share(&self) -> f64 {
        self.fit.stray_share
    }

    /// Number of points that are more likely of the surface than strays.
    #[getter]
    fn inliers(&self) -> usize {
        self.fit.inliers()
    }

    /// Which rows of the array are more likely of the surface than strays: bool of shape (n,),
    /// false for those skipped.
    #[getter]
    fn inlier_mask<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<bool>> {
        let mut is_inlier = vec![true; self.fit.points + self.fit.points_skipped];
        self.skipped_rows.iter().for_each(|&row| is_inlier[row] = false);
        let used = is_inlier.iter_mut().filter(|used| **used);
        used.zip(&self.fit.is_inlier).for_each(|(row, inlier)| *row = *inlier);
        PyArray1::from_vec(py, is_inlier)
    }

    /// Covariance of the parameters a1 a2 a3 e1 e2 rx ry rz x y z, float64 of shape (11, 11), in
    /// the points' unit; (rx, ry, rz) is a small rotation in the model's frame, after the model's
    /// own. What the points do not determine has standard errors of about the size itself.
    #[getter]
    fn covariance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows: Vec<Vec<f64>> = self.fit.covariance.rows().map(Vec::from).into();
        Ok(PyArray2::from_vec2(py, &rows)?)
    }

    /// Standard errors of the same parameters, float64 of shape (11,).
    #[getter]
    fn standard_errors<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.fit.covariance.standard_errors())
    }

    /// Number of points fitted, strays included.
    #[getter]
    fn points(&self) -> usize {
        self.fit.points
    }

    /// Number of rows skipped because they were not finite.
    #[getter]
    fn points_skipped(&self) -> usize {
        self.fit.points_skipped
    }

    /// Which rows of the array were fitted: bool of shape (n,), false for those skipped.
    #[getter]
    fn used_mask<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<bool>> {
        let mut used = vec![true; self.fit.points + self.fit.points_skipped];
        self.skipped_rows.iter().for_each(|&row| used[row] = false);
        PyArray1::from_vec(py, used)
    }

    /// Evaluations of residuals and derivatives, over all stages.
    #[getter]
    fn evaluations(&self) -> usize {
        self.fit.evaluations
    }

    /// Models that a descent was started from.
    #[getter]
    fn starts(&self) -> usize {
        self.fit.starts
    }

    /// The distance whose squares were minimised: "radial" or "geometric".
    #[getter]
    fn distance(&self) -> &'static str {
        self.fit.distance.name()
    }

    /// The seed given.
    #[getter]
    fn seed(&self) -> u64 {
        self.fit.seed
    }

    /// Wall-clock time of the fit, in seconds.
    #[getter]
    fn seconds(&self) -> f64 {
        self.seconds
    }

    /// The fit as JSON text of schema `superquadric.fit/1`, as the command line writes it.
    fn to_json(&self) -> String {
        self.document()
    }

    /// The fit as a dictionary of schema `superquadric.fit/1`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        py.import("json")?.call_method1("loads", (self.document(),))
    }

    /// Write the fit as JSON of schema `superquadric.fit/1`, whole or not at all.
    ///
    /// Raises:
    ///     OSError: if the file cannot be written.
    fn save(&self, path: PathBuf) -> PyResult<()> {
        Ok(write_whole(path, |writer| writer.write_all(self.document().as_bytes()))?)
    }

    fn __repr__(&self) -> String {
        format!(
            "<Fit {} of {} points, {}, rms_radial={:.4e}: {}>",
            self.status(),
            self.fit.points,
            if self.trusted() { "trusted" } else { "not trusted" },
            self.fit.rms_radial,
            PyModel(self.fit.model).__repr__(),
        )
    }
}
