//! Normalised coordinates: the cloud's centroid at the origin, its RMS radius the unit; and the
//! second moments that go with them.

use nalgebra::{Matrix3, Rotation3, SymmetricEigen, Vector3};

use crate::cloud::PointColumns;
use crate::model::Model;
use crate::pose::Pose;

/// The similarity `x_normalised = (x_cloud - centroid) / radius`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Normalization {
    /// The cloud's centroid, in its own coordinates.
    pub centroid: [f64; 3],
    /// Root mean square distance of the points from the centroid.
    pub radius: f64,
    /// One over that.
    pub inverse_radius: f64,
}

impl Normalization {
    /// The similarity that changes nothing.
    #[cfg(test)]
    pub fn identity() -> Self {
        Self { centroid: [0.0; 3], radius: 1.0, inverse_radius: 1.0 }
    }

    /// A model of normalised coordinates, in those of the cloud.
    pub fn cloud_from_normalized(&self, model: &Model) -> Model {
        let translation = Vector3::from(self.centroid) + model.pose.translation() * self.radius;
        Model {
            shape: model.shape.scaled(self.radius),
            pose: Pose::new(*model.pose.rotation(), translation),
        }
    }

    /// A point of the cloud's coordinates, in normalised ones.
    pub fn normalized(&self, point: [f64; 3]) -> Vector3<f64> {
        (Vector3::from(point) - Vector3::from(self.centroid)) * self.inverse_radius
    }

    /// A point of another normalisation of the same cloud, in this one's coordinates.
    pub fn point_of(&self, other: &Self, point: &Vector3<f64>) -> Vector3<f64> {
        let ratio = other.radius * self.inverse_radius;
        self.normalized(other.centroid) + point * ratio
    }

    /// A model of another normalisation of the same cloud, in this one's coordinates.
    pub fn model_of(&self, other: &Self, model: &Model) -> Model {
        let translation = self.point_of(other, model.pose.translation());
        Model {
            shape: model.shape.scaled(other.radius * self.inverse_radius),
            pose: Pose::new(*model.pose.rotation(), translation),
        }
    }
}

/// Centroid, spread and principal axes of some points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moments {
    /// Centroid and RMS radius.
    pub normalization: Normalization,
    /// Principal axes as columns, by falling scatter; right-handed.
    pub axes: Rotation3<f64>,
    /// Standard deviations along the principal axes in normalised units, falling.
    pub deviations: [f64; 3],
    /// Greatest coordinate by magnitude, in the cloud's unit.
    pub greatest_magnitude: f64,
    /// Rounding of the points' coordinates in normalised units.
    pub resolution: f64,
}

impl Moments {
    /// Those of at least one point. A radius of zero (all points coincide) is replaced by one;
    /// that of a cloud at the end of the range of numbers is its reach, without axes.
    pub fn of(points: PointColumns) -> Self {
        let centroid = points.map(mean);
        let reach = reach(points, &centroid);
        let (radius, scatter) = if reach == 0.0 {
            (1.0, Matrix3::zeros())
        } else if !reach.recip().is_normal() {
            (reach, Matrix3::zeros())
        } else {
            let scatter = scatter(points, &centroid, reach);
            let spread = scatter.trace();
            (reach * spread.sqrt(), scatter / spread)
        };
        let (axes, deviations) = principal_axes(&scatter);
        let greatest_magnitude = greatest_magnitude(points);
        Self {
            normalization: Normalization { centroid, radius, inverse_radius: radius.recip() },
            axes,
            deviations,
            greatest_magnitude,
            resolution: f64::EPSILON * greatest_magnitude / radius,
        }
    }
}

/// The mean, taken relative to the first value so that a far offset costs no digits.
fn mean(values: &[f64]) -> f64 {
    let first = values[0];
    first + values.iter().map(|value| value - first).sum::<f64>() / values.len() as f64
}

/// The greatest difference of a coordinate from the centroid's.
fn reach(points: PointColumns, centroid: &[f64; 3]) -> f64 {
    let greatest = |k: usize| {
        points[k].iter().fold(0.0, |most: f64, value| most.max((value - centroid[k]).abs()))
    };
    greatest(0).max(greatest(1)).max(greatest(2))
}

/// Mean product of coordinates relative to the centroid, in units of `reach`, whose squares
/// neither overflow nor vanish.
fn scatter(points: PointColumns, centroid: &[f64; 3], reach: f64) -> Matrix3<f64> {
    let [xs, ys, zs] = points;
    let [cx, cy, cz] = centroid;
    let mut scatter = Matrix3::zeros();
    for ((x, y), z) in xs.iter().zip(ys).zip(zs) {
        let d = Vector3::new(x - cx, y - cy, z - cz) * reach.recip();
        scatter += d * d.transpose();
    }
    scatter / xs.len() as f64
}

fn greatest_magnitude(points: PointColumns) -> f64 {
    points.into_iter().flatten().fold(0.0, |greatest: f64, value| greatest.max(value.abs()))
}

/// Principal axes and standard deviations of a scatter matrix, by falling deviation.
fn principal_axes(scatter: &Matrix3<f64>) -> (Rotation3<f64>, [f64; 3]) {
    let eigen = SymmetricEigen::new(*scatter);
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| eigen.eigenvalues[j].total_cmp(&eigen.eigenvalues[i]));
    let deviations = order.map(|i| eigen.eigenvalues[i].max(0.0).sqrt());
    let first = eigen.eigenvectors.column(order[0]).into_owned();
    let second = eigen.eigenvectors.column(order[1]).into_owned();
    let axes = Matrix3::from_columns(&[first, second, first.cross(&second)]);
    (Rotation3::from_matrix_unchecked(axes), deviations)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Superellipsoid;

    #[test]
    fn moments_of_a_turned_and_distant_box_of_points() {
        let pose = Pose::from_euler_zyz([0.4, 1.0, -0.3], Vector3::new(1e5, -2e5, 5e4));
        let mut columns: [Vec<f64>; 3] = Default::default();
        for x in [-3.0, 3.0] {
            for y in [-2.0, 2.0] {
                for z in [-1.0, 1.0] {
                    let point = pose.world_from_model(&Vector3::new(x, y, z));
                    (0..3).for_each(|k| columns[k].push(point[k]));
                }
            }
        }
        let moments = Moments::of([&columns[0], &columns[1], &columns[2]]);
        let normalization = moments.normalization;
        // Rounding of coordinates of 2e5.
        let tolerance = 1e-10;
        let centroid = Vector3::from(normalization.centroid);
        assert!((centroid - pose.translation()).norm() < tolerance);
        assert!((normalization.radius - 14.0_f64.sqrt()).abs() < tolerance);
        for (deviation, extent) in moments.deviations.into_iter().zip([3.0, 2.0, 1.0]) {
            assert!((deviation - extent / 14.0_f64.sqrt()).abs() < tolerance);
        }
        for k in 0..3 {
            let turned = pose.rotation().matrix().column(k).dot(&moments.axes.matrix().column(k));
            assert!((turned.abs() - 1.0).abs() < tolerance);
        }
        assert!((moments.axes.matrix().determinant() - 1.0).abs() < tolerance);
        assert!(moments.resolution > 0.0 && moments.resolution < 1e-10);
    }

    #[test]
    fn a_model_returns_to_the_clouds_coordinates() {
        let normalization =
            Normalization { centroid: [5.0, 6.0, 7.0], radius: 2.0, inverse_radius: 0.5 };
        let model = Model {
            shape: Superellipsoid::new([1.0, 0.5, 0.25], [1.0, 1.0]).unwrap(),
            pose: Pose::new(Rotation3::identity(), Vector3::new(1.0, 0.0, -1.0)),
        };
        let in_cloud = normalization.cloud_from_normalized(&model);
        assert_eq!(in_cloud.shape.size(), [2.0, 1.0, 0.5]);
        assert_eq!(*in_cloud.pose.translation(), Vector3::new(7.0, 6.0, 5.0));
    }
}
