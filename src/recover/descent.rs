//! One run of Levenberg-Marquardt from one model, on one set of points.

use std::cell::Cell;

use levenberg_marquardt::LevenbergMarquardt;

use super::compressed::CompressedProblem;
use super::constraints::{Bounds, NormalizedConstraints};
use super::evidence::Evidence;
use super::kernel::{Gram, ModelView, Residual, geometric_distances, gram};
use super::normalization::Normalization;
use super::options::Precision;
use super::ray_noise::RayNoise;
use super::result::Termination;
use crate::cloud::PointColumns;
use crate::model::Model;

/// Points from which on a pass is worth sharing among threads.
pub(crate) const PARALLEL_POINTS: usize = 16_384;

/// The points that a run looks at, and how they are normalised.
#[derive(Clone, Copy)]
pub(crate) struct PointSet<'a> {
    pub points: PointColumns<'a>,
    pub normalization: &'a Normalization,
    /// Roots of the points' weights; none where all weigh one.
    pub root_weights: Option<&'a [f64]>,
    /// What is known besides the points.
    pub evidence: &'a Evidence,
    /// What is known of the parameters.
    pub constraints: &'a NormalizedConstraints,
    /// Whether passes over the points are shared among threads.
    pub parallel: bool,
    /// Noise that is not alike in all directions.
    pub ray_noise: Option<&'a RayNoise>,
    /// What is minimised.
    pub residual: Residual,
    /// The numbers in which rows are evaluated.
    pub precision: Precision,
    /// Whether to give up; asked before every pass.
    pub is_interrupted: Interrupt<'a>,
}

/// A question to the caller: is the fit to end without a result? Once it is, it stays so.
pub(crate) type Interrupt<'a> = &'a (dyn Fn() -> bool + Sync);

impl PointSet<'_> {
    /// The number of points.
    pub fn len(&self) -> usize {
        self.points[0].len()
    }

    /// The Gram matrix of the rows of a model (normalised coordinates), those of evidence included;
    /// none if interrupted.
    pub fn gram(&self, model: &Model) -> Option<Gram> {
        if (self.is_interrupted)() {
            return None;
        }
        let view =
            ModelView::new(self.normalization, model, self.residual).with_precision(self.precision);
        let view = match self.ray_noise {
            Some(noise) => view.with_spread(noise.spread(model)),
            None => view,
        };
        let mut gram = gram(&view, self.points, self.root_weights, self.parallel);
        self.evidence.add_to(&mut gram, model, self.weight());
        Some(gram)
    }

    /// The signed geometric distance of each point from a model (normalised coordinates).
    pub fn geometric_distances(&self, model: &Model) -> Vec<f64> {
        let view = ModelView::new(self.normalization, model, Residual::Geometric);
        geometric_distances(&view, self.points, self.parallel)
    }

    /// Its square.
    pub fn geometric_squares(&self, model: &Model) -> Vec<f64> {
        let mut distances = self.geometric_distances(model);
        distances.iter_mut().for_each(|distance| *distance *= *distance);
        distances
    }

    /// The sum of the points' weights.
    pub fn weight(&self) -> f64 {
        let count = self.len() as f64;
        self.root_weights.map_or(count, |roots| roots.iter().map(|root| root * root).sum())
    }
}

/// Gain, in units of the residuals' variance, that is of the size of their chance.
const SMALL: f64 = 10.0;

/// Share of the cost below which rounding decides what is a gain.
const LEAST_TOLERANCE: f64 = 1e-8;

/// How far a run goes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    /// What a step must gain, or promise, to be worth a pass: in units of the residuals' variance, as
    /// the points' chi squared is.
    pub gain: f64,
    /// Evaluations, in units of twelve, after which it ends.
    pub patience: usize,
    /// The first step's bound, as a share of the coordinates' norm.
    pub step_bound: f64,
    /// Whether it starts near the minimum of many points: then the first pass does in single precision,
    /// since a step from there leads as far, and the run ends where the cost is rougher than what is
    /// left to gain.
    pub starts_near: bool,
}

impl Effort {
    /// As far as minima are told apart, by fewer points than follow.
    pub const MEDIUM: Self = Self { gain: 0.25, patience: 2, step_bound: 1.0, starts_near: false };

    /// To the end.
    pub const FINISH: Self = Self { gain: 1e-3, patience: 16, step_bound: 1.0, starts_near: false };

    /// The same as a share of the cost, which is worth as many variances as the points weigh.
    fn tolerance(&self, points: &PointSet) -> f64 {
        (self.gain / points.weight()).max(LEAST_TOLERANCE)
    }
}

/// Where a run has led.
#[derive(Debug, Clone)]
pub(crate) struct Descent {
    /// The model of least cost that was met, in normalised coordinates.
    pub model: Model,
    /// The Gram matrix of its rows.
    pub gram: Gram,
    /// Weighted mean squared radial distance, in normalised units.
    pub radial_mean_square: f64,
    /// Weighted mean squared first-order geometric distance, in normalised units.
    pub geometric_mean_square: f64,
    /// The same with what evidence adds: by this descents are ranked, since far from its own
    /// optimum the radial distance favours models much larger than the cloud.
    pub loss: f64,
    /// Passes over the points.
    pub passes: usize,
    /// Why the run ended.
    pub termination: Termination,
}

impl Descent {
    /// The same with the mean squares of the distances themselves, which rows of points of such weight
    /// hold.
    pub fn with_distances_of(self, rows: &Gram, weight: f64) -> Self {
        Self {
            radial_mean_square: rows.radial_squares / weight,
            geometric_mean_square: rows.geometric_squares / weight,
            ..self
        }
    }
}

/// Runs that a parameter resting at its bound may cause, by being released.
const RELEASES: usize = 2;

/// Minimises the residuals of the points from a start. None if the start itself is out of bounds,
/// or the fit is interrupted before the first pass.
///
/// Within a run a parameter that has passed its bound rests there; if the minimum of the others
/// leaves it drawn back inside, another run follows from there.
pub(crate) fn descend(points: &PointSet, start: &Model, effort: &Effort) -> Option<Descent> {
    descend_beside(points, start, effort, f64::INFINITY)
}

/// As [`descend`], given up where it is behind a rival's loss and promises little.
pub(crate) fn descend_beside(
    points: &PointSet,
    start: &Model,
    effort: &Effort,
    rival: f64,
) -> Option<Descent> {
    let mut descent = run(points, start, effort, rival)?;
    for _ in 0..RELEASES {
        if !is_drawn_inside(&descent, points.constraints) {
            break;
        }
        let further = run(points, &descent.model, effort, rival)?;
        let passes = descent.passes + further.passes;
        descent = Descent { passes, ..further };
    }
    Some(descent)
}

/// Whether the cost falls as a parameter that rests at its bound moves to the inside.
fn is_drawn_inside(descent: &Descent, constraints: &NormalizedConstraints) -> bool {
    let slopes = &descent.gram.matrix[0];
    let shape = &descent.model.shape;
    let is_drawn = |value: f64, slope: f64, [low, high]: Bounds| {
        low < high && ((value == low && slope < 0.0) || (value == high && slope > 0.0))
    };
    let [a, e] = [&slopes[1..4], &slopes[4..6]];
    let size = shape.size().map(f64::ln);
    (0..3).any(|k| is_drawn(size[k], a[k], constraints.log_size[k]))
        || (0..2).any(|k| is_drawn(shape.exponents()[k], e[k], constraints.exponents[k]))
}

fn run(points: &PointSet, start: &Model, effort: &Effort, rival: f64) -> Option<Descent> {
    let starts_in_single = effort.starts_near && points.precision == Precision::Double;
    let is_first = Cell::new(starts_in_single);
    let rows = |model: &Model| {
        let precision = if is_first.take() { Precision::Single } else { points.precision };
        PointSet { precision, ..*points }.gram(model)
    };
    let tolerance = effort.tolerance(points);
    let problem = CompressedProblem::around(start, points.constraints, tolerance, rows)
        .with_small(if effort.starts_near { SMALL / points.weight() } else { 0.0 })
        .with_rounding(points.precision.rounding())
        .with_rival(rival * points.weight());
    let (problem, report) = LevenbergMarquardt::new()
        .with_ftol(tolerance)
        .with_xtol(tolerance)
        .with_gtol(f64::EPSILON)
        .with_stepbound(effort.step_bound)
        .with_scale_diag(false)
        .with_patience(effort.patience)
        .minimize(problem);
    let passes = problem.passes;
    if starts_in_single && problem.is_best_at_start() {
        let further = run(points, start, &Effort { starts_near: false, ..*effort }, rival)?;
        return Some(Descent { passes: passes + further.passes, ..further });
    }
    let (model, gram) = problem.into_best().model_and_gram?;
    Some(Descent {
        model,
        gram,
        radial_mean_square: gram.radial_squares / points.weight(),
        geometric_mean_square: gram.geometric_squares / points.weight(),
        loss: gram.loss_squares() / points.weight(),
        passes,
        termination: report.termination.into(),
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::shape::Superellipsoid;
    use crate::surface::sample_surface;

    static IDENTITY: Normalization = Normalization::identity();
    static NO_EVIDENCE: Evidence = Evidence::NONE;

    /// Points by themselves, in normalised coordinates, and their geometric distances.
    pub(crate) fn bare(points: PointColumns) -> PointSet {
        PointSet {
            points,
            normalization: &IDENTITY,
            root_weights: None,
            ray_noise: None,
            evidence: &NO_EVIDENCE,
            constraints: &NormalizedConstraints::NONE,
            parallel: false,
            residual: Residual::Geometric,
            precision: Precision::Double,
            is_interrupted: &|| false,
        }
    }

    const FAR: Effort = Effort { gain: 1e-6, ..Effort::FINISH };
    const NEAR: Effort = Effort { starts_near: true, ..FAR };

    fn model(size: [f64; 3], exponents: [f64; 2]) -> Model {
        Model { shape: Superellipsoid::new(size, exponents).unwrap(), pose: Pose::identity() }
    }

    /// Points on both sides of a surface.
    fn points_about(truth: &Model) -> [Vec<f64>; 3] {
        let points = sample_surface(&truth.shape, 3_000, 1);
        let factor = |i: usize| if i.is_multiple_of(2) { 1.01 } else { 0.99 };
        [0, 1, 2].map(|k| (0..points.len()).map(|i| factor(i) * points[i][k]).collect())
    }

    #[test]
    fn what_starts_in_single_precision_ends_in_double() {
        let truth = model([1.0, 0.7, 1.2], [0.5, 0.9]);
        let columns = points_about(&truth);
        let points = bare(columns.each_ref().map(|column| &column[..]));
        let start = model([1.01, 0.7, 1.19], [0.51, 0.88]);
        let far = descend(&points, &start, &FAR).unwrap();
        let near = descend(&points, &start, &NEAR).unwrap();
        assert!((near.loss / far.loss - 1.0).abs() < 1e-9, "{} {}", near.loss, far.loss);
        for descent in [near, descend(&points, &far.model, &NEAR).unwrap()] {
            assert_eq!(Some(descent.gram), points.gram(&descent.model));
            assert!(descent.termination.at_minimum);
        }
    }
}
