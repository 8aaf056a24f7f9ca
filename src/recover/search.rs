//! The search for the right minimum: brief descents on few points from several starts, then
//! switches from the best of them, then the best few on more points.

use super::descent::{Descent, Effort, PointSet, descend_beside};
use super::evidence::{Evidence, Facing, SeenArea};
use super::kernel::Residual;
use super::normalization::Moments;
use super::options::Precision;
use super::start::{ambiguous_starts, principal_starts};
use super::subset::Subset;
use super::switches::{deflated, other_frames, switches};
use super::uncertainty::neighbour_correlation;
use crate::model::Model;

/// A switch must lower the loss by this share to be taken.
const WORTHWHILE: f64 = 0.99;

/// Rounds of switches: as many as axis and dual can both be wrong.
const SWITCH_ROUNDS: usize = 4;

/// What lets a second look be worth while: noise above this share of the RMS radius, and a model
/// of which this many times the area that is seen is there;
const NOISY: f64 = 0.015;
const HALF_SEEN: f64 = 1.3;

/// or residuals of so many neighbours that correlate so much: noise alone leaves 0.06.
const CORRELATED_POINTS: usize = 256;
const MISFIT: f64 = 0.3;

/// Residuals, as a share of the RMS radius, that are no more than rounding.
const EXACT: f64 = 1e-6;

/// Points on which a second look descends, the share of the rays and what else was seen, how far, and the
/// ratio to the best loss within which what it finds is taken further.
const LOOK_POINTS: usize = 300;
const LOOK_EVERY: usize = 3;
const GLANCE: Effort = Effort { gain: 2.0, ..BRIEF };
const NEAR: f64 = 1.05;

/// Rounds of a second look, and the gain in the logarithm of the likelihood that calls for another.
const LOOKS: usize = 2;
const LIKELIER: f64 = 1.0;

/// A model whose loss is this many times the best one's is not taken on.
const HOPELESS: f64 = 2.0;

/// A winner whose loss is this share of the next minimum's ends the search: a fifth of its RMS.
const CLEAR: f64 = 0.04;

/// Relative difference of semi-axes, and difference of exponents, within one minimum.
const SAME_SIZE: f64 = 0.02;
const SAME_EXPONENT: f64 = 0.05;

/// A brief descent: it must tell minima apart, not find them exactly.
pub(crate) const BRIEF: Effort = Effort { step_bound: 0.5, ..Effort::MEDIUM };

/// Bookkeeping of a search: every descent, best first, and what they cost.
#[derive(Debug, Default)]
pub(crate) struct Search {
    candidates: Vec<Descent>,
    /// Models that a descent started from.
    pub starts: usize,
    /// Passes over point sets of any size.
    pub passes: usize,
}

impl Search {
    /// Descends from the principal axes, by switches, and from the frames between them.
    pub fn coarse(points: &PointSet, moments: &Moments) -> Self {
        let mut search = Self::default();
        search.try_all(points, &principal_starts(moments), &BRIEF);
        search.try_switches(points);
        if !search.has_clear_winner() {
            let before = search.least_loss();
            search.try_all(points, &ambiguous_starts(moments), &BRIEF);
            if search.least_loss() < WORTHWHILE * before {
                search.try_switches(points);
            }
        }
        search
    }

    /// Takes the best few, in their final form, on to other points or another residual: only these
    /// are kept.
    pub fn refine(&mut self, points: &PointSet, effort: &Effort, finalists: usize) {
        for model in self.take_finalists(finalists) {
            self.descend(points, &points.constraints.start_form(&model), effort);
        }
    }

    /// A second look where the best minimum of the geometric distance is open to doubt: what is then
    /// known besides the points.
    pub fn look_around(
        &mut self,
        points: &PointSet,
        effort: &Effort,
        finalists: usize,
    ) -> Option<Evidence> {
        let evidence = self.look_from_one_side(points, effort, finalists);
        if evidence.is_none() {
            self.look_again(points, effort);
        }
        evidence
    }

    /// Looks around the best minimum of the geometric distance for better ones, if it is open to
    /// doubt: the coarse search has but few points and looks at one switch at a time.
    pub fn look_again(&mut self, points: &PointSet, effort: &Effort) {
        for _ in 0..LOOKS {
            let Some(best) = self.candidates.first().filter(|best| is_open(points, best)) else {
                return;
            };
            let (model, before) = (best.model, best.loss);
            if let Some(other) = self.other_minimum_around(&model, points) {
                self.descend(points, &other, effort);
            }
            let gain = 0.5 * points.weight() * (before / self.least_loss()).ln();
            if gain < LIKELIER {
                return;
            }
        }
    }

    /// The best minimum around a model but its own, as some of the points have it, if they leave it
    /// open which is better. They count as all do, and so does a part of the evidence.
    fn other_minimum_around(&mut self, model: &Model, points: &PointSet) -> Option<Model> {
        let some = Subset::stratified(points.points, LOOK_POINTS, 0);
        let count = some.columns()[0].len();
        let roots = vec![(points.weight() / count as f64).sqrt(); count];
        let some = PointSet {
            points: some.columns(),
            root_weights: Some(&roots),
            parallel: false,
            precision: Precision::Single,
            evidence: &points.evidence.thinned(LOOK_EVERY),
            ..*points
        };
        let mut search = Self::default();
        search.descend(&some, model, &GLANCE);
        let near = NEAR * search.least_loss();
        let starts: Vec<Model> = other_frames(model).into_iter().chain(deflated(model)).collect();
        search.try_all(&some, &starts, &GLANCE);
        self.passes += search.passes;
        self.starts += search.starts;
        let is_near = |other: &Descent| other.loss < near && !is_same_minimum(&other.model, model);
        search.candidates.into_iter().find(is_near).map(|other| other.model)
    }

    /// Takes the best few further as what was seen from one side, if noise and what is not seen leave
    /// the best one in doubt, and it may have been: what is then known besides the points.
    fn look_from_one_side(
        &mut self,
        points: &PointSet,
        effort: &Effort,
        finalists: usize,
    ) -> Option<Evidence> {
        let best = self.candidates.first().filter(|best| is_depth_in_doubt(points, best))?;
        let is_unknown = points.evidence.facing.is_none();
        let facing = is_unknown.then(|| Facing::one_side(&best.model, points))??;
        let evidence = Evidence { facing: Some(facing), ..points.evidence.clone() };
        self.refine(&PointSet { evidence: &evidence, ..*points }, effort, finalists);
        Some(evidence)
    }

    /// The best descent.
    pub fn into_best(self) -> Option<Descent> {
        self.candidates.into_iter().next()
    }

    /// Switches from the best descent, as long as one of them is worth while.
    fn try_switches(&mut self, points: &PointSet) {
        for _ in 0..SWITCH_ROUNDS {
            let Some(best) = self.candidates.first() else { return };
            let (model, before) = (best.model, best.loss);
            self.try_all(points, &switches(&model), &BRIEF);
            if self.least_loss() >= WORTHWHILE * before {
                return;
            }
        }
    }

    /// The best few models, each minimum once, without those far behind; no candidate is left.
    pub fn take_finalists(&mut self, count: usize) -> Vec<Model> {
        let hopeless = HOPELESS * self.least_loss();
        let mut finalists: Vec<Model> = Vec::new();
        for candidate in std::mem::take(&mut self.candidates) {
            let is_new = finalists.iter().all(|model| !is_same_minimum(model, &candidate.model));
            if is_new && finalists.len() < count && candidate.loss <= hopeless {
                finalists.push(candidate.model);
            }
        }
        finalists
    }

    /// Whether the best minimum is so far ahead of every other that none is left to be found.
    fn has_clear_winner(&self) -> bool {
        let Some(best) = self.candidates.first() else { return false };
        self.candidates
            .iter()
            .find(|other| !is_same_minimum(&other.model, &best.model))
            .is_some_and(|other| best.loss < CLEAR * other.loss)
    }

    fn least_loss(&self) -> f64 {
        self.candidates.first().map_or(f64::INFINITY, |best| best.loss)
    }

    fn try_all(&mut self, points: &PointSet, starts: &[Model], effort: &Effort) {
        for start in starts {
            self.starts += 1;
            self.descend(points, start, effort);
        }
    }

    /// Descends from a model and files the result by its loss.
    fn descend(&mut self, points: &PointSet, start: &Model, effort: &Effort) {
        let rival = self.least_loss();
        if let Some(descent) = descend_beside(points, start, effort, rival) {
            self.passes += descent.passes;
            let place = self.candidates.partition_point(|other| other.loss <= descent.loss);
            self.candidates.insert(place, descent);
        }
    }
}

/// Whether the best minimum misfits, or is in doubt.
fn is_open(points: &PointSet, best: &Descent) -> bool {
    if points.residual == Residual::Radial || best.geometric_mean_square.sqrt() < EXACT {
        return false;
    }
    is_depth_in_doubt(points, best) || is_misfit(points, &best.model)
}

/// Whether noise and what is not seen leave the best minimum in doubt.
fn is_depth_in_doubt(points: &PointSet, best: &Descent) -> bool {
    is_noisy(best.geometric_mean_square.sqrt()) && is_half_seen(points, best)
}

/// Whether noise of that deviation may hide what decides among minima.
pub(crate) fn is_noisy(deviation: f64) -> bool {
    deviation > NOISY
}

/// Whether a model has much more area than is seen.
pub(crate) fn is_half_seen(points: &PointSet, best: &Descent) -> bool {
    let ratio = |seen: SeenArea| seen.ratio(&best.model.shape, best.geometric_mean_square);
    points.evidence.seen_area.is_some_and(|seen| ratio(seen) > HALF_SEEN)
}

/// Whether the distances of neighbours from a model err together.
pub(crate) fn is_misfit(points: &PointSet, model: &Model) -> bool {
    let few = Subset::stratified(points.points, CORRELATED_POINTS, 0);
    neighbour_correlation(&PointSet { points: few.columns(), ..*points }, model) > MISFIT
}

/// Whether two models that brief descents have ended in are on the way to one minimum.
pub(crate) fn is_same_minimum(a: &Model, b: &Model) -> bool {
    let (a, b) = (a.canonical().shape, b.canonical().shape);
    let sizes = a.size().into_iter().zip(b.size());
    let exponents = a.exponents().into_iter().zip(b.exponents());
    sizes.into_iter().all(|(a, b)| (a - b).abs() <= SAME_SIZE * a)
        && exponents.into_iter().all(|(a, b)| (a - b).abs() <= SAME_EXPONENT)
}
