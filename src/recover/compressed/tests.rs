//! The compressed problem against the problem of all rows.

use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, DVector, Dyn, OMatrix, Rotation3, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::pose::Pose;
use crate::recover::kernel::{ModelView, Residual, gram};
use crate::recover::normalization::Normalization;
use crate::recover::radial::radial_row;
use crate::shape::Superellipsoid;
use crate::surface::sample_surface;

/// All rows, one a point, as the optimiser would take them without compression.
struct FullProblem {
    chart: Chart,
    coordinates: Coordinates,
    points: Vec<Vector3<f64>>,
}

impl FullProblem {
    fn rows(&self) -> (DVector<f64>, OMatrix<f64, Dyn, Const<PARAMETERS>>) {
        let model = self.chart.model(&self.coordinates).unwrap();
        let (size, exponents) = (model.shape.size(), model.shape.exponents());
        let transform = self.chart.local_from_coordinates(&self.coordinates, model.pose.rotation());
        let rows: Vec<_> = self
            .points
            .iter()
            .map(|x| radial_row(model.pose.model_from_world(x).into(), &size, &exponents))
            .collect();
        let local = DMatrix::from_fn(rows.len(), PARAMETERS, |i, j| rows[i].gradient[j]);
        (DVector::from_fn(rows.len(), |i, _| rows[i].distance), local * transform)
    }
}

impl LeastSquaresProblem<f64, Dyn, Const<PARAMETERS>> for FullProblem {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Const<PARAMETERS>>;
    type ParameterStorage = Owned<f64, Const<PARAMETERS>>;

    fn set_params(&mut self, coordinates: &Coordinates) {
        self.coordinates = *coordinates;
    }

    fn params(&self) -> Coordinates {
        self.coordinates
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.rows().0)
    }

    fn jacobian(&self) -> Option<OMatrix<f64, Dyn, Const<PARAMETERS>>> {
        Some(self.rows().1)
    }
}

fn noisy_points(rng: &mut ChaCha8Rng) -> Vec<Vector3<f64>> {
    let truth = Superellipsoid::new([1.0, 0.6, 1.4], [0.5, 1.3]).unwrap();
    let mut points = sample_surface(&truth, 2000, 5);
    for point in &mut points {
        *point += Vector3::from_fn(|_, _| rng.random_range(-0.02..0.02));
    }
    points
}

fn columns(points: &[Vector3<f64>]) -> [Vec<f64>; 3] {
    std::array::from_fn(|k| points.iter().map(|point| point[k]).collect())
}

/// The Gram matrix of all rows of a model.
fn gram_of(columns: &[Vec<f64>; 3], model: &Model) -> Option<Gram> {
    let view = ModelView::new(&Normalization::identity(), model, Residual::Radial);
    Some(gram(&view, [&columns[0], &columns[1], &columns[2]], None, false))
}

fn start() -> Model {
    Model {
        shape: Superellipsoid::new([1.2, 0.8, 1.0], [1.0, 1.0]).unwrap(),
        pose: Pose::new(
            Rotation3::from_euler_angles(0.1, -0.2, 0.15),
            Vector3::new(0.1, 0.0, -0.1),
        ),
    }
}

#[test]
fn takes_the_same_steps_as_the_problem_of_all_rows() {
    let points = noisy_points(&mut ChaCha8Rng::seed_from_u64(1));
    let columns = columns(&points);
    let rows = |model: &Model| gram_of(&columns, model);
    let (chart, coordinates) = Chart::around(&start(), &NormalizedConstraints::NONE);
    let full = FullProblem { chart, coordinates, points };
    let optimiser =
        || LevenbergMarquardt::new().with_stepbound(1.0).with_scale_diag(false).with_ftol(1e-10);

    let (full, full_report) = optimiser().minimize(full);
    let (compressed, report) = optimiser().minimize(CompressedProblem::around(
        &start(),
        &NormalizedConstraints::NONE,
        0.0,
        rows,
    ));

    assert!(report.termination.was_successful(), "{:?}", report.termination);
    assert_eq!(report.termination, full_report.termination);
    assert_eq!(report.number_of_evaluations, full_report.number_of_evaluations);
    let difference = (compressed.into_best().coordinates - full.coordinates).amax();
    // The Gram matrix squares a condition number of 1e3; cost is flat to its root.
    assert!(difference < 1e-9, "{difference:e}");
    let relative = report.objective_function / full_report.objective_function - 1.0;
    assert!(relative.abs() < 1e-13, "{relative:e}");
}

#[test]
fn a_problem_behind_a_rival_is_given_up_and_one_that_will_pass_it_is_not() {
    let columns = columns(&noisy_points(&mut ChaCha8Rng::seed_from_u64(1)));
    let rows = |model: &Model| gram_of(&columns, model);
    let run = |rival: f64| {
        let none = &NormalizedConstraints::NONE;
        let problem = CompressedProblem::around(&start(), none, 1e-8, rows).with_rival(rival);
        let (problem, _) = LevenbergMarquardt::new().with_scale_diag(false).minimize(problem);
        let passes = problem.passes;
        let (_, gram) = problem.into_best().model_and_gram.unwrap();
        (gram.loss_squares(), passes)
    };
    let (least, passes) = run(f64::INFINITY);
    assert_eq!(run(1.01 * least), (least, passes));
    let (given_up, few) = run(0.1 * least);
    assert!(few < passes && given_up < 2.0 * least, "{few} of {passes}: {given_up} {least}");
}

#[test]
fn steps_in_a_row_that_break_small_promises_end_the_descent() {
    let columns = columns(&noisy_points(&mut ChaCha8Rng::seed_from_u64(1)));
    let passes = |small: f64| {
        // Whatever the rows promise, each evaluation costs ten times the one before.
        let factor = Cell::new(1.0);
        let rows = |model: &Model| {
            let mut gram = gram_of(&columns, model)?;
            gram.matrix[0][0] *= factor.replace(10.0 * factor.get());
            Some(gram)
        };
        let none = &NormalizedConstraints::NONE;
        let problem = CompressedProblem::around(&start(), none, 0.0, rows).with_small(small);
        let (problem, _) = LevenbergMarquardt::new().with_scale_diag(false).minimize(problem);
        assert!(problem.is_best_at_start());
        problem.passes
    };
    assert_eq!(passes(1.0), 1 + 1 + MOST_BROKEN);
    assert!(passes(0.0) > 10, "{}", passes(0.0));
}

#[test]
fn the_promised_share_is_that_of_the_residual_in_the_span_of_the_jacobian() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let rows = SMatrix::<f64, 40, COLUMNS>::from_fn(|_, _| rng.random_range(-1.0..1.0));
    let residual = rows.column(0).into_owned();
    let jacobian = rows.fixed_columns::<PARAMETERS>(1).into_owned();
    let span = jacobian.qr().q();
    let expected = (span.transpose() * residual).norm_squared() / residual.norm_squared();
    let share = promised_share(&factor(&(rows.transpose() * rows)));
    assert!((share / expected - 1.0).abs() < 1e-12, "{share} {expected}");
}

#[test]
fn the_factor_of_a_singular_matrix_leaves_out_what_is_not_determined() {
    let mut rows = SMatrix::<f64, COLUMNS, COLUMNS>::zeros();
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for i in 0..5 {
        (0..COLUMNS).for_each(|j| rows[(i, j)] = rng.random_range(-1.0..1.0));
    }
    let matrix = rows.transpose() * rows;
    let r = factor(&matrix);
    assert!((r.transpose() * r - matrix).amax() < 1e-12);
    assert!((5..COLUMNS).all(|i| r.row(i).amax() == 0.0));
}
