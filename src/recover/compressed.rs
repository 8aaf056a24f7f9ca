//! The least-squares problem that the optimiser sees: twelve rows with the same `J'J`, `J'r`
//! and `|r|` as the rows of all points.
//!
//! Levenberg-Marquardt needs no more than these. The twelve rows are the Cholesky factor R of
//! `[r J]' [r J]`: as `R'R` is that matrix, the residual `|r|, 0, ..` and the remaining columns
//! of R stand for it.

use levenberg_marquardt::LeastSquaresProblem;
use nalgebra::storage::Owned;
use nalgebra::{Const, SMatrix, SVector};

use super::chart::{Chart, Coordinates};
use super::constraints::NormalizedConstraints;
use super::kernel::{COLUMNS, Gram};
use super::radial::PARAMETERS;
use crate::model::Model;

/// A pivot that is a smaller share of its diagonal entry than this is rounding: its parameter
/// is then not determined by the rows beyond those before it.
const PIVOT_TOLERANCE: f64 = 1e-13;

/// An evaluated point of parameter space.
#[derive(Debug, Clone)]
pub(crate) struct Evaluation {
    pub coordinates: Coordinates,
    /// The model there, and the Gram matrix of its rows by local parameters; none outside the
    /// domain or after an interruption.
    pub model_and_gram: Option<(Model, Gram)>,
}

impl Evaluation {
    /// The sum of squared residuals; NaN outside the domain.
    pub fn cost(&self) -> f64 {
        self.model_and_gram.as_ref().map_or(f64::NAN, |(_, gram)| gram.residual_squares())
    }
}

/// The problem around one model. `rows` gives the Gram matrix of a model's rows; none once the
/// fit is interrupted, after which no step is taken any more.
pub(crate) struct CompressedProblem<R> {
    chart: Chart,
    rows: R,
    /// Share of the cost that a step must promise to be worth a pass.
    tolerance: f64,
    /// Rounding of each residual.
    rounding: f64,
    current: Evaluation,
    /// The evaluation of least cost so far.
    best: Evaluation,
    /// Passes over the points.
    pub passes: usize,
}

impl<R: Fn(&Model) -> Option<Gram>> CompressedProblem<R> {
    /// The problem, evaluated at the model it starts from. Once no step promises to lower the cost
    /// by more than a share of `tolerance`, it has no Jacobian any more.
    pub fn around(
        start: &Model,
        constraints: &NormalizedConstraints,
        tolerance: f64,
        rows: R,
    ) -> Self {
        let (chart, coordinates) = Chart::around(start, constraints);
        let start = Evaluation { coordinates, model_and_gram: None };
        let mut problem = Self {
            chart,
            rows,
            tolerance,
            rounding: 0.0,
            current: start.clone(),
            best: start,
            passes: 0,
        };
        problem.current = problem.evaluate(&coordinates);
        problem.best = problem.current.clone();
        problem
    }

    /// The same, each residual being rounded by so much: no step is worth a pass that promises less
    /// than what that does to the cost, `2 rounding / |r|` of it.
    pub fn with_rounding(self, rounding: f64) -> Self {
        Self { rounding, ..self }
    }

    /// The evaluation of least cost.
    pub fn into_best(self) -> Evaluation {
        self.best
    }

    fn evaluate(&mut self, coordinates: &Coordinates) -> Evaluation {
        let model = self.chart.model(coordinates);
        let model_and_gram = model.and_then(|model| Some((model, (self.rows)(&model)?)));
        self.passes += usize::from(model_and_gram.is_some());
        Evaluation { coordinates: *coordinates, model_and_gram }
    }
}

impl<R: Fn(&Model) -> Option<Gram>> LeastSquaresProblem<f64, Const<COLUMNS>, Const<PARAMETERS>>
    for CompressedProblem<R>
{
    type ResidualStorage = Owned<f64, Const<COLUMNS>>;
    type JacobianStorage = Owned<f64, Const<COLUMNS>, Const<PARAMETERS>>;
    type ParameterStorage = Owned<f64, Const<PARAMETERS>>;

    fn set_params(&mut self, coordinates: &Coordinates) {
        // The optimiser returns to the best point when a step was refused at the very end.
        if *coordinates == self.best.coordinates {
            self.current = self.best.clone();
            return;
        }
        self.current = self.evaluate(coordinates);
        if self.current.cost() < self.best.cost() {
            self.best = self.current.clone();
        }
    }

    fn params(&self) -> Coordinates {
        self.current.coordinates
    }

    /// `[|r|, 0, ..]`; NaN outside the domain, which makes the optimiser refuse the step (an
    /// answer of `None` would end it there).
    fn residuals(&self) -> Option<SVector<f64, COLUMNS>> {
        let mut residuals = SVector::zeros();
        residuals[0] = self.current.cost().sqrt();
        Some(residuals)
    }

    fn jacobian(&self) -> Option<SMatrix<f64, COLUMNS, PARAMETERS>> {
        let (model, gram) = self.current.model_and_gram.as_ref()?;
        let local =
            self.chart.local_from_coordinates(&self.current.coordinates, model.pose.rotation());
        let factor = factor(&pulled_back(gram, &local));
        let rounding_share = 2.0 * self.rounding / factor[(0, 0)];
        let is_worthwhile = promised_share(&factor) > self.tolerance.max(rounding_share);
        is_worthwhile.then(|| factor.fixed_columns::<PARAMETERS>(1).into_owned())
    }
}

/// The share of `r'r` that a whole Gauss-Newton step would take off a linear problem, from the
/// factor of `[r J]' [r J]`: the square of the cosine between r and the span of J.
///
/// With the factor's first row `|r|, b'` and S the triangle below, `J'J = b b' + S'S`, so the share
/// `b' (J'J)^-1 b` is `t / (1 + t)`, where `t = |y|^2` and `S'y = b`.
fn promised_share(factor: &SMatrix<f64, COLUMNS, COLUMNS>) -> f64 {
    let mut y = [0.0; COLUMNS];
    for j in (1..COLUMNS).filter(|&j| factor[(j, j)] > 0.0) {
        let before: f64 = (1..j).map(|k| factor[(k, j)] * y[k]).sum();
        y[j] = (factor[(0, j)] - before) / factor[(j, j)];
    }
    let square: f64 = y.iter().map(|y| y * y).sum();
    square / (1.0 + square)
}

/// The Gram matrix of the rows by other parameters: `diag(1, T)' G diag(1, T)`, all entries.
fn pulled_back(
    gram: &Gram,
    local_from_coordinates: &SMatrix<f64, PARAMETERS, PARAMETERS>,
) -> SMatrix<f64, COLUMNS, COLUMNS> {
    let full = SMatrix::<f64, COLUMNS, COLUMNS>::from_fn(|i, j| gram.matrix[i.min(j)][i.max(j)]);
    let mut transform = SMatrix::<f64, COLUMNS, COLUMNS>::identity();
    transform.fixed_view_mut::<PARAMETERS, PARAMETERS>(1, 1).copy_from(local_from_coordinates);
    transform.transpose() * full * transform
}

/// Upper triangular R with `R'R` equal to a positive semidefinite matrix; the rows of
/// parameters that are not determined are zero.
fn factor(matrix: &SMatrix<f64, COLUMNS, COLUMNS>) -> SMatrix<f64, COLUMNS, COLUMNS> {
    let mut r = SMatrix::<f64, COLUMNS, COLUMNS>::zeros();
    for i in 0..COLUMNS {
        let above: f64 = (0..i).map(|k| r[(k, i)] * r[(k, i)]).sum();
        let pivot = matrix[(i, i)] - above;
        if pivot <= PIVOT_TOLERANCE * matrix[(i, i)] {
            continue;
        }
        r[(i, i)] = pivot.sqrt();
        for j in i + 1..COLUMNS {
            let products: f64 = (0..i).map(|k| r[(k, i)] * r[(k, j)]).sum();
            r[(i, j)] = (matrix[(i, j)] - products) / r[(i, i)];
        }
    }
    r
}

#[cfg(test)]
mod tests {
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
            let transform =
                self.chart.local_from_coordinates(&self.coordinates, model.pose.rotation());
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
        let columns: [Vec<f64>; 3] =
            std::array::from_fn(|k| points.iter().map(|point| point[k]).collect());
        let normalization = Normalization::identity();
        let rows = |model: &Model| {
            let view = ModelView::new(&normalization, model, Residual::Radial);
            let points = [&columns[0][..], &columns[1], &columns[2]];
            Some(gram(&view, points, None, false))
        };
        let (chart, coordinates) = Chart::around(&start(), &NormalizedConstraints::NONE);
        let full = FullProblem { chart, coordinates, points };
        let optimiser = || {
            LevenbergMarquardt::new().with_stepbound(1.0).with_scale_diag(false).with_ftol(1e-10)
        };

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
}
