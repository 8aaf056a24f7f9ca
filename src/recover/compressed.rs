//! The least-squares problem that the optimiser sees: twelve rows with the same `J'J`, `J'r`
//! and `|r|` as the rows of all points.
//!
//! Levenberg-Marquardt needs no more than these. The twelve rows are the Cholesky factor R of
//! `[r J]' [r J]`: as `R'R` is that matrix, the residual `|r|, 0, ..` and the remaining columns
//! of R stand for it.

use std::cell::Cell;

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

/// A problem is behind a rival where so many steps like the next would not catch up.
const STEPS_TO_CATCH_UP: f64 = 3.0;

/// Share of a small promise that a step keeps, or has broken it, and steps in a row that may have: where
/// more do, the cost is rougher than what is left to gain.
const KEPT: f64 = 0.1;
const MOST_BROKEN: usize = 1;

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
    start: Coordinates,
    rows: R,
    /// Share of the cost that a step must promise to be worth a pass.
    tolerance: f64,
    /// Rounding of each residual.
    rounding: f64,
    /// Share of the cost below which a promise is small.
    small: f64,
    /// The least loss, as a sum of squares, that was found from elsewhere.
    rival: f64,
    /// The share of the cost that the next step promises.
    promised: Cell<f64>,
    /// Steps in a row that have broken a small promise.
    broken: usize,
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
            start: coordinates,
            rows,
            tolerance,
            rounding: 0.0,
            small: 0.0,
            promised: Cell::new(f64::INFINITY),
            broken: 0,
            rival: f64::INFINITY,
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

    /// The same, at its end once steps that promise less than this share of the cost break their promise:
    /// where points lie on the creases of a model, its cost is rough, and its least place chance.
    pub fn with_small(self, small: f64) -> Self {
        Self { small, ..self }
    }

    /// The same, given up where it is behind a rival's loss and no step promises much any more.
    pub fn with_rival(self, rival: f64) -> Self {
        Self { rival, ..self }
    }

    /// Whether no evaluation has less cost than the first.
    pub fn is_best_at_start(&self) -> bool {
        self.best.coordinates == self.start
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
        // A step that was refused is tried again where the optimiser's bound, though narrowed, still
        // allows it.
        if *coordinates == self.current.coordinates {
            return;
        }
        self.current = self.evaluate(coordinates);
        let gained = 1.0 - self.current.cost() / self.best.cost();
        let promised = self.promised.get();
        let is_broken = promised < self.small && gained < KEPT * promised;
        self.broken = if is_broken { self.broken + 1 } else { 0 };
        if self.current.cost() < self.best.cost() {
            self.best = self.current.clone();
        }
    }

    fn params(&self) -> Coordinates {
        self.current.coordinates
    }

    /// `[|r|, 0, ..]`; NaN outside the domain, which makes the optimiser refuse the step. None ends it.
    fn residuals(&self) -> Option<SVector<f64, COLUMNS>> {
        let mut residuals = SVector::zeros();
        residuals[0] = self.current.cost().sqrt();
        (self.broken <= MOST_BROKEN).then_some(residuals)
    }

    fn jacobian(&self) -> Option<SMatrix<f64, COLUMNS, PARAMETERS>> {
        let (model, gram) = self.current.model_and_gram.as_ref()?;
        let local =
            self.chart.local_from_coordinates(&self.current.coordinates, model.pose.rotation());
        let factor = factor(&pulled_back(gram, &local));
        let rounding_share = 2.0 * self.rounding / factor[(0, 0)];
        let promised = promised_share(&factor);
        self.promised.set(promised);
        let behind = 1.0 - self.rival / gram.loss_squares();
        let needed = self.tolerance.max(rounding_share).max(behind / STEPS_TO_CATCH_UP);
        (promised > needed).then(|| factor.fixed_columns::<PARAMETERS>(1).into_owned())
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
    let half = by_other_parameters(&full, local_from_coordinates);
    by_other_parameters(&half.transpose(), local_from_coordinates)
}

/// `M diag(1, T)`, where most entries of T are zero.
fn by_other_parameters(
    matrix: &SMatrix<f64, COLUMNS, COLUMNS>,
    local_from_coordinates: &SMatrix<f64, PARAMETERS, PARAMETERS>,
) -> SMatrix<f64, COLUMNS, COLUMNS> {
    let mut product = SMatrix::<f64, COLUMNS, COLUMNS>::zeros();
    product.set_column(0, &matrix.column(0));
    for j in 0..PARAMETERS {
        for k in 0..PARAMETERS {
            let entry = local_from_coordinates[(k, j)];
            if entry != 0.0 {
                product.column_mut(1 + j).axpy(entry, &matrix.column(1 + k), 1.0);
            }
        }
    }
    product
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
mod tests;
