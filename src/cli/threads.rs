//! Threads for several things at a time.

use std::num::NonZeroUsize;

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::error::CliError;

/// A pool of so many threads, or of as many as the machine offers.
pub(super) fn pool(threads: Option<NonZeroUsize>) -> Result<ThreadPool, CliError> {
    ThreadPoolBuilder::new()
        .num_threads(threads.map_or(0, NonZeroUsize::get))
        .build()
        .map_err(|error| CliError::Threads(error.to_string()))
}
