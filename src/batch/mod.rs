//! Evaluation over a suite of scenes with known truth: fit each, score it, sum up.
//!
//! A suite is a folder with `suite.json` and, for each scene that it lists, `scenes/NAME/` with
//! `cloud.ply` and `truth.json`. The results are a folder, too: `scenes/NAME.json` for each
//! scene as soon as it is done, so that an interrupted run goes on where it ended; `scenes.csv`,
//! a row a scene; and `summary.json`, by level.

mod error;
mod record;
mod results;
mod scene;
mod suite;
mod summary;

pub use error::BatchError;
pub use record::{Outcome, Record, Score};
pub use summary::{LevelSummary, Quartiles, SUCCESS_IOU, Summary, summary_table};

use std::path::Path;

use rayon::prelude::*;

use crate::recover::FitOptions;
use results::Results;
use suite::Suite;

/// Fits and scores all scenes of a suite that are not yet among the results, in parallel, a
/// scene a thread; then writes the table and the summary.
///
/// `on_scene` is told of each scene as it ends, from any thread: the number done, of how many.
/// What a scene's own files or fit do wrong becomes its row.
///
/// # Errors
/// If the suite cannot be read, the results cannot be written, or stem from another suite or
/// other options.
pub fn evaluate(
    suite_folder: &Path,
    results_folder: &Path,
    options: &FitOptions,
    on_scene: &(dyn Fn(usize, usize) + Sync),
) -> Result<Summary, BatchError> {
    evaluate_unless(suite_folder, results_folder, options, on_scene, &|| false)
}

/// [`evaluate`], but given up between scenes as soon as `is_interrupted`; what is done is kept.
///
/// # Errors
/// Those of [`evaluate`], and [`BatchError::Interrupted`].
pub fn evaluate_unless(
    suite_folder: &Path,
    results_folder: &Path,
    options: &FitOptions,
    on_scene: &(dyn Fn(usize, usize) + Sync),
    is_interrupted: &(dyn Fn() -> bool + Sync),
) -> Result<Summary, BatchError> {
    let suite = Suite::read(suite_folder)?;
    let results = Results::open(results_folder, &suite, options)?;
    let total = suite.scenes.len();
    let done = std::sync::atomic::AtomicUsize::new(0);

    let records: Vec<Record> = suite
        .scenes
        .par_iter()
        .map(|entry| {
            if is_interrupted() {
                return Err(BatchError::Interrupted);
            }
            let record = match results.finished(entry)? {
                Some(record) => record,
                None => {
                    let record = scene::evaluate(&suite.scene_folder(entry), entry, options);
                    results.keep(&record)?;
                    record
                }
            };
            on_scene(1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed), total);
            Ok(record)
        })
        .collect::<Result<_, BatchError>>()?;

    let summary = Summary::of(&suite.name, &suite.levels, &records);
    results.write_tables(&records, &summary)?;
    Ok(summary)
}
