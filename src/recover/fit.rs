//! The fit, from a cloud to a model, stage by stage.

use rayon::ThreadPoolBuilder;

use super::alternation::MixtureFit;
use super::descent::{Descent, Effort, Interrupt, PointSet};
use super::doubt::{doubts, require_extent};
use super::error::FitError;
use super::evidence::Evidence;
use super::kernel::Residual;
use super::normalization::Moments;
use super::options::{Distance, FitOptions};
use super::radial::PARAMETERS;
use super::result::Fit;
use super::search::{BRIEF, Search};
use super::strays::{Recovery, fit_among_clutter, set_outliers_apart};
use super::subset::Subset;
use super::survey::Survey;
use crate::cloud::PointCloud;

/// Points that the coarse descents look at.
const COARSE_POINTS: usize = 256;

/// Points of the stages between the coarse search and all points: on the first the best few
/// minima are told apart, the next brings the best near the minimum of all.
const STAGES: [usize; 2] = [2_500, 50_000];

/// How many times a stage's points a cloud must have for the stage to save work.
const WORTH_A_STAGE: usize = 3;

/// Points from which on a pass is worth sharing among threads.
const PARALLEL_POINTS: usize = 16_384;

/// Minima that are taken from one distance to the other: that which is best under the second may
/// be far from it under the first.
const SWITCHED_FINALISTS: usize = 4;

/// Minima that are taken on to more points.
const FINALISTS: usize = 3;

/// To tell the finalists apart, and to leave little to do on more points.
const MEDIUM: Effort = Effort { tolerance: 1e-6, patience: 5, step_bound: 1.0 };

/// To the end.
const FINISH: Effort = Effort { tolerance: 1e-8, patience: 16, step_bound: 1.0 };

/// Recovers a superellipsoid in general position from the points of its surface: the model that
/// minimises the sum of the squares of `options.distance`, by default the first-order geometric
/// one, from the best minima of the radial one (JLS Eq. 2.43).
///
/// # Errors
/// If the points are fewer than the parameters, coincide, lie on one line, or spread over the
/// end of the range of numbers. A fit that was found but deserves no trust is no error:
/// see [`Fit::doubts`].
pub fn fit(cloud: &PointCloud, options: &FitOptions) -> Result<Fit, FitError> {
    fit_unless(cloud, options, &|| false)
}

/// As [`fit`], given up once `is_interrupted` is true: it is asked before every pass over the
/// points, from any thread, and must not become false again.
///
/// # Errors
/// Those of [`fit`], and [`FitError::Interrupted`].
pub fn fit_unless(
    cloud: &PointCloud,
    options: &FitOptions,
    is_interrupted: &(dyn Fn() -> bool + Sync),
) -> Result<Fit, FitError> {
    let run = |parallel| fit_in_pool(cloud, options, parallel, is_interrupted);
    let is_large = cloud.len() >= PARALLEL_POINTS;
    let result = match options.threads.map(usize::from) {
        None => run(is_large),
        Some(1) => run(false),
        Some(threads) => ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| FitError::Threads { threads, reason: error.to_string() })?
            .install(|| run(is_large)),
    };
    // Passes may have been left out: whatever was found then does not count.
    if is_interrupted() { Err(FitError::Interrupted) } else { result }
}

fn fit_in_pool(
    cloud: &PointCloud,
    options: &FitOptions,
    parallel: bool,
    is_interrupted: Interrupt,
) -> Result<Fit, FitError> {
    if let Some(reason) = options.constraints.contradiction() {
        return Err(FitError::Contradiction(reason));
    }
    let moments = normalize(cloud)?;
    let all = PointSet {
        points: cloud.columns(),
        normalization: &moments.normalization,
        root_weights: None,
        evidence: &Evidence::NONE,
        constraints: &options.constraints.normalized(&moments.normalization),
        parallel,
        residual: residual(options.distance),
        is_interrupted,
    };
    let found = match options.distance {
        Distance::Radial => Found::plain(&all, &moments, options.seed),
        Distance::Geometric => {
            let survey = Survey::of(all.points, &moments, options.seed);
            let all = PointSet { evidence: &survey.evidence(&moments, options), ..all };
            Found::among_strays(&all, &moments, &survey, options.seed)
        }
    };
    let Found { best, surface, passes, starts } = found.ok_or(FitError::Unbounded)?;

    let in_cloud = moments.normalization.cloud_from_normalized(&best.model);
    let kept = Subset::of(all.points, &surface.indices());
    let kept = PointSet { points: kept.columns(), ..all };
    let few = Subset::stratified(kept.points, COARSE_POINTS, options.seed);
    let few = PointSet { points: few.columns(), parallel: false, ..all };
    Ok(Fit {
        model: if options.constraints.name_axes() { in_cloud } else { in_cloud.canonical() },
        distance: options.distance,
        termination: best.termination,
        doubts: doubts(&best, &moments, &few, kept.len()),
        rms_radial: best.radial_mean_square.sqrt() * moments.normalization.radius,
        rms_geometric: best.geometric_mean_square.sqrt() * moments.normalization.radius,
        noise: surface.deviation * moments.normalization.radius,
        stray_share: surface.stray_share,
        is_inlier: surface.is_inlier,
        points: cloud.len(),
        points_skipped: cloud.skipped_rows().len(),
        evaluations: passes,
        starts,
        seed: options.seed,
    })
}

/// Where the descents have led.
struct Found {
    best: Descent,
    surface: Surface,
    passes: usize,
    starts: usize,
}

impl Found {
    /// The model that fits all points.
    fn plain(all: &PointSet, moments: &Moments, seed: u64) -> Option<Self> {
        let search = search(all, moments, seed);
        let (passes, starts) = (search.passes, search.starts);
        let best = search.into_best()?;
        let surface = Surface::of_all(all, &best);
        Some(Self { best, surface, passes, starts })
    }

    /// The model that fits the points of the surface, which others may lie among.
    fn among_strays(all: &PointSet, moments: &Moments, survey: &Survey, seed: u64) -> Option<Self> {
        if let Some(clutter) = &survey.clutter
            && let Some(recovery) = fit_among_clutter(all, survey, clutter, seed)
        {
            return Some(recovery.into());
        }
        let plain = Self::plain(all, moments, seed)?;
        let Some(recovery) = set_outliers_apart(all, survey, &plain.best) else {
            return Some(plain);
        };
        let Self { best, surface, passes, .. } = recovery.into();
        Some(Self { best, surface, passes: passes + plain.passes, starts: plain.starts })
    }
}

impl From<Recovery> for Found {
    fn from(Recovery { fit, passes, starts }: Recovery) -> Self {
        Self { surface: Surface::of_mixture(&fit), best: fit.descent, passes, starts }
    }
}

/// Which points are of the surface, and how they scatter about it, in normalised units.
struct Surface {
    is_inlier: Vec<bool>,
    deviation: f64,
    stray_share: f64,
}

impl Surface {
    /// All points are.
    fn of_all(all: &PointSet, best: &Descent) -> Self {
        Self {
            is_inlier: vec![true; all.len()],
            deviation: best.geometric_mean_square.sqrt(),
            stray_share: 0.0,
        }
    }

    /// Those that are so more likely than not.
    fn of_mixture(fit: &MixtureFit) -> Self {
        Self {
            is_inlier: fit.weights.iter().map(|weight| *weight > 0.5).collect(),
            deviation: fit.mixture.variance.sqrt(),
            stray_share: fit.mixture.stray_share,
        }
    }

    fn indices(&self) -> Vec<usize> {
        (0..self.is_inlier.len()).filter(|&i| self.is_inlier[i]).collect()
    }
}

/// Centroid and spread of a cloud that can be fitted at all.
fn normalize(cloud: &PointCloud) -> Result<Moments, FitError> {
    if cloud.len() < PARAMETERS {
        return Err(FitError::TooFewPoints { found: cloud.len(), needed: PARAMETERS });
    }
    let moments = Moments::of(cloud.columns());
    require_extent(&moments)?;
    Ok(moments)
}

/// The search: on a few hundred points for the minima, from coarse to fine for the best of them.
fn search(all: &PointSet, moments: &Moments, seed: u64) -> Search {
    let few = Subset::stratified(all.points, COARSE_POINTS, seed);
    let few = PointSet { points: few.columns(), parallel: false, ..*all };
    let few = PointSet { evidence: &all.evidence.for_search(), ..few };
    let mut search = Search::coarse(&PointSet { residual: Residual::Radial, ..few }, moments);
    if all.residual != Residual::Radial {
        search.refine(&few, &BRIEF, SWITCHED_FINALISTS);
    }
    let mut finalists = FINALISTS;
    for count in STAGES {
        if all.len() >= WORTH_A_STAGE * count {
            let some = Subset::stratified(all.points, count, seed);
            let some = PointSet { points: some.columns(), parallel: false, ..*all };
            search.refine(&some, &MEDIUM, finalists);
            finalists = 1;
        }
    }
    search.refine(all, &FINISH, finalists);
    search
}

/// What is minimised in the end.
fn residual(distance: Distance) -> Residual {
    match distance {
        Distance::Radial => Residual::Radial,
        Distance::Geometric => Residual::Geometric,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use crate::shape::Superellipsoid;
    use crate::surface::sample_surface;

    fn cloud(points: usize) -> PointCloud {
        let shape = Superellipsoid::new([1.0, 2.0, 3.0], [0.5, 1.2]).unwrap();
        sample_surface(&shape, points, 0).into_iter().map(Into::into).collect()
    }

    #[test]
    fn a_fit_that_is_interrupted_at_any_pass_has_no_result() {
        let cloud = cloud(20_000);
        let passes = fit(&cloud, &FitOptions::default()).unwrap().evaluations;
        for allowed in [0, 1, passes / 2, passes - 1] {
            let asked = AtomicUsize::new(0);
            let is_interrupted = || asked.fetch_add(1, Ordering::Relaxed) >= allowed;
            let result = fit_unless(&cloud, &FitOptions::default(), &is_interrupted);
            assert_eq!(result, Err(FitError::Interrupted));
        }
    }

    #[test]
    fn a_fit_that_is_never_interrupted_is_the_plain_one() {
        let cloud = cloud(1_000);
        let plain = fit(&cloud, &FitOptions::default());
        assert_eq!(fit_unless(&cloud, &FitOptions::default(), &|| false), plain);
    }
}
