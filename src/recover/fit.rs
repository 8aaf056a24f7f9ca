//! The fit, from a cloud to a model, stage by stage.

use rayon::ThreadPoolBuilder;

use super::descent::{Effort, PointSet, descend};
use super::doubt::{doubts, require_extent};
use super::error::FitError;
use super::kernel::Residual;
use super::normalization::Moments;
use super::options::{Distance, FitOptions};
use super::radial::PARAMETERS;
use super::result::Fit;
use super::search::{BRIEF, Search};
use super::subset::Subset;
use crate::cloud::PointCloud;

/// Points that the coarse descents look at.
const COARSE_POINTS: usize = 256;

/// Points on which the best few are told apart.
const MEDIUM_POINTS: usize = 10_000;

/// Points from which on a pass is worth sharing among threads.
const PARALLEL_POINTS: usize = 16_384;

/// Minima that are taken from one distance to the other: that which is best under the second may
/// be far from it under the first.
const SWITCHED_FINALISTS: usize = 6;

/// Minima that are taken on to more points.
const FINALISTS: usize = 3;

/// To tell the finalists apart, and to leave little to do on all points.
const MEDIUM: Effort = Effort { tolerance: 1e-6, patience: 5, step_bound: 1.0 };

/// To the end.
const FINISH: Effort = Effort { tolerance: 1e-8, patience: 16, step_bound: 1.0 };

/// Recovers a superellipsoid in general position from the points of its surface: the model that
/// minimises the sum of squared radial Euclidean distances (JLS Eq. 2.43).
///
/// # Errors
/// If the points are fewer than the parameters, coincide, lie on one line, or have coordinates
/// that cannot be squared. A fit that was found but deserves no trust is no error:
/// see [`Fit::doubts`].
pub fn fit(cloud: &PointCloud, options: &FitOptions) -> Result<Fit, FitError> {
    match options.threads.map(usize::from) {
        None => fit_in_pool(cloud, options, cloud.len() >= PARALLEL_POINTS),
        Some(1) => fit_in_pool(cloud, options, false),
        Some(threads) => ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| FitError::Threads { threads, reason: error.to_string() })?
            .install(|| fit_in_pool(cloud, options, cloud.len() >= PARALLEL_POINTS)),
    }
}

fn fit_in_pool(cloud: &PointCloud, options: &FitOptions, parallel: bool) -> Result<Fit, FitError> {
    let moments = normalize(cloud)?;
    let all = PointSet {
        points: cloud.columns(),
        normalization: &moments.normalization,
        parallel,
        residual: Residual::Radial,
    };
    let search = search(&all, &moments, options);
    let (starts, mut passes) = (search.starts, search.passes);
    let mut best = search.into_best().ok_or(FitError::Unbounded)?;
    if all.len() > MEDIUM_POINTS {
        let all = PointSet { residual: residual(options.distance), ..all };
        best = descend(&all, &best.model, &FINISH).unwrap_or(best);
        passes += best.passes;
    }

    let in_cloud = moments.normalization.cloud_from_normalized(&best.model);
    Ok(Fit {
        model: in_cloud.canonical(),
        termination: best.termination,
        doubts: doubts(&best, &moments, cloud.len()),
        rms_radial: best.radial_mean_square.sqrt() * moments.normalization.radius,
        rms_geometric: best.geometric_mean_square.sqrt() * moments.normalization.radius,
        points: cloud.len(),
        points_skipped: cloud.skipped_rows().len(),
        evaluations: passes,
        starts,
        seed: options.seed,
    })
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

/// The search on a part of the points; on all of them, and to the end, where they are few.
fn search(all: &PointSet, moments: &Moments, options: &FitOptions) -> Search {
    let few = Subset::stratified(all.points, COARSE_POINTS, options.seed);
    let few = PointSet { points: few.columns(), parallel: false, ..*all };
    let mut search = Search::coarse(&few, moments);
    let residual = residual(options.distance);
    if residual != few.residual {
        search.refine(&PointSet { residual, ..few }, &BRIEF, SWITCHED_FINALISTS);
    }
    if all.len() <= MEDIUM_POINTS {
        search.refine(&PointSet { residual, ..*all }, &FINISH, FINALISTS);
    } else {
        let some = Subset::stratified(all.points, MEDIUM_POINTS, options.seed);
        let some = PointSet { points: some.columns(), parallel: false, residual, ..*all };
        search.refine(&some, &MEDIUM, FINALISTS);
    }
    search
}

/// What is minimised in the end.
fn residual(distance: Distance) -> Residual {
    match distance {
        Distance::Radial => Residual::Radial,
        Distance::Geometric => Residual::Geometric { saturation: 0.0 },
    }
}
