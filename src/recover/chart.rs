//! The eleven free numbers that the optimiser moves, around a model.
//!
//! Logarithms of the sizes and the exponents, of which what is beyond a bound counts as the bound;
//! a rotation vector on top of the current rotation; the centre. All are of order one in
//! normalised coordinates. Of sizes that are tied each coordinate counts equally.

use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3};

use super::constraints::{Bounds, NormalizedConstraints};
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
    constraints: NormalizedConstraints,
}

impl Chart {
    /// The chart around a model, and the coordinates of what the constraints let of it.
    pub fn around(model: &Model, constraints: &NormalizedConstraints) -> (Self, Coordinates) {
        let mut coordinates = Coordinates::zeros();
        let size = model.shape.size();
        let exponents = model.shape.exponents();
        for k in 0..3 {
            let at = constraints.centre[k].unwrap_or(model.pose.translation()[k]);
            coordinates[k] = within(size[k].ln(), constraints.log_size[k]);
            coordinates[8 + k] = at;
        }
        for k in 0..2 {
            coordinates[3 + k] = within(exponents[k], constraints.exponents[k]);
        }
        (Self { base: *model.pose.rotation(), constraints: *constraints }, coordinates)
    }

    /// The model at some coordinates; none where a size has run away.
    pub fn model(&self, coordinates: &Coordinates) -> Option<Model> {
        let log_size = self.log_size(coordinates);
        // Written so that NaN is refused too.
        let [low, high] = LOG_SIZE_BOUNDS;
        let is_bounded = log_size.iter().all(|&log| log >= low && log <= high);
        if !is_bounded {
            return None;
        }
        let size = [0, 1, 2].map(|k| within(log_size[k], self.constraints.log_size[k]).exp());
        let exponents = [0, 1].map(|k| within(coordinates[3 + k], self.constraints.exponents[k]));
        let shape = Superellipsoid::new(size, exponents).ok()?;
        let rotation = self.base * Rotation3::new(rotation_vector(coordinates));
        let centre = self.constraints.centre;
        let translation = Vector3::from_fn(|k, _| centre[k].unwrap_or(coordinates[8 + k]));
        Some(Model { shape, pose: Pose::new(rotation, translation) })
    }

    /// Derivatives of the row's local parameters by the coordinates, at some coordinates.
    pub fn local_from_coordinates(
        &self,
        coordinates: &Coordinates,
        rotation: &Rotation3<f64>,
    ) -> SMatrix<f64, PARAMETERS, PARAMETERS> {
        let NormalizedConstraints { log_size: bounds, exponents, tied, centre } = self.constraints;
        let mut jacobian = SMatrix::<f64, PARAMETERS, PARAMETERS>::zeros();
        let log_size = self.log_size(coordinates);
        // Beyond a bound a parameter rests: the other coordinates then converge without it.
        for k in (0..3).filter(|&k| is_free(log_size[k], bounds[k])) {
            if k < tied {
                (0..tied).for_each(|j| jacobian[(k, j)] = 1.0 / tied as f64);
            } else {
                jacobian[(k, k)] = 1.0;
            }
        }
        for k in 0..2 {
            jacobian[(3 + k, 3 + k)] = f64::from(is_free(coordinates[3 + k], exponents[k]));
        }
        let turn = right_jacobian(&rotation_vector(coordinates));
        jacobian.fixed_view_mut::<3, 3>(5, 5).copy_from(&turn);
        jacobian.fixed_view_mut::<3, 3>(8, 8).copy_from(&rotation.matrix().transpose());
        for k in (0..3).filter(|&k| centre[k].is_some()) {
            jacobian.column_mut(8 + k).fill(0.0);
        }
        jacobian
    }

    /// `ln a` at some coordinates, those that are tied made equal.
    fn log_size(&self, coordinates: &Coordinates) -> [f64; 3] {
        let tied = self.constraints.tied;
        let mean = coordinates.rows(0, tied).mean();
        std::array::from_fn(|k| if k < tied { mean } else { coordinates[k] })
    }
}

fn rotation_vector(coordinates: &Coordinates) -> Vector3<f64> {
    coordinates.fixed_rows::<3>(5).into_owned()
}

fn within(value: f64, [low, high]: Bounds) -> f64 {
    value.clamp(low, high)
}

/// Whether a value may move either way: it is not beyond its bounds, and they leave it room.
fn is_free(value: f64, [low, high]: Bounds) -> bool {
    low < high && value >= low && value <= high
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
        let (chart, coordinates) = Chart::around(&model, &NormalizedConstraints::NONE);
        let again = chart.model(&coordinates).unwrap();
        for (a, b) in again.parameters().into_iter().zip(model.parameters()) {
            assert!((a - b).abs() < 1e-14);
        }
    }

    #[test]
    fn an_exponent_beyond_its_bound_counts_as_the_bound_and_rests() {
        let (chart, coordinates) = Chart::around(&model(), &NormalizedConstraints::NONE);
        for (beyond, bound) in [(-3.0, EXPONENT_BOUNDS[0]), (2.5, EXPONENT_BOUNDS[1])] {
            let mut moved = coordinates;
            moved[3] = beyond;
            let model = chart.model(&moved).unwrap();
            assert_eq!(model.shape.exponents()[0], bound);
            let jacobian = chart.local_from_coordinates(&moved, model.pose.rotation());
            assert!(jacobian.column(3).iter().all(|entry| *entry == 0.0));
        }
    }

    fn constrained() -> NormalizedConstraints {
        NormalizedConstraints {
            log_size: [[-0.5, 0.5], [-0.5, 0.5], [0.3, 0.3]],
            exponents: [[0.2, 1.0], [1.0, 1.0]],
            tied: 2,
            centre: [None, Some(0.7), None],
        }
    }

    #[test]
    fn constraints_hold_at_all_coordinates() {
        let (chart, origin) = Chart::around(&model(), &constrained());
        for step in [0.0, 0.3, -0.7, 2.0] {
            let mut moved = origin;
            (0..8).for_each(|k| moved[k] += step * (k as f64 - 3.0));
            let Some(model) = chart.model(&moved) else { continue };
            let [a1, a2, a3] = model.shape.size();
            let [e1, e2] = model.shape.exponents();
            assert_eq!((a1, a3, e2), (a2, 0.3_f64.exp(), 1.0));
            assert!((0.2..=1.0).contains(&e1) && a1.ln().abs() <= 0.5 + 1e-15);
            assert_eq!(model.pose.translation().y, 0.7);
        }
    }

    #[test]
    fn a_size_that_runs_away_or_is_not_a_number_gives_no_model() {
        let (chart, coordinates) = Chart::around(&model(), &NormalizedConstraints::NONE);
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
        for constraints in [NormalizedConstraints::NONE, constrained()] {
            let (chart, origin) = Chart::around(&model(), &constraints);
            let mut away = origin;
            (0..8).for_each(|k| away[k] += 0.1 * (k as f64 - 3.0));
            check_gradient(&chart, &origin);
            check_gradient(&chart, &away);
        }
    }

    fn check_gradient(chart: &Chart, coordinates: &Coordinates) {
        for point in [[0.9, 0.3, -0.4], [-0.5, 0.8, 0.6], [0.1, -1.5, 0.2]] {
            let point = Vector3::from(point);
            let distance = |at: &Coordinates| chart.model(at).unwrap().radial_distance(&point);
            let model = chart.model(coordinates).unwrap();
            let local = model.pose.model_from_world(&point);
            let row = radial_row(local.into(), &model.shape.size(), &model.shape.exponents());
            let jacobian = chart.local_from_coordinates(coordinates, model.pose.rotation());
            let gradient = jacobian.transpose() * Coordinates::from(row.gradient);
            for k in 0..PARAMETERS {
                let step = 1e-6;
                let (mut above, mut below) = (*coordinates, *coordinates);
                above[k] += step;
                below[k] -= step;
                let quotient = (distance(&above) - distance(&below)) / (2.0 * step);
                // Rounding over the step, and third derivatives of (2/e)^3 times its square.
                assert!((gradient[k] - quotient).abs() < 1e-8, "{k} {gradient} {quotient}");
            }
        }
    }
}
