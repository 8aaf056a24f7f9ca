//! The eleven free numbers that the optimiser moves, around a model.
//!
//! Logarithms of the sizes; the exponents, of which what is beyond a bound counts as the bound;
//! a rotation vector on top of the current rotation; the centre. All are of order one in
//! normalised coordinates.

use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3};

use super::radial::PARAMETERS;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Superellipsoid;

/// Free parameters: `ln a (3), e (2), rotation vector (3), centre (3)`.
pub(crate) type Coordinates = SVector<f64, PARAMETERS>;

/// Bounds of both exponents: boxes are told from cubes of light, and shapes stay convex.
pub(crate) const EXPONENT_BOUNDS: [f64; 2] = [0.05, 2.0];

/// Bounds of `ln a` in normalised units, e^-9.3 = 1e-4 and e^1.8 = 6: whatever is seen of an
/// object, its semi-axes are not many times the RMS radius of the points, whereas the radial
/// distance is content with a face of a giant.
const LOG_SIZE_BOUNDS: [f64; 2] = [-9.3, 1.8];

/// Coordinates of the models around one rotation.
#[derive(Debug, Clone)]
pub(crate) struct Chart {
    base: Rotation3<f64>,
}

impl Chart {
    /// The chart around a model, and the model's own coordinates.
    pub fn around(model: &Model) -> (Self, Coordinates) {
        let mut coordinates = Coordinates::zeros();
        let size = model.shape.size();
        let exponents = model.shape.exponents();
        for k in 0..3 {
            coordinates[k] = size[k].ln();
            coordinates[8 + k] = model.pose.translation()[k];
        }
        for k in 0..2 {
            coordinates[3 + k] = within_bounds(exponents[k]);
        }
        (Self { base: *model.pose.rotation() }, coordinates)
    }

    /// The model at some coordinates; none where a size has run away.
    pub fn model(&self, coordinates: &Coordinates) -> Option<Model> {
        let log_size = coordinates.fixed_rows::<3>(0);
        // Written so that NaN is refused too.
        let [low, high] = LOG_SIZE_BOUNDS;
        let is_bounded = log_size.iter().all(|&log| log >= low && log <= high);
        if !is_bounded {
            return None;
        }
        let size = [log_size[0].exp(), log_size[1].exp(), log_size[2].exp()];
        let exponents = [within_bounds(coordinates[3]), within_bounds(coordinates[4])];
        let shape = Superellipsoid::new(size, exponents).ok()?;
        let rotation = self.base * Rotation3::new(rotation_vector(coordinates));
        let translation = coordinates.fixed_rows::<3>(8).into_owned();
        Some(Model { shape, pose: Pose::new(rotation, translation) })
    }

    /// Derivatives of the row's local parameters by the coordinates, at some coordinates.
    pub fn local_from_coordinates(
        &self,
        coordinates: &Coordinates,
        rotation: &Rotation3<f64>,
    ) -> SMatrix<f64, PARAMETERS, PARAMETERS> {
        let mut jacobian = SMatrix::<f64, PARAMETERS, PARAMETERS>::zeros();
        (0..3).for_each(|k| jacobian[(k, k)] = 1.0);
        // Beyond a bound an exponent rests: the other coordinates then converge without it.
        (3..5).for_each(|k| jacobian[(k, k)] = f64::from(!is_beyond_bounds(coordinates[k])));
        let turn = right_jacobian(&rotation_vector(coordinates));
        jacobian.fixed_view_mut::<3, 3>(5, 5).copy_from(&turn);
        jacobian.fixed_view_mut::<3, 3>(8, 8).copy_from(&rotation.matrix().transpose());
        jacobian
    }
}

fn rotation_vector(coordinates: &Coordinates) -> Vector3<f64> {
    coordinates.fixed_rows::<3>(5).into_owned()
}

fn within_bounds(exponent: f64) -> f64 {
    let [low, high] = EXPONENT_BOUNDS;
    exponent.clamp(low, high)
}

fn is_beyond_bounds(exponent: f64) -> bool {
    exponent != within_bounds(exponent)
}

/// Right Jacobian of the rotation group: `exp[v + dv] = exp[v] exp[J dv]`, `J = 1 - (1 - cos t)
/// / t^2 [v] + (t - sin t) / t^3 [v]^2` with `t = |v|`.
fn right_jacobian(v: &Vector3<f64>) -> Matrix3<f64> {
    let cross = v.cross_matrix();
    let square = v.norm_squared();
    // Below this the next term of the series, t^2/24, is lost to rounding.
    let (first, second) = if square < 1e-14 {
        (0.5, 1.0 / 6.0)
    } else {
        let angle = square.sqrt();
        let half_sine = (0.5 * angle).sin();
        (2.0 * half_sine * half_sine / square, (angle - angle.sin()) / (square * angle))
    };
    Matrix3::identity() - cross * first + cross * cross * second
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recover::radial::radial_row;

    fn model() -> Model {
        Model {
            shape: Superellipsoid::new([1.2, 0.7, 0.4], [0.3, 1.4]).unwrap(),
            pose: Pose::from_euler_zyz([0.5, 1.0, -2.0], Vector3::new(0.2, -0.1, 0.3)),
        }
    }

    #[test]
    fn a_model_is_found_at_its_own_coordinates() {
        let model = model();
        let (chart, coordinates) = Chart::around(&model);
        let again = chart.model(&coordinates).unwrap();
        for (a, b) in again.parameters().into_iter().zip(model.parameters()) {
            assert!((a - b).abs() < 1e-14);
        }
    }

    #[test]
    fn an_exponent_beyond_its_bound_counts_as_the_bound_and_rests() {
        let (chart, coordinates) = Chart::around(&model());
        for (beyond, bound) in [(-3.0, EXPONENT_BOUNDS[0]), (2.5, EXPONENT_BOUNDS[1])] {
            let mut moved = coordinates;
            moved[3] = beyond;
            let model = chart.model(&moved).unwrap();
            assert_eq!(model.shape.exponents()[0], bound);
            let jacobian = chart.local_from_coordinates(&moved, model.pose.rotation());
            assert!(jacobian.column(3).iter().all(|entry| *entry == 0.0));
        }
    }

    #[test]
    fn a_size_that_runs_away_or_is_not_a_number_gives_no_model() {
        let (chart, coordinates) = Chart::around(&model());
        for log_size in [1e3, -1e3, f64::NAN] {
            let mut moved = coordinates;
            moved[1] = log_size;
            assert!(chart.model(&moved).is_none());
        }
    }

    /// The whole chain: row of local parameters times the chart's Jacobian, against central
    /// differences of the distance, away from the chart's origin too.
    #[test]
    fn row_and_chart_together_give_the_derivatives_by_all_eleven_coordinates() {
        let (chart, origin) = Chart::around(&model());
        let mut away = origin;
        away.iter_mut().enumerate().for_each(|(k, c)| *c += 0.1 * (k as f64 - 3.0));
        for coordinates in [origin, away] {
            for point in [[0.9, 0.3, -0.4], [-0.5, 0.8, 0.6], [0.1, -1.5, 0.2]] {
                let point = Vector3::from(point);
                let distance = |at: &Coordinates| chart.model(at).unwrap().radial_distance(&point);
                let model = chart.model(&coordinates).unwrap();
                let local = model.pose.model_from_world(&point);
                let row = radial_row(local.into(), &model.shape.size(), &model.shape.exponents());
                let jacobian = chart.local_from_coordinates(&coordinates, model.pose.rotation());
                let gradient = jacobian.transpose() * Coordinates::from(row.gradient);
                for k in 0..PARAMETERS {
                    let step = 1e-6;
                    let (mut above, mut below) = (coordinates, coordinates);
                    above[k] += step;
                    below[k] -= step;
                    let quotient = (distance(&above) - distance(&below)) / (2.0 * step);
                    // Rounding over the step, and third derivatives of (2/e)^3 times its square.
                    assert!((gradient[k] - quotient).abs() < 1e-8, "{k} {gradient} {quotient}");
                }
            }
        }
    }
}
