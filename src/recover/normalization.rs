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
    pub const fn identity() -> Self {
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
        let spans = points.map(Span::of);
        let centroid = spans.map(|span| span.mean);
        let reach = spans.iter().fold(0.0, |most: f64, span| most.max(span.reach()));
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
        let greatest_magnitude =
            spans.iter().fold(0.0, |greatest: f64, span| greatest.max(span.greatest_magnitude()));
        Self {
            normalization: Normalization { centroid, radius, inverse_radius: radius.recip() },
            axes,
            deviations,
            greatest_magnitude,
            resolution: f64::EPSILON * greatest_magnitude / radius,
        }
    }
}

/// Values summed side by side: a sum that waits for the one before it would take most of the time.
const LANES: usize = 8;

/// What is wanted of one coordinate of all points.
#[derive(Debug, Clone, Copy)]
struct Span {
    low: f64,
    high: f64,
    mean: f64,
}

impl Span {
    /// The mean is taken relative to the first value so that a far offset costs no digits.
    fn of(values: &[f64]) -> Self {
        let first = values[0];
        let (mut low, mut high, mut sums) = ([first; LANES], [first; LANES], [0.0; LANES]);
        let (whole, rest) = values.as_chunks::<LANES>();
        let mut last = [first; LANES];
        last[..rest.len()].copy_from_slice(rest);
        for lanes in whole.iter().chain([&last]) {
            for (k, value) in lanes.iter().enumerate() {
                low[k] = if *value < low[k] { *value } else { low[k] };
                high[k] = if *value > high[k] { *value } else { high[k] };
                sums[k] += value - first;
            }
        }
        Self {
            low: low.into_iter().fold(first, f64::min),
            high: high.into_iter().fold(first, f64::max),
            mean: first + sums.iter().sum::<f64>() / values.len() as f64,
        }
    }

    /// The greatest difference from the mean.
    fn reach(&self) -> f64 {
        (self.high - self.mean).max(self.mean - self.low)
    }

    fn greatest_magnitude(&self) -> f64 {
        self.high.abs().max(self.low.abs())
    }
}

/// Mean product of coordinates relative to the centroid, in units of `reach`, whose squares
/// neither overflow nor vanish.
fn scatter(points: PointColumns, centroid: &[f64; 3], reach: f64) -> Matrix3<f64> {
    let inverse = reach.recip();
    let [xs, ys, zs] = points.map(|column| column.as_chunks::<LANES>());
    let mut sums = [[0.0; LANES]; PRODUCTS.len()];
    let mut add = |columns: [&[f64]; 3]| {
        for lane in 0..columns[0].len() {
            let d: [f64; 3] = std::array::from_fn(|k| (columns[k][lane] - centroid[k]) * inverse);
            for (sums, [i, j]) in sums.iter_mut().zip(PRODUCTS) {
                sums[lane] += d[i] * d[j];
            }
        }
    };
    for ((x, y), z) in xs.0.iter().zip(ys.0).zip(zs.0) {
        add([x, y, z]);
    }
    add([xs.1, ys.1, zs.1]);
    let mut scatter = Matrix3::zeros();
    for (sums, [i, j]) in sums.iter().zip(PRODUCTS) {
        let mean = sums.iter().sum::<f64>() / points[0].len() as f64;
        (scatter[(i, j)], scatter[(j, i)]) = (mean, mean);
    }
    scatter
}

/// The products of two coordinates of one point.
const PRODUCTS: [[usize; 2]; 6] = [[0, 0], [0, 1], [0, 2], [1, 1], [1, 2], [2, 2]];

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
