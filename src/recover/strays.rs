//! Recovery among strays: a search on the points that neighbours hold for the surface's, then the
//! mixture of surface and strays from the best of what it finds.

use std::slice;

use super::alternation::{
    MixtureFit, Schedule, alternate, finish, variance_of_least, variance_of_nearest,
    without_ends_of_strays,
};
use super::clutter::Clutter;
use super::concentration::{CORE_SHARE, concentrated};
use super::descent::{Descent, Effort, PointSet};
use super::kernel::Residual;
use super::mixture::{Mixture, Room};
use super::normalization::Moments;
use super::one_side::Sided;
use super::radial::PARAMETERS;
use super::search::{BRIEF, Search, is_half_seen, is_misfit, is_noisy, is_same_minimum};
use super::subset::Subset;
use super::survey::Survey;
use super::switches::deflated;
use crate::model::Model;

/// Points on which searches start, on which their minima are told apart, and on which mixtures are
/// screened.
const COARSE_POINTS: usize = 256;
const MEDIUM_POINTS: usize = 800;
const SCREENED_POINTS: usize = 500;

/// Minima taken from the coarse search to the geometric distance, from there to more points, and
/// from there to the mixture.
const COARSE_FINALISTS: usize = 6;
const MEDIUM_FINALISTS: usize = 4;
const FINALISTS: usize = 3;

/// To tell minima apart.
const MEDIUM: Effort = Effort { gain: 0.25, patience: 2, step_bound: 1.0 };

/// Share of strays held while screening: left free, it runs away from a rough start.
const SCREENING_SHARE: f64 = 0.25;

/// Rounds of a screening, on the sample, and on all points, where they start next to their end: there
/// the mixture is not to run ahead of the model, or what belongs to the object but is no superellipsoid,
/// such as the rims of a can's lids, goes with the strays.
const SCREENING: Schedule = Schedule { rounds: 8, is_share_free: false, mixture_rounds: 0 };
const ON_SAMPLE: Schedule = Schedule { rounds: 30, is_share_free: true, mixture_rounds: 3 };
const ON_ALL: Schedule = Schedule { rounds: 8, is_share_free: true, mixture_rounds: 0 };

/// Gain in mean log-likelihood from which on outliers are set apart where neighbours show none,
/// and the share of them to begin with.
const OUTLIERS_GAIN: f64 = 0.02;
const FEW: f64 = 0.1;

/// A share of that gain is reached around the fit to all points already, if it can be reached, in so
/// many rounds.
const HINT: f64 = 0.25;
const HINT_ROUNDS: usize = 5;

/// Variance around a fit, in that around the one it was settled from, below which the noise had been
/// taken for far more than it is.
const SHARPER: f64 = 0.25;

/// Deviation about the model of the half that fits best, in that about the model of all, below which
/// the others had drawn the fit off.
const DRAWN_OFF: f64 = 0.5;

/// Where a search has led, and what it cost.
#[derive(Debug)]
pub(crate) struct Recovery {
    pub fit: MixtureFit,
    /// Passes over point sets of any size, and models started from.
    pub passes: usize,
    pub starts: usize,
}

/// Recovery from clutter. None where too few points are of a surface.
pub(crate) fn fit_among_clutter(
    all: &PointSet,
    survey: &Survey,
    clutter: &Clutter,
    seed: u64,
) -> Option<Recovery> {
    let all = PointSet { residual: Residual::Geometric, ..*all };
    let sample = PointSet { points: survey.points.columns(), parallel: false, ..all };
    let odds = Some(&clutter.odds[..]);

    let core = Subset::of(sample.points, &clutter.surface());
    let mut search = CoreSearch { sample: &sample, seed, passes: 0, starts: 0 };
    let start = Mixture { variance: 1.0, stray_share: clutter.share, room: survey.room };
    let mut fits = Vec::new();
    for fit in search.screen(&core, start) {
        let mixture = Mixture { stray_share: clutter.share, ..fit.mixture };
        fits.extend(search.settle(&fit.descent.model, mixture, odds));
    }
    let best = most_likely(&fits)?;
    let (mixture, surface) = (best.mixture, Subset::of(sample.points, &best.surface()));
    for model in search.other_minima(&surface, &best.descent.model) {
        fits.extend(search.settle(&model, mixture, odds));
    }
    let Sided { fit, side } = search.look_from_one_side(&fits, &clutter.odds)?;
    let best = Sided { fit: search.concentrate(fit), side };
    let odds = best.odds(&all);
    let Sided { fit: MixtureFit { descent, mixture, .. }, .. } = best;
    let on_all = alternate(&all, odds.as_deref(), &descent.model, mixture, ON_ALL)?;
    let fit = finish(&all, without_ends_of_strays(&all, odds.as_deref(), on_all)?)?;
    Some(Recovery { passes: search.passes + fit.passes, starts: search.starts, fit })
}

fn most_likely(fits: &[MixtureFit]) -> Option<&MixtureFit> {
    fits.iter().max_by(|a, b| a.log_likelihood.total_cmp(&b.log_likelihood))
}

/// Outliers that neighbours do not show, set apart from a fit to all points; then, as they may have
/// misled it, another search without them. None where that explains the points hardly better.
pub(crate) fn set_outliers_apart(
    all: &PointSet,
    survey: &Survey,
    plain: &Descent,
    seed: u64,
) -> Option<Recovery> {
    let sample = PointSet { points: survey.points.columns(), parallel: false, ..*all };
    let squares = sample.geometric_squares(&plain.model);
    let variance = squares.iter().sum::<f64>() / squares.len() as f64;
    let without = Mixture { variance, stray_share: 0.0, room: survey.room };
    let without = without.expect(&squares, None).log_likelihood;
    if !are_hinted_at(&squares, without, survey.room) {
        return None;
    }

    let mut search = CoreSearch { sample: &sample, seed, passes: 0, starts: 0 };
    let settled = search.settle_among_few(&plain.model, survey.room)?;
    let mut best = search.concentrate(settled);
    if best.log_likelihood - without < OUTLIERS_GAIN {
        return None;
    }
    let surface = Subset::of(sample.points, &best.surface());
    for model in search.other_minima(&surface, &best.descent.model) {
        let other = search.settle_among_few(&model, survey.room);
        best = other.into_iter().fold(best, MixtureFit::more_likely);
    }
    let on_all = alternate(all, None, &best.descent.model, best.mixture, ON_ALL)?;
    let fit = finish(all, without_ends_of_strays(all, None, on_all)?)?;
    Some(Recovery { passes: search.passes + fit.passes, starts: search.starts, fit })
}

/// Whether points with these squared distances from a model gain by outliers, be it not as much as
/// they could around a model that is fitted without these.
fn are_hinted_at(squares: &[f64], log_likelihood_without: f64, room: Room) -> bool {
    let variance = variance_of_least(squares.to_vec());
    let few = Mixture { variance, stray_share: FEW, room };
    let with = few.settled_log_likelihood(squares, HINT_ROUNDS);
    with - log_likelihood_without >= HINT * OUTLIERS_GAIN
}

/// Searches on parts of a sample, and what they cost.
struct CoreSearch<'a> {
    sample: &'a PointSet<'a>,
    seed: u64,
    passes: usize,
    starts: usize,
}

impl CoreSearch<'_> {
    /// The mixture around a model, from few strays.
    fn settle_among_few(&mut self, model: &Model, room: Room) -> Option<MixtureFit> {
        let variance = variance_of_nearest(self.sample, model);
        self.settle(model, Mixture { variance, stray_share: FEW, room }, None)
    }

    /// The mixture around a model, from another one. `odds` are what neighbours say of each point.
    fn settle(
        &mut self,
        model: &Model,
        start: Mixture,
        odds: Option<&[f64]>,
    ) -> Option<MixtureFit> {
        let fit = alternate(self.sample, odds, model, start, ON_SAMPLE)?;
        self.passes += fit.passes;
        Some(fit)
    }

    /// The best of the fits; where one side is all that is seen, as a fit to what was seen from there,
    /// settled from its model and a smaller one: strays in the shade have drawn many a fit too far. If
    /// noise may hide which is the best, the best of all settled so.
    fn look_from_one_side(&mut self, fits: &[MixtureFit], odds: &[f64]) -> Option<Sided> {
        let best = most_likely(fits)?;
        if !is_half_seen(self.sample, &best.descent) {
            return Some(Sided::unknown(best.clone()));
        }
        let fits =
            if is_noisy(best.mixture.variance.sqrt()) { fits } else { slice::from_ref(best) };
        let starts = fits.iter().map(|fit| (fit, fit.descent.model));
        let smaller = deflated(&best.descent.model).map(|model| (best, model));
        let mut settled = Vec::new();
        for (fit, start) in starts.chain(smaller) {
            let sided = Sided::settled(self.sample, odds, fit, &start, ON_SAMPLE);
            self.passes += sided.as_ref().map_or(0, |sided| sided.fit.passes);
            settled.extend(sided);
        }
        let sided = settled.into_iter().reduce(Sided::more_likely)?;
        if sided.fit.mixture.variance > SHARPER * best.mixture.variance {
            return Some(sided);
        }
        let other = sided.resettled(self.sample, odds, &best.descent.model, ON_SAMPLE);
        self.passes += other.as_ref().map_or(0, |other| other.fit.passes);
        Some(other.into_iter().fold(sided, Sided::more_likely))
    }

    /// A mixture, or where its own points misfit, that around the half of all points that fits best,
    /// if these are much nearer to it and all are much likelier. Neighbours have no say: they hold
    /// any surface for this one.
    fn concentrate(&mut self, fit: MixtureFit) -> MixtureFit {
        let own = Subset::of(self.sample.points, &fit.surface());
        if !is_misfit(&PointSet { points: own.columns(), ..*self.sample }, &fit.descent.model) {
            return fit;
        }
        self.concentrated(&fit).unwrap_or(fit)
    }

    fn concentrated(&mut self, fit: &MixtureFit) -> Option<MixtureFit> {
        let (model, passes) = concentrated(self.sample, &fit.descent.model)?;
        self.passes += passes;
        let variance = variance_of_nearest(self.sample, &model);
        let start = Mixture { variance, stray_share: 1.0 - CORE_SHARE, ..fit.mixture };
        let before = self.settle(&fit.descent.model, fit.mixture, None)?;
        let fit = self.settle(&model, start, None)?;
        let is_nearer = fit.mixture.variance < DRAWN_OFF.powi(2) * before.mixture.variance;
        let is_likelier = fit.log_likelihood - before.log_likelihood > OUTLIERS_GAIN;
        (is_nearer && is_likelier).then_some(fit)
    }

    /// The best few of a core's minima by the likelihood of a mixture on few of its points.
    fn screen(&mut self, core: &Subset, start: Mixture) -> Vec<MixtureFit> {
        let models = self.minima(core);
        let few = Subset::stratified(core.columns(), SCREENED_POINTS, self.seed);
        let few = PointSet { points: few.columns(), ..*self.sample };
        let screened = |model: &Model| {
            let variance = variance_of_nearest(&few, model);
            let mixture = Mixture { variance, stray_share: SCREENING_SHARE, ..start };
            alternate(&few, None, model, mixture, SCREENING)
        };
        let mut fits: Vec<MixtureFit> = models.iter().filter_map(screened).collect();
        self.passes += fits.iter().map(|fit| fit.passes).sum::<usize>();
        fits.sort_by(|a, b| b.log_likelihood.total_cmp(&a.log_likelihood));
        let mut distinct: Vec<MixtureFit> = Vec::new();
        for fit in fits {
            let is_known =
                |known: &MixtureFit| is_same_minimum(&known.descent.model, &fit.descent.model);
            if !distinct.iter().any(is_known) {
                distinct.push(fit);
            }
        }
        distinct
    }

    /// The best few minima of a search on a core, but for one that is known.
    fn other_minima(&mut self, core: &Subset, known: &Model) -> Vec<Model> {
        let minima = self.minima(core).into_iter();
        minima.filter(|model| !is_same_minimum(model, known)).collect()
    }

    /// The best few minima of a search on a core, all of whose points count.
    fn minima(&mut self, core: &Subset) -> Vec<Model> {
        if core.columns()[0].len() <= PARAMETERS {
            return Vec::new();
        }
        let moments = Moments::of(core.columns());
        let normalization = &moments.normalization;
        let few = Subset::stratified(core.columns(), COARSE_POINTS, self.seed);
        let more = Subset::stratified(core.columns(), MEDIUM_POINTS, self.seed);
        let evidence = self
            .sample
            .evidence
            .for_search()
            .renormalized(self.sample.normalization, normalization);
        let few = PointSet {
            points: few.columns(),
            normalization,
            residual: Residual::Radial,
            evidence: &evidence,
            constraints: &self
                .sample
                .constraints
                .renormalized(self.sample.normalization, normalization),
            ..*self.sample
        };
        let mut search = Search::coarse(&few, &moments);
        let few = PointSet { residual: Residual::Geometric, ..few };
        search.refine(&few, &BRIEF, COARSE_FINALISTS);
        let more = PointSet { points: more.columns(), ..few };
        search.refine(&more, &MEDIUM, MEDIUM_FINALISTS);
        search.look_again(&more, &MEDIUM);
        let minima = search.take_finalists(FINALISTS);
        self.passes += search.passes;
        self.starts += search.starts;
        let here = |model: &Model| self.sample.normalization.model_of(normalization, model);
        minima.iter().map(here).collect()
    }
}
