//! The fit, from a cloud to a model, stage by stage.

use rayon::ThreadPoolBuilder;

use super::covariance::Covariance;
use super::descent::{Descent, Interrupt, PARALLEL_POINTS, PointSet};
use super::doubt::{doubts, require_extent};
use super::error::FitError;
use super::evidence::Evidence;
use super::found::{Found, Surface};
use super::kernel::Residual;
use super::normalization::Moments;
use super::options::{Distance, FitOptions};
use super::radial::PARAMETERS;
use super::result::Fit;
use super::survey::Survey;
use super::uncertainty::{covariance, dependence};
use crate::cloud::PointCloud;
use crate::machine::instruction_set;
use crate::model::Model;

/// Points on which the correlation of neighbours' residuals is judged.
const CORRELATION_POINTS: usize = 256;

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
    instruction_set()?;
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
        ray_noise: None,
        evidence: &Evidence::NONE,
        constraints: &options.constraints.normalized(&moments.normalization),
        parallel,
        residual: residual(options.distance),
        precision: options.precision,
        is_interrupted,
    };
    // The radial fit is left as it is in the literature: all points, and nothing else.
    let is_radial = options.distance == Distance::Radial;
    let survey = (!is_radial).then(|| Survey::of(all.points, &moments, options.seed));
    let evidence = survey.as_ref().map(|survey| survey.evidence(&moments, options));
    let all = PointSet { evidence: evidence.as_ref().unwrap_or(&Evidence::NONE), ..all };
    let found = match &survey {
        None => Found::plain(&all, &moments, options.seed),
        Some(survey) => Found::among_strays(&all, &moments, survey, options.seed)
            .and_then(|found| found.along_rays(&all, options.seed)),
    };
    let Found { best, surface, ray_noise, passes, starts } = found.ok_or(FitError::Unbounded)?;

    let model = all.constraints.final_form(&best.model);
    let all = PointSet { ray_noise: ray_noise.as_ref(), ..all };
    let covariance = uncertainty_of(&all, &best, &model, &surface, &moments, options.seed)
        .ok_or(FitError::Interrupted)?;
    let clutter = survey.as_ref().and_then(|survey| survey.clutter.as_ref());
    let other_share = surface.stray_share - clutter.map_or(0.0, |clutter| clutter.share);
    let radius = moments.normalization.radius;
    let in_cloud = moments.normalization.cloud_from_normalized(&model);
    Ok(Fit {
        model: in_cloud,
        distance: options.distance,
        termination: best.termination,
        doubts: doubts(&best, &moments, &in_cloud, &covariance, other_share),
        rms_radial: best.radial_mean_square.sqrt() * radius,
        rms_geometric: best.geometric_mean_square.sqrt() * radius,
        covariance,
        noise: surface.deviation * radius,
        range_noise: ray_noise.map(|noise| noise.deviations(surface.deviation * radius)),
        stray_share: surface.stray_share,
        is_inlier: surface.is_inlier(),
        points: cloud.len(),
        points_skipped: cloud.skipped_rows().len(),
        evaluations: passes,
        starts,
        seed: options.seed,
    })
}

/// How well the points of the surface, and what is known besides, determine the model.
fn uncertainty_of(
    all: &PointSet,
    best: &Descent,
    model: &Model,
    surface: &Surface,
    moments: &Moments,
    seed: u64,
) -> Option<Covariance> {
    let roots = surface.root_weights();
    let seen = PointSet { root_weights: roots.as_deref(), evidence: &all.evidence.seen(), ..*all };
    // The last descent has made the very pass that is wanted, unless evidence spoke against it.
    let is_known = best.model == *model && best.gram.evidence_squares == 0.0;
    let gram = if is_known { best.gram } else { seen.gram(model)? };
    let few = surface.sample(all.points, CORRELATION_POINTS, seed);
    let few = PointSet { points: few.columns(), ..seen };
    let dependence = dependence(&few, model, surface.count());
    Some(covariance(&seen, model, &gram, moments.resolution, dependence))
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

/// What is minimised in the end.
pub(super) fn residual(distance: Distance) -> Residual {
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
