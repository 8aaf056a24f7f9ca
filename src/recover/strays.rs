//! Recovery among strays: a search on the points that neighbours hold for the surface's, then the
//! mixture of surface and strays from the best of what it finds.

use super::alternation::{
    MixtureFit, Schedule, alternate, finish, variance_of_least, without_ends_of_strays,
};
use super::clutter::Clutter;
use super::core_search::{CoreSearch, FEW, OUTLIERS_GAIN, most_likely};
use super::descent::{Descent, PointSet};
use super::kernel::Residual;
use super::mixture::{Mixture, Room};
use super::one_side::Sided;
use super::options::Precision;
use super::subset::Subset;
use super::survey::Survey;

/// Rounds on all points, where they start next to their end: there the mixture is not to run ahead of
/// the model, or what belongs to the object but is no superellipsoid, such as the rims of a can's lids,
/// goes with the strays.
const ON_ALL: Schedule = Schedule { rounds: 8, is_share_free: true, mixture_rounds: 0 };

/// A share of the gain from outliers is reached around the fit to all points already, if it can be
/// reached, in so many rounds.
const HINT: f64 = 0.25;
const HINT_ROUNDS: usize = 5;

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
    let sample = sample(&all, survey);
    let odds = Some(&clutter.odds[..]);

    let core = Subset::of(sample.points, &clutter.surface());
    let mut search = CoreSearch::on(&sample, seed);
    let start = Mixture { variance: 1.0, stray_share: clutter.share, room: survey.room };
    let mut fits = Vec::new();
    for fit in search.screen(&core, start) {
        let mixture = Mixture { stray_share: clutter.share, ..fit.mixture };
        fits.extend(search.settle(&fit.descent.model, mixture, odds));
    }
    search.look_again(&mut fits, |search, model, best| search.settle(model, best.mixture, odds));
    let Sided { fit, side } = search.look_from_one_side(&fits, &clutter.odds)?;
    let best = Sided { fit: search.concentrate(fit), side };
    let odds = best.odds(&all);
    let Sided { fit: MixtureFit { descent, mixture, .. }, .. } = best;
    let on_all = alternate(&all, odds.as_deref(), &descent.model, mixture, ON_ALL)?;
    let fit = finish(&all, without_ends_of_strays(&all, odds.as_deref(), on_all)?)?;
    Some(Recovery { passes: search.passes + fit.passes, starts: search.starts, fit })
}

/// Outliers that neighbours do not show, set apart from a fit to all points; then, as they may have
/// misled it, another search without them. None where that explains the points hardly better.
pub(crate) fn set_outliers_apart(
    all: &PointSet,
    survey: &Survey,
    plain: &Descent,
    seed: u64,
) -> Option<Recovery> {
    let sample = sample(all, survey);
    let squares = sample.geometric_squares(&plain.model);
    let variance = squares.iter().sum::<f64>() / squares.len() as f64;
    let without = Mixture { variance, stray_share: 0.0, room: survey.room };
    let without = without.expect(&squares, None).log_likelihood;
    if !are_hinted_at(&squares, without, survey.room) {
        return None;
    }

    let mut search = CoreSearch::on(&sample, seed);
    let settled = search.settle_among_few(&plain.model, survey.room)?;
    let mut fits = vec![search.concentrate(settled)];
    if fits[0].log_likelihood - without < OUTLIERS_GAIN {
        return None;
    }
    search.look_again(&mut fits, |search, model, _| search.settle_among_few(model, survey.room));
    let best = most_likely(&fits)?;
    let on_all = alternate(all, None, &best.descent.model, best.mixture, ON_ALL)?;
    let fit = finish(all, without_ends_of_strays(all, None, on_all)?)?;
    Some(Recovery { passes: search.passes + fit.passes, starts: search.starts, fit })
}

/// The sample, on which all is done but the end.
fn sample<'a>(all: &PointSet<'a>, survey: &'a Survey) -> PointSet<'a> {
    let points = survey.points.columns();
    PointSet { points, parallel: false, precision: Precision::Single, ..*all }
}

/// Whether points with these squared distances from a model gain by outliers, be it not as much as
/// they could around a model that is fitted without these.
fn are_hinted_at(squares: &[f64], log_likelihood_without: f64, room: Room) -> bool {
    let variance = variance_of_least(squares.to_vec());
    let few = Mixture { variance, stray_share: FEW, room };
    let with = few.settled_log_likelihood(squares, HINT_ROUNDS);
    with - log_likelihood_without >= HINT * OUTLIERS_GAIN
}
