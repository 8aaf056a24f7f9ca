//! `superquadric.score`: how far a recovered model is from the true one.

use pyo3::prelude::*;

use super::arrays::{point_cloud, require_room};
use super::solid::model_of;
use crate::cloud::PointCloud;
use crate::compare::{
    SurfaceDistance, VolumeOverlap, rotation_error, size_error, surface_distance, volume_overlap,
};
use crate::model::Model;

/// Compare a model with the true one, as solids: parameters are ambiguous.
///
/// Args:
///     truth: the true model.
///     found: the recovered model, or the fit.
///     inliers: points of the true surface, of shape (n, 3); rows that are not finite are left
///         out.
///     samples: points drawn for the overlap, and from each surface for their distance.
///     seed: of the points drawn.
///
/// Raises:
///     ArrayError: if the shape of the inliers is not (n, 3).
///     TypeError: if they are not real numbers, or a solid is neither a model nor a fit.
#[pyfunction]
#[pyo3(signature = (truth, found, *, inliers = None, samples = 20_000, seed = 0))]
pub(super) fn score(
    py: Python<'_>,
    truth: &Bound<'_, PyAny>,
    found: &Bound<'_, PyAny>,
    inliers: Option<&Bound<'_, PyAny>>,
    samples: usize,
    seed: u64,
) -> PyResult<PyScore> {
    let inliers = inliers.map(|inliers| point_cloud("inliers", inliers)).transpose()?;
    require_room(samples)?;
    let (truth, found) = (model_of(truth)?, model_of(found)?);
    Ok(py.detach(|| PyScore {
        overlap: volume_overlap(&truth, &found, samples, seed),
        distance: surface_distance(&truth, &found, samples, seed),
        rms_inliers: inliers.map(|inliers| rms_radial(&found, &inliers)),
        size_error: size_error(&truth, &found),
        rotation_error: rotation_error(&truth, &found),
    }))
}

/// Root mean square of the radial distances of points; NaN without any.
fn rms_radial(model: &Model, points: &PointCloud) -> f64 {
    let squares = points.points().map(|point| model.radial_distance(&point.into()).powi(2));
    (squares.sum::<f64>() / points.len() as f64).sqrt()
}

/// The difference of a recovered model from the true one; made by `score`.
#[pyclass(frozen, name = "Score", module = "superquadric")]
pub(super) struct PyScore {
    overlap: VolumeOverlap,
    distance: SurfaceDistance,
    rms_inliers: Option<f64>,
    size_error: f64,
    rotation_error: f64,
}

#[pymethods]
impl PyScore {
    /// Volume of the intersection over that of the union, in [0, 1].
    #[getter]
    fn volume_iou(&self) -> f64 {
        self.overlap.iou
    }

    /// Standard error of `volume_iou`.
    #[getter]
    fn volume_iou_error(&self) -> f64 {
        self.overlap.standard_error
    }

    /// Symmetric mean (Chamfer) distance of the surfaces over the true mean semi-axis.
    #[getter]
    fn surface_distance(&self) -> f64 {
        self.distance.relative_mean
    }

    /// Standard error of `surface_distance`.
    #[getter]
    fn surface_distance_error(&self) -> f64 {
        self.distance.standard_error
    }

    /// Root mean square of the inliers' radial distances from the recovered model (JLS Eq.
    /// 2.43), in their unit; None if no inliers were given.
    #[getter]
    fn rms_inliers(&self) -> Option<f64> {
        self.rms_inliers
    }

    /// Greatest relative error of a semi-axis, after matching the axes of both solids.
    #[getter]
    fn size_error(&self) -> f64 {
        self.size_error
    }

    /// Least angle, in radians, between the orientations, up to the solid's own symmetry.
    #[getter]
    fn rotation_error(&self) -> f64 {
        self.rotation_error
    }

    fn __repr__(&self) -> String {
        let inliers =
            self.rms_inliers.map_or(String::new(), |rms| format!(", rms_inliers={rms:.4e}"));
        format!(
            "<Score volume_iou={:.4}+-{:.4}, surface_distance={:.4e}+-{:.1e}, size_error={:.4e}, \
             rotation_error={:.4e}{inliers}>",
            self.overlap.iou,
            self.overlap.standard_error,
            self.distance.relative_mean,
            self.distance.standard_error,
            self.size_error,
            self.rotation_error,
        )
    }
}
