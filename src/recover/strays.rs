//! Recovery among strays: searches on the crowded parts of the cloud, then the mixture of
//! surface and strays, estimated by expectation and maximisation from the best of them.

use super::descent::{Descent, Effort, PointSet, descend};
use super::kernel::Residual;
use super::mixture::{Expectation, Mixture};
use super::normalization::Moments;
use super::radial::PARAMETERS;
use super::search::Search;
use super::subset::Subset;
use crate::cloud::PointColumns;
use crate::model::Model;

use super::crowding::by_crowding;

/// Points on which crowding is judged and mixtures are compared.
const SAMPLE: usize = 3_000;

/// Points of a sample on which the mixture is screened.
const SCREENED: usize = 500;

/// Points of the crowded part that the search looks at.
const COARSE_POINTS: usize = 256;

/// Shares of the sample, the most crowded, that searches look at: one of them has few strays.
const CROWDED_SHARES: [f64; 5] = [0.7, 0.5, 0.33, 0.2, 0.12];

/// Minima that each search hands on.
const FINALISTS: usize = 3;

/// Share of strays held while screening: left free, it runs away from a rough start.
const SCREENING_SHARE: f64 = 0.5;

/// Rounds of expectation and maximisation while screening, and on the sample.
const SCREENING_ROUNDS: usize = 8;
const SAMPLE_ROUNDS: usize = 30;

/// Rounds on all points, which start next to their end.
const FINAL_ROUNDS: usize = 8;

/// Relative change of the noise's deviation, and of the share of strays, at the end.
const SETTLED: f64 = 1e-4;

/// Geometric RMS, over the mean semi-axis, below which a plain fit is looked at no further if
/// its strays are next to none.
const CLEAN_RMS: f64 = 0.03;

/// Share of strays that counts as none.
const NO_STRAYS: f64 = 0.005;

/// A maximisation between two expectations.
const STEP: Effort = Effort { tolerance: 1e-4, patience: 2, step_bound: 1.0 };

/// The last maximisation.
const FINISH: Effort = Effort { tolerance: 1e-8, patience: 16, step_bound: 1.0 };

/// A fit of the mixture.
#[derive(Debug, Clone)]
pub(crate) struct MixtureFit {
    /// The model and its rows, weighted.
    pub descent: Descent,
    /// The mixture around it.
    pub mixture: Mixture,
    /// Probability of each point to be one of the surface.
    pub weights: Vec<f64>,
    log_likelihood: f64,
    /// Passes over point sets of any size, and models started from.
    pub passes: usize,
    pub starts: usize,
}

/// The mixture that makes the points most likely, started from the plain fit and from the crowded
/// parts of the cloud; none where the plain fit leaves no stray.
pub(crate) fn fit_among_strays(
    all: &PointSet,
    plain: &Descent,
    moments: &Moments,
    seed: u64,
) -> Option<MixtureFit> {
    let all = PointSet { residual: Residual::Geometric, ..*all };
    let sample = Subset::stratified(all.points, SAMPLE, seed);
    let sample = PointSet { points: sample.columns(), parallel: false, ..all };
    let volume = box_volume(&sample, moments);

    let from_plain = settle(&sample, &plain.model, start_mixture(&sample, &plain.model, volume))?;
    let rms = plain.geometric_mean_square.sqrt() / plain.model.shape.mean_semi_axis();
    if rms < CLEAN_RMS && from_plain.mixture.stray_share < NO_STRAYS {
        return None;
    }
    let (mut best, mut passes, mut starts) = (from_plain, 0, 0);
    for candidate in screen(&sample, seed, volume, &mut passes, &mut starts) {
        let settled = settle(&sample, &candidate.0, candidate.1);
        best = settled.into_iter().fold(best, more_likely);
    }
    let sampled_passes = passes + best.passes;
    let finished = finish(&all, best)?;
    let passes = finished.passes + sampled_passes;
    let is_clean = finished.mixture.stray_share < NO_STRAYS && starts == 0;
    (!is_clean).then_some(MixtureFit { passes, starts, ..finished })
}

/// The best few starts of the crowded parts, screened on few points by the likelihood.
fn screen(
    sample: &PointSet,
    seed: u64,
    volume: f64,
    passes: &mut usize,
    starts: &mut usize,
) -> Vec<(Model, Mixture)> {
    let few = Subset::stratified(sample.points, SCREENED, seed);
    let few = PointSet { points: few.columns(), ..*sample };
    let order = by_crowding(sample.points);
    let mut screened: Vec<MixtureFit> = Vec::new();
    for share in CROWDED_SHARES {
        let kept = ((share * sample.len() as f64) as usize).max(PARAMETERS + 1).min(order.len());
        let mut kept = order[..kept].to_vec();
        kept.sort_unstable();
        let core = Subset::of(sample.points, &kept);
        let (models, search) = search_core(&core, sample, seed);
        *passes += search.0;
        *starts += search.1;
        for model in models {
            let start = start_mixture(&few, &model, volume);
            if let Some(fit) = screen_one(&few, &model, start) {
                *passes += fit.passes;
                screened.push(fit);
            }
        }
    }
    screened.sort_by(|a, b| b.log_likelihood.total_cmp(&a.log_likelihood));
    screened.truncate(FINALISTS);
    screened.into_iter().map(|fit| (fit.descent.model, fit.mixture)).collect()
}

/// The minima of a plain search on one part of the sample, with its passes and starts.
fn search_core(core: &Subset, sample: &PointSet, seed: u64) -> (Vec<Model>, (usize, usize)) {
    let moments = Moments::of(core.columns());
    let few = Subset::stratified(core.columns(), COARSE_POINTS, seed);
    let few = PointSet {
        points: few.columns(),
        normalization: &moments.normalization,
        residual: Residual::Radial,
        ..*sample
    };
    let mut search = Search::coarse(&few, &moments);
    let cost = (search.passes, search.starts);
    let models = search.take_finalists(FINALISTS);
    let here = |model: &Model| sample.normalization.renormalized(&moments.normalization, model);
    (models.iter().map(here).collect(), cost)
}

/// A mixture to start with around a model: the noise from the nearest third of the points.
fn start_mixture(points: &PointSet, model: &Model, volume: f64) -> Mixture {
    /// The 30 % quantile of the squared normal deviate.
    const QUANTILE: f64 = 0.148;
    let mut squares = points.geometric_squares(model);
    let place = (3 * squares.len()) / 10;
    let (_, square, _) = squares.select_nth_unstable_by(place, f64::total_cmp);
    Mixture { variance: *square / QUANTILE, stray_share: SCREENING_SHARE, volume }
}

fn screen_one(points: &PointSet, model: &Model, start: Mixture) -> Option<MixtureFit> {
    let held = |next: Mixture| Mixture { stray_share: SCREENING_SHARE, ..next };
    alternate(points, model, start, SCREENING_ROUNDS, held)
}

fn settle(points: &PointSet, model: &Model, start: Mixture) -> Option<MixtureFit> {
    alternate(points, model, start, SAMPLE_ROUNDS, |next| next)
}

/// Expectation and maximisation in turn, until the mixture is settled.
fn alternate(
    points: &PointSet,
    start: &Model,
    mut mixture: Mixture,
    rounds: usize,
    constrained: impl Fn(Mixture) -> Mixture,
) -> Option<MixtureFit> {
    let (mut model, mut passes) = (*start, 0);
    let mut last = None;
    for _ in 0..rounds {
        let Expectation { weights, next, .. } =
            mixture.expect(&model, &points.geometric_squares(&model));
        let next = constrained(next);
        let descent = descend_weighted(points, &weights, &model, &STEP)?;
        passes += descent.passes + 1;
        model = descent.model;
        last = Some(descent);
        let settled = is_settled(&mixture, &next);
        mixture = next;
        if settled {
            break;
        }
    }
    let Expectation { weights, log_likelihood, next } =
        mixture.expect(&model, &points.geometric_squares(&model));
    let mixture = constrained(next);
    Some(MixtureFit { descent: last?, mixture, weights, log_likelihood, passes, starts: 0 })
}

/// The mixture of all points, next to that of the sample, and the model to the end under it.
fn finish(all: &PointSet, best: MixtureFit) -> Option<MixtureFit> {
    let fit = if all.len() > best.weights.len() {
        alternate(all, &best.descent.model, best.mixture, FINAL_ROUNDS, |next| next)?
    } else {
        best
    };
    let descent = descend_weighted(all, &fit.weights, &fit.descent.model, &FINISH)?;
    let passes = fit.passes + descent.passes;
    Some(MixtureFit { descent, passes, ..fit })
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

fn more_likely(best: MixtureFit, next: MixtureFit) -> MixtureFit {
    if next.log_likelihood > best.log_likelihood { next } else { best }
}

/// The volume of the points' box along the cloud's principal axes, in normalised units.
fn box_volume(points: &PointSet, moments: &Moments) -> f64 {
    /// Least side: a flat cloud's strays, too, have room.
    const LEAST_SIDE: f64 = 1e-3;
    let PointColumnsRange { low, high } = range_along(points.points, moments);
    (0..3).map(|k| (high[k] - low[k]).max(LEAST_SIDE)).product()
}

struct PointColumnsRange {
    low: [f64; 3],
    high: [f64; 3],
}

/// Least and greatest coordinate along each principal axis, in normalised units.
fn range_along([xs, ys, zs]: PointColumns, moments: &Moments) -> PointColumnsRange {
    let normalization = &moments.normalization;
    let mut range = PointColumnsRange { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
    for ((x, y), z) in xs.iter().zip(ys).zip(zs) {
        let offset =
            nalgebra::Vector3::new(*x, *y, *z) - nalgebra::Vector3::from(normalization.centroid);
        let along = moments.axes.inverse_transform_vector(&(offset * normalization.inverse_radius));
        for k in 0..3 {
            range.low[k] = range.low[k].min(along[k]);
            range.high[k] = range.high[k].max(along[k]);
        }
    }
    range
}
