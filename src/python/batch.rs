//! The evaluation of a suite, behind `superquadric.batch`.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::OnceLock;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::fit::{distance_named, precision_named};
use super::interrupt::interruptible;
use crate::batch::evaluate_unless;
use crate::recover::FitOptions;

/// Fit and score the scenes of a suite that are not yet among the results; write the tables.
///
/// `on_scene` is told, from any thread, how many scenes are done, of how many. What it raises
/// ends the evaluation, as Ctrl-C does; what is done is kept.
///
/// Raises:
///     BatchError: if the suite or the results are not what they should be.
///     OSError: if a file cannot be read or written.
///     ValueError: if there is no such distance or precision.
#[pyfunction(name = "_evaluate_suite")]
#[pyo3(signature = (
    suite, results, *, seed, distance, precision, threads = None, on_scene = None
))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
pub(super) fn evaluate_suite(
    py: Python<'_>,
    suite: PathBuf,
    results: PathBuf,
    seed: u64,
    distance: &str,
    precision: &str,
    threads: Option<NonZeroUsize>,
    on_scene: Option<Py<PyAny>>,
) -> PyResult<()> {
    let options = FitOptions {
        seed,
        distance: distance_named(distance)?,
        precision: precision_named(precision)?,
        ..FitOptions::default()
    };
    let pool = pool_of(threads)?;
    let raised = OnceLock::new();
    let tell = |done: usize, total: usize| {
        let Some(on_scene) = &on_scene else { return };
        if let Err(error) = Python::attach(|py| on_scene.call1(py, (done, total))) {
            // One that another thread has raised before stands for all.
            let _ = raised.set(error);
        }
    };
    let outcome = interruptible(py, |is_interrupted| {
        let give_up = || is_interrupted() || raised.get().is_some();
        pool.install(|| evaluate_unless(&suite, &results, &options, &tell, &give_up))
    })?;
    match raised.into_inner() {
        Some(error) => Err(error),
        None => Ok(outcome.map(|_| ())?),
    }
}

fn pool_of(threads: Option<NonZeroUsize>) -> PyResult<ThreadPool> {
    let pool = ThreadPoolBuilder::new().num_threads(threads.map_or(0, NonZeroUsize::get)).build();
    pool.map_err(|error| PyRuntimeError::new_err(error.to_string()))
}
