//! Constants of one pass: how the points reach the model's frame, and the model's parameters.

use super::feet::Spread;
use crate::model::Model;
use crate::pose::Pose;
use crate::recover::normalization::Normalization;
use crate::recover::options::Precision;
use crate::shape::Superellipsoid;

/// What is minimised, in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Residual {
    /// The radial Euclidean distance (JLS Eq. 2.43).
    Radial,
    /// The first-order geometric distance `(H - 1)/|grad H|`.
    Geometric,
}

/// Everything that the rows of a pass share.
#[derive(Debug, Clone)]
pub(crate) struct ModelView {
    /// From the cloud's coordinates to normalised ones.
    pub(super) normalization: Normalization,
    /// The model's centre, in normalised coordinates.
    pub(super) translation: [f64; 3],
    /// The model's axes, in normalised coordinates.
    pub(super) axes: [[f64; 3]; 3],
    pub(super) size: [f64; 3],
    pub(super) inverse_size: [f64; 3],
    pub(super) exponents: [f64; 2],
    pub(super) is_geometric: bool,
    pub(super) precision: Precision,
    /// How noise spreads the points, if not alike in all directions.
    pub(super) spread: Option<Spread>,
}

impl ModelView {
    /// The view of a model given in normalised coordinates.
    pub fn new(normalization: &Normalization, model: &Model, residual: Residual) -> Self {
        let rotation = model.pose.rotation().matrix();
        let size = model.shape.size();
        Self {
            normalization: *normalization,
            translation: (*model.pose.translation()).into(),
            axes: std::array::from_fn(|k| rotation.column(k).into_owned().into()),
            size,
            inverse_size: size.map(f64::recip),
            exponents: model.shape.exponents(),
            is_geometric: residual == Residual::Geometric,
            precision: Precision::Double,
            spread: None,
        }
    }

    /// The view of a shape from points in its own frame, for the geometric distance.
    pub fn of_shape(shape: &Superellipsoid) -> Self {
        let model = Model { shape: *shape, pose: Pose::identity() };
        Self::new(&Normalization::identity(), &model, Residual::Geometric)
    }

    /// The same, rows being evaluated in the given precision.
    pub fn with_precision(self, precision: Precision) -> Self {
        Self { precision, ..self }
    }

    /// The same, the points being spread by noise so.
    pub fn with_spread(self, spread: Spread) -> Self {
        Self { spread: Some(spread), ..self }
    }

    /// The same of points by themselves that are given in the model's frame (normalised unit).
    pub(super) fn in_model_frame(&self) -> Self {
        Self {
            normalization: Normalization::identity(),
            translation: [0.0; 3],
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            spread: None,
            ..*self
        }
    }

    /// A point of the cloud, in the model's frame (normalised unit).
    #[inline(always)]
    pub fn model_from_cloud(&self, point: [f64; 3]) -> [f64; 3] {
        let Normalization { centroid, inverse_radius, .. } = self.normalization;
        let (mut offset, mut x_model) = ([0.0; 3], [0.0; 3]);
        // Loops, as the functions that take closures would not be compiled for the instruction set.
        for i in 0..3 {
            offset[i] = (point[i] - centroid[i]) * inverse_radius - self.translation[i];
        }
        for (x_model, axis) in x_model.iter_mut().zip(&self.axes) {
            *x_model = axis[0] * offset[0] + axis[1] * offset[1] + axis[2] * offset[2];
        }
        x_model
    }
}
