//! Expectation and maximisation in turn: the mixture of surface and strays, and the model in it.

use super::descent::{Descent, Effort, PointSet, descend};
use super::ends::without_ends_by_chance;
use super::mixture::{Expectation, Mixture};
use super::radial::PARAMETERS;
use crate::model::Model;

/// Relative change of the noise's deviation, and of the share of strays, at the end.
const SETTLED: f64 = 1e-4;

/// Rounds in which ends that strays make out are left out.
const ROUNDS_WITHOUT_ENDS: usize = 4;

/// A maximisation between two expectations.
const STEP: Effort = Effort::MEDIUM;

/// The 30 % quantile of the square of a normal deviate.
const LOW_QUANTILE: f64 = 0.148;

/// A fit of the mixture.
#[derive(Debug, Clone)]
pub(crate) struct MixtureFit {
    /// The model and its rows, weighted.
    pub descent: Descent,
    /// The mixture around it.
    pub mixture: Mixture,
    /// Probability of each point to be one of the surface.
    pub weights: Vec<f64>,
    /// Mean logarithm of the points' density, less what evidence speaks against the model.
    pub log_likelihood: f64,
    /// Passes over the points.
    pub passes: usize,
}

impl MixtureFit {
    /// Indices of the points that are of the surface more likely than not.
    pub fn surface(&self) -> Vec<usize> {
        (0..self.weights.len()).filter(|&i| self.weights[i] > 0.5).collect()
    }
}

/// How an alternation goes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Schedule {
    /// Most rounds.
    pub rounds: usize,
    /// Whether the share of strays is estimated too, or stays as it is.
    pub is_share_free: bool,
    /// Rounds of the mixture alone before each descent, which cost far less than it.
    pub mixture_rounds: usize,
}

/// Alternates from a model and a mixture until both are settled. `odds` are what neighbours say of
/// each point. None if the model is out of bounds, or the fit is interrupted.
pub(crate) fn alternate(
    points: &PointSet,
    odds: Option<&[f64]>,
    start: &Model,
    mixture: Mixture,
    schedule: Schedule,
) -> Option<MixtureFit> {
    let constrained = |next: Mixture| match schedule.is_share_free {
        true => next,
        false => Mixture { stray_share: mixture.stray_share, ..next },
    };
    let (mut model, mut mixture, mut passes) = (*start, mixture, 0);
    let mut last = None;
    for _ in 0..schedule.rounds {
        let squares = points.geometric_squares(&model);
        let mut expectation = mixture.expect(&squares, odds);
        for _ in 0..schedule.mixture_rounds {
            expectation = constrained(expectation.next).expect(&squares, odds);
        }
        let descent = descend_weighted(points, &expectation.weights, &model, &STEP)?;
        passes += descent.passes + 1;
        model = descent.model;
        last = Some(descent);
        let next = constrained(expectation.next);
        let settled = is_settled(&mixture, &next);
        mixture = next;
        if settled {
            break;
        }
    }
    let descent = last?;
    let Expectation { weights, log_likelihood, next } =
        mixture.expect(&points.geometric_squares(&model), odds);
    let mixture = constrained(next);
    let against = 0.5 * descent.gram.evidence_squares / (mixture.variance * weights.len() as f64);
    let log_likelihood = log_likelihood - if against.is_finite() { against } else { 0.0 };
    Some(MixtureFit { descent, mixture, weights, log_likelihood, passes: passes + 1 })
}

/// The model to the end under the weights of a fit. None if too few points are of its surface to
/// determine it.
pub(crate) fn finish(points: &PointSet, fit: MixtureFit) -> Option<MixtureFit> {
    if fit.surface().len() <= PARAMETERS {
        return None;
    }
    let descent = descend_weighted(points, &fit.weights, &fit.descent.model, &Effort::FINISH)?;
    let passes = fit.passes + descent.passes;
    Some(MixtureFit { descent, passes, ..fit })
}

/// A fit without the ends that strays alone make out, and without their points, in a few rounds.
/// `odds` are what else is known of each point. None if the fit is interrupted.
pub(crate) fn without_ends_of_strays(
    points: &PointSet,
    odds: Option<&[f64]>,
    mut fit: MixtureFit,
) -> Option<MixtureFit> {
    let left = |fit: &MixtureFit| {
        let deviation = fit.mixture.variance.sqrt();
        without_ends_by_chance(points, &fit.descent.model, deviation, &fit.weights)
    };
    let mut kept = left(&fit);
    for _ in 0..ROUNDS_WITHOUT_ENDS {
        let Some(weights) = &kept else { break };
        let descent = descend_weighted(points, weights, &fit.descent.model, &STEP)?;
        let squares = points.geometric_squares(&descent.model);
        let weights = fit.mixture.expect(&squares, odds).weights;
        let passes = fit.passes + descent.passes + 1;
        fit = MixtureFit { descent, weights, passes, ..fit };
        kept = left(&fit);
    }
    Some(MixtureFit { weights: kept.unwrap_or(fit.weights), ..fit })
}

/// The variance of the noise around a model from the nearest third of the points, which are hardly
/// strays.
pub(crate) fn variance_of_nearest(points: &PointSet, model: &Model) -> f64 {
    variance_of_least(points.geometric_squares(model))
}

/// The same from the squared distances of all.
pub(crate) fn variance_of_least(mut squares: Vec<f64>) -> f64 {
    let place = 3 * squares.len() / 10;
    let (_, square, _) = squares.select_nth_unstable_by(place, f64::total_cmp);
    *square / LOW_QUANTILE
}

fn descend_weighted(
    points: &PointSet,
    weights: &[f64],
    model: &Model,
    effort: &Effort,
) -> Option<Descent> {
    let roots: Vec<f64> = weights.iter().map(|weight| weight.sqrt()).collect();
    descend(&PointSet { root_weights: Some(&roots), ..*points }, model, effort)
}

fn is_settled(before: &Mixture, after: &Mixture) -> bool {
    (after.variance - before.variance).abs() <= 2.0 * SETTLED * before.variance
        && (after.stray_share - before.stray_share).abs() <= SETTLED
}
