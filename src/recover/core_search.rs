//! Searches for the surface among strays, on cores of a sample: points that are hardly strays. What
//! is found is settled as a mixture on the whole sample.

use std::slice;

use super::alternation::{MixtureFit, Schedule, alternate, variance_of_nearest};
use super::concentration::{CORE_SHARE, concentrated, least};
use super::descent::{Effort, PointSet};
use super::kernel::Residual;
use super::mixture::{Mixture, Room};
use super::normalization::Moments;
use super::one_side::Sided;
use super::radial::PARAMETERS;
use super::search::{BRIEF, Search, is_half_seen, is_misfit, is_noisy, is_same_minimum};
use super::subset::Subset;
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

/// Share of strays held while screening: left free, it runs away from a rough start.
const SCREENING_SHARE: f64 = 0.25;

/// Rounds of a screening, and on the sample.
const SCREENING: Schedule = Schedule { rounds: 8, is_share_free: false, mixture_rounds: 0 };
const ON_SAMPLE: Schedule = Schedule { rounds: 30, is_share_free: true, mixture_rounds: 3 };

/// Cores that are looked at in turn: shares of a surface.
const CORES: [f64; 4] = [1.0, 0.7, 0.5, 1.0];

/// Gain in mean log-likelihood from which on outliers are set apart where neighbours show none, and
/// the share of them to begin with.
pub(crate) const OUTLIERS_GAIN: f64 = 0.02;
pub(crate) const FEW: f64 = 0.1;

/// Variance around a fit, in that around the one it was settled from, below which the noise had been
/// taken for far more than it is.
const SHARPER: f64 = 0.25;

/// Deviation about the model of the half that fits best, in that about the model of all, below which
/// the others had drawn the fit off.
const DRAWN_OFF: f64 = 0.5;

/// Searches on parts of a sample, and what they cost.
pub(crate) struct CoreSearch<'a> {
    sample: &'a PointSet<'a>,
    seed: u64,
    /// Passes over point sets of any size, and models started from.
    pub passes: usize,
    pub starts: usize,
}

impl<'a> CoreSearch<'a> {
    /// None done yet.
    pub fn on(sample: &'a PointSet<'a>, seed: u64) -> Self {
        Self { sample, seed, passes: 0, starts: 0 }
    }

    /// The mixture around a model, from few strays.
    pub fn settle_among_few(&mut self, model: &Model, room: Room) -> Option<MixtureFit> {
        let variance = variance_of_nearest(self.sample, model);
        self.settle(model, Mixture { variance, stray_share: FEW, room }, None)
    }

    /// The mixture around a model, from another one. `odds` are what neighbours say of each point.
    pub fn settle(
        &mut self,
        model: &Model,
        start: Mixture,
        odds: Option<&[f64]>,
    ) -> Option<MixtureFit> {
        let fit = alternate(self.sample, odds, model, start, ON_SAMPLE)?;
        self.passes += fit.passes;
        Some(fit)
    }

    /// Searches on what the best of the fits has for its surface, and as long as these points misfit
    /// it, on those of them that are the nearest: they may still have strays among them. Adds what is
    /// settled from there.
    pub fn look_again(
        &mut self,
        fits: &mut Vec<MixtureFit>,
        settle: impl Fn(&mut Self, &Model, &MixtureFit) -> Option<MixtureFit>,
    ) {
        for (round, share) in CORES.into_iter().enumerate() {
            let Some(best) = most_likely(fits).cloned() else { return };
            if round > 0 && !self.is_misfit(&best) {
                return;
            }
            let core = self.nearest_of_surface(&best, share);
            for model in self.other_minima(&core, &best.descent.model) {
                fits.extend(settle(self, &model, &best));
            }
        }
    }

    /// This share of the points of a fit's surface, the nearest to it.
    fn nearest_of_surface(&self, fit: &MixtureFit, share: f64) -> Subset {
        let surface = fit.surface();
        let count = (share * surface.len() as f64) as usize;
        let squares = self.sample.geometric_squares(&fit.descent.model);
        let of_surface: Vec<f64> = surface.iter().map(|&i| squares[i]).collect();
        let kept: Vec<usize> = least(&of_surface, count).into_iter().map(|i| surface[i]).collect();
        Subset::of(self.sample.points, &kept)
    }

    /// Whether a fit's own points misfit it.
    fn is_misfit(&self, fit: &MixtureFit) -> bool {
        let own = Subset::of(self.sample.points, &fit.surface());
        is_misfit(&PointSet { points: own.columns(), ..*self.sample }, &fit.descent.model)
    }

    /// The best of the fits; where one side is all that is seen, as a fit to what was seen from there,
    /// settled from its model and a smaller one: strays in the shade have drawn many a fit too far. If
    /// noise may hide which is the best, the best of all settled so.
    pub fn look_from_one_side(&mut self, fits: &[MixtureFit], odds: &[f64]) -> Option<Sided> {
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
    pub fn concentrate(&mut self, fit: MixtureFit) -> MixtureFit {
        if !self.is_misfit(&fit) {
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
    pub fn screen(&mut self, core: &Subset, start: Mixture) -> Vec<MixtureFit> {
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
        search.refine(&more, &Effort::MEDIUM, MEDIUM_FINALISTS);
        search.look_again(&more, &Effort::MEDIUM);
        let minima = search.take_finalists(FINALISTS);
        self.passes += search.passes;
        self.starts += search.starts;
        let here = |model: &Model| self.sample.normalization.model_of(normalization, model);
        minima.iter().map(here).collect()
    }
}

/// The fit that makes the points most likely.
pub(crate) fn most_likely(fits: &[MixtureFit]) -> Option<&MixtureFit> {
    fits.iter().max_by(|a, b| a.log_likelihood.total_cmp(&b.log_likelihood))
}
