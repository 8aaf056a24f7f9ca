//! One scene: its cloud fitted, the fit scored.

use std::fs;
use std::num::NonZeroUsize;
use std::path::Path;
use std::time::Instant;

use super::record::{Outcome, Record, Score};
use super::suite::SceneEntry;
use crate::cloud;
use crate::compare::{rotation_error, size_error, surface_distance, volume_overlap};
use crate::model::Model;
use crate::recover::{FitOptions, fit};
use crate::report::{ModelDocument, model_from_json};

/// Points that the overlap is estimated from: a standard error of about 1e-3.
const VOLUME_SAMPLES: usize = 40_000;

/// Points a side that the surface distance is estimated from.
const SURFACE_SAMPLES: usize = 500;

/// Seed of the scoring, the same for every scene.
const SEED: u64 = 0;

/// Fits and scores a scene; what goes wrong becomes the outcome.
pub(super) fn evaluate(folder: &Path, entry: &SceneEntry, options: &FitOptions) -> Record {
    let outcome = attempt(folder, options)
        .map_or_else(|error| Outcome::Failed { error }, |score| Outcome::Fitted(Box::new(score)));
    Record {
        scene: entry.name.clone(),
        level: entry.level.clone(),
        family: entry.family.clone(),
        outcome,
    }
}

fn attempt(folder: &Path, options: &FitOptions) -> Result<Score, String> {
    let truth = read_truth(&folder.join("truth.json"))?;
    let cloud = cloud::read(&folder.join("cloud.ply")).map_err(|error| error.to_string())?;
    // The scenes share the threads; a fit has its own.
    let options = FitOptions { threads: NonZeroUsize::new(1), ..options.clone() };
    let start = Instant::now();
    let fit = fit(&cloud, &options).map_err(|error| error.to_string())?;
    let seconds = start.elapsed().as_secs_f64();

    let overlap = volume_overlap(&truth, &fit.model, VOLUME_SAMPLES, SEED);
    Ok(Score {
        iou: overlap.iou,
        iou_standard_error: overlap.standard_error,
        surface_distance: surface_distance(&truth, &fit.model, SURFACE_SAMPLES, SEED).relative_mean,
        size_error: size_error(&truth, &fit.model),
        rotation_error: rotation_error(&truth, &fit.model),
        trusted: fit.is_trusted(),
        rms_radial: fit.rms_radial,
        rms_geometric: fit.rms_geometric,
        points: fit.points,
        points_skipped: fit.points_skipped,
        evaluations: fit.evaluations,
        starts: fit.starts,
        seconds,
        model: ModelDocument::from(&fit.model),
    })
}

fn read_truth(path: &Path) -> Result<Model, String> {
    let named = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = fs::read_to_string(path).map_err(|error| named(&error))?;
    model_from_json(&text).map_err(|error| named(&error))
}
