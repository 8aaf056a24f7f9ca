//! From a survey to the best model and the points that are of its surface.

use super::alternation::MixtureFit;
use super::descent::{Descent, Effort, PARALLEL_POINTS, PointSet, descend};
use super::evidence::Evidence;
use super::kernel::Residual;
use super::normalization::Moments;
use super::options::Precision;
use super::ray_noise::RayNoise;
use super::search::{BRIEF, Search};
use super::strays::{Recovery, fit_among_clutter, set_outliers_apart};
use super::subset::Subset;
use super::survey::Survey;
use crate::cloud::PointColumns;

/// Points that the coarse descents look at.
const COARSE_POINTS: usize = 256;

/// Points of the stage after the coarse search, on which the best few minima are told apart. The next,
/// which brings the best near the minimum of all, has as many times more points as all have than it.
const FIRST_STAGE: usize = 2_500;

/// How many times a stage's points a cloud must have for the stage to save work.
const WORTH_A_STAGE: usize = 3;

/// Minima that are taken from one distance to the other: that which is best under the second may
/// be far from it under the first.
const SWITCHED_FINALISTS: usize = 4;

/// Minima that are taken on to more points.
const FINALISTS: usize = 3;

/// To tell the finalists apart, and to leave little to do on more points.
const MEDIUM: Effort = Effort { patience: 5, ..Effort::MEDIUM };

/// To the end, from a minimum that is known to little less.
const FINISH_NEAR: Effort = Effort { starts_near: true, ..Effort::FINISH };

/// From there to where noise along a sensor's rays leads.
const ALONG_RAYS: Effort = Effort { gain: 0.02, ..Effort::FINISH };

/// Points of the surface that tell what the noise is.
const NOISE_POINTS: usize = 1_000;

/// Where the descents have led.
pub(crate) struct Found {
    pub best: Descent,
    pub surface: Surface,
    /// Noise that is not alike in all directions.
    pub ray_noise: Option<RayNoise>,
    /// Passes over point sets of any size, and models started from.
    pub passes: usize,
    pub starts: usize,
}

impl Found {
    /// The model that fits all points.
    pub fn plain(all: &PointSet, moments: &Moments, seed: u64) -> Option<Self> {
        let search = search(all, moments, seed);
        let (passes, starts) = (search.passes, search.starts);
        let best = search.into_best()?;
        let surface = Surface::of_all(all, &best);
        Some(Self { best, surface, ray_noise: None, passes, starts })
    }

    /// The model that fits the points of the surface, which others may lie among.
    pub fn among_strays(
        all: &PointSet,
        moments: &Moments,
        survey: &Survey,
        seed: u64,
    ) -> Option<Self> {
        if let Some(clutter) = &survey.clutter
            && let Some(recovery) = fit_among_clutter(all, survey, clutter, seed)
        {
            return Some(recovery.into());
        }
        let plain = Self::plain(all, moments, seed)?;
        let Some(recovery) = set_outliers_apart(all, survey, &plain.best, seed) else {
            return Some(plain);
        };
        let found = Self::from(recovery);
        let (passes, starts) = (found.passes + plain.passes, found.starts + plain.starts);
        Some(Self { passes, starts, ..found })
    }

    /// The model that fits points of noise along a sensor's rays, where the points tell that theirs is
    /// such. What is only usual of a shape then says nothing more: it is there for what noise hides.
    pub fn along_rays(self, all: &PointSet, seed: u64) -> Option<Self> {
        let some = |count: usize| self.surface.sample(all.points, count, seed);
        let few = some(NOISE_POINTS);
        let few = PointSet { points: few.columns(), ..*all };
        let Some(ray_noise) = RayNoise::of(&few, &self.best.model) else { return Some(self) };
        let evidence = all.evidence.seen();
        let all = PointSet { evidence: &evidence, ray_noise: Some(&ray_noise), ..*all };
        let (mut model, mut passes) = (self.best.model, self.passes);
        for count in stages(all.len()).into_iter().filter(|count| *count < all.len()) {
            let some = some(count);
            let some = PointSet { points: some.columns(), ..all };
            let descent = descend(&some, &model, &MEDIUM)?;
            (model, passes) = (descent.model, passes + descent.passes);
        }
        let roots = self.surface.root_weights();
        let all = PointSet { root_weights: roots.as_deref(), ..all };
        let descent = descend(&all, &model, &ALONG_RAYS)?;
        let distances = PointSet { ray_noise: None, evidence: &Evidence::NONE, ..all };
        let rows = distances.gram(&descent.model)?;
        let best = descent.with_distances_of(&rows, distances.weight());
        let passes = passes + best.passes + 1;
        let deviation = best.geometric_mean_square.sqrt();
        let surface = Surface { deviation, ..self.surface };
        Some(Self { best, surface, ray_noise: Some(ray_noise), passes, ..self })
    }
}

impl From<Recovery> for Found {
    fn from(Recovery { fit, passes, starts }: Recovery) -> Self {
        let surface = Surface::of_mixture(&fit);
        Self { surface, best: fit.descent, ray_noise: None, passes, starts }
    }
}

/// Which points are of the surface, and how they scatter about it, in normalised units.
pub(crate) struct Surface {
    /// The number of points in all.
    points: usize,
    /// Probability of each point to be of the surface; none where all are.
    weights: Option<Vec<f64>>,
    pub deviation: f64,
    pub stray_share: f64,
}

impl Surface {
    /// All points are.
    fn of_all(all: &PointSet, best: &Descent) -> Self {
        Self {
            points: all.len(),
            weights: None,
            deviation: best.geometric_mean_square.sqrt(),
            stray_share: 0.0,
        }
    }

    /// As a mixture has it.
    fn of_mixture(fit: &MixtureFit) -> Self {
        Self {
            points: fit.weights.len(),
            weights: Some(fit.weights.clone()),
            deviation: fit.mixture.variance.sqrt(),
            stray_share: fit.mixture.stray_share,
        }
    }

    /// Whether each point is of the surface more likely than not.
    pub fn is_inlier(&self) -> Vec<bool> {
        let Some(weights) = &self.weights else { return vec![true; self.points] };
        weights.iter().map(|weight| *weight > 0.5).collect()
    }

    /// The number of points that are.
    pub fn count(&self) -> usize {
        let Some(weights) = &self.weights else { return self.points };
        weights.iter().filter(|weight| **weight > 0.5).count()
    }

    /// At most so many of them.
    pub fn sample(&self, points: PointColumns, count: usize, seed: u64) -> Subset {
        let Some(weights) = &self.weights else { return Subset::stratified(points, count, seed) };
        let kept: Vec<usize> = (0..weights.len()).filter(|&i| weights[i] > 0.5).collect();
        Subset::stratified_of(points, &kept, count, seed)
    }

    /// Roots of the points' weights, where they do not all weigh one.
    pub fn root_weights(&self) -> Option<Vec<f64>> {
        let weights = self.weights.as_ref()?;
        Some(weights.iter().map(|weight| weight.sqrt()).collect())
    }
}

/// The search: on a few hundred points for the minima, from coarse to fine for the best of them.
fn search(all: &PointSet, moments: &Moments, seed: u64) -> Search {
    let few = Subset::stratified(all.points, COARSE_POINTS, seed);
    let single = PointSet { precision: Precision::Single, ..*all };
    let few = PointSet { points: few.columns(), parallel: false, ..single };
    let few = PointSet { evidence: &all.evidence.for_search(), ..few };
    let mut search = Search::coarse(&PointSet { residual: Residual::Radial, ..few }, moments);
    if all.residual != Residual::Radial {
        search.refine(&few, &BRIEF, SWITCHED_FINALISTS);
    }
    let mut evidence = None;
    for (stage, count) in stages(all.len()).into_iter().enumerate() {
        let some = Subset::stratified(all.points, count, seed);
        let some = PointSet {
            points: some.columns(),
            evidence: evidence.as_ref().unwrap_or(all.evidence),
            parallel: all.parallel && count >= PARALLEL_POINTS,
            ..single
        };
        if stage > 0 {
            search.refine(&some, &MEDIUM, 1);
            continue;
        }
        search.refine(&some, &MEDIUM, FINALISTS);
        evidence = search.look_around(&some, &MEDIUM, FINALISTS);
    }
    let all = PointSet { evidence: evidence.as_ref().unwrap_or(all.evidence), ..*all };
    search.refine(&all, &FINISH_NEAR, 1);
    search
}

/// The points of each stage before the last, which has all: all, too, where these are few.
fn stages(all: usize) -> Vec<usize> {
    let fewer = [FIRST_STAGE, (FIRST_STAGE * all).isqrt()];
    let worth: Vec<usize> =
        fewer.into_iter().filter(|count| all >= WORTH_A_STAGE * count).collect();
    if worth.is_empty() { vec![all] } else { worth }
}
