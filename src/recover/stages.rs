//! The stages of the fit by themselves, for benchmarks; no part of the library's interface.

use super::constraints::Constraints;
use super::descent::{Effort, PointSet, descend};
use super::evidence::Evidence;
use super::fit::residual;
use super::normalization::Moments;
use super::options::{Distance, FitOptions, Precision};
use super::search::Search;
use super::subset::Subset;
use super::survey::Survey;
use crate::cloud::PointCloud;
use crate::model::Model;
use crate::pose::Pose;

/// Centroid, radius and principal axes: the RMS radius.
pub fn normalize(cloud: &PointCloud) -> f64 {
    Moments::of(cloud.columns()).normalization.radius
}

/// A normalised cloud, ready for one stage after the other.
pub struct Normalized<'a> {
    cloud: &'a PointCloud,
    moments: Moments,
    precision: Precision,
}

impl<'a> Normalized<'a> {
    /// Of at least one point.
    pub fn of(cloud: &'a PointCloud) -> Self {
        Self { cloud, moments: Moments::of(cloud.columns()), precision: Precision::Double }
    }

    /// The same, passes being made in the given precision.
    pub fn with_precision(self, precision: Precision) -> Self {
        Self { precision, ..self }
    }

    /// Neighbours, clutter and area of a sample: the area that is seen.
    pub fn survey(&self) -> f64 {
        Survey::of(self.cloud.columns(), &self.moments, FitOptions::default().seed).room.area
    }

    /// The coarse search on so many points: the passes that it takes.
    pub fn search(&self, points: usize) -> usize {
        let few = Subset::stratified(self.cloud.columns(), points, FitOptions::default().seed);
        self.with_points(Distance::Radial, |all| {
            let few = PointSet { points: few.columns(), ..*all };
            Search::coarse(&few, &self.moments).passes
        })
    }

    /// One pass over all points around a model: the sum of squared residuals, in normalised units.
    pub fn pass(&self, model: &Model, distance: Distance) -> f64 {
        let model = self.normalized(model);
        self.with_points(distance, |all| {
            all.gram(&model).map_or(f64::NAN, |gram| gram.residual_squares())
        })
    }

    /// A descent to the end, over all points, from a model: where it leads, in the cloud's unit.
    pub fn descend(&self, start: &Model, distance: Distance) -> Option<Model> {
        let start = self.normalized(start);
        let descent = self.with_points(distance, |all| descend(all, &start, &Effort::FINISH))?;
        Some(self.moments.normalization.cloud_from_normalized(&descent.model))
    }

    /// The geometric distance of every point from a model, without derivatives.
    pub fn distances(&self, model: &Model) -> Vec<f64> {
        let model = self.normalized(model);
        self.with_points(Distance::Geometric, |all| all.geometric_distances(&model))
    }

    fn normalized(&self, model: &Model) -> Model {
        let normalization = &self.moments.normalization;
        let centre = normalization.normalized((*model.pose.translation()).into());
        Model {
            shape: model.shape.scaled(normalization.inverse_radius),
            pose: Pose::new(*model.pose.rotation(), centre),
        }
    }

    fn with_points<T>(&self, distance: Distance, run: impl FnOnce(&PointSet) -> T) -> T {
        run(&PointSet {
            points: self.cloud.columns(),
            normalization: &self.moments.normalization,
            root_weights: None,
            ray_noise: None,
            evidence: &Evidence::NONE,
            constraints: &Constraints::NONE.normalized(&self.moments.normalization),
            parallel: false,
            residual: residual(distance),
            precision: self.precision,
            is_interrupted: &|| false,
        })
    }
}
