//! `superquadric batch`: a suite of scenes in, scores out.

use std::io::{self, IsTerminal};
use std::sync::Mutex;

use kdam::{BarExt, tqdm};
use rayon::ThreadPoolBuilder;

use super::DONE;
use super::args::BatchArgs;
use super::error::CliError;
use super::output::print;
use crate::batch::{evaluate, summary_table};

pub(super) fn run(args: &BatchArgs) -> Result<u8, CliError> {
    let options = args.search.options(None);
    let mut builder = ThreadPoolBuilder::new();
    if let Some(threads) = args.threads {
        builder = builder.num_threads(threads.get());
    }
    let pool = builder.build().map_err(|error| CliError::Threads(error.to_string()))?;

    let bar = Mutex::new(tqdm!(desc = "scenes", disable = !io::stderr().is_terminal()));
    let on_scene = |_done: usize, total: usize| {
        // A bar that a panicking thread has left is only a bar.
        let mut bar = bar.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        bar.total = total;
        // What cannot be drawn is not worth an error.
        let _ = bar.update(1);
    };
    let summary = pool.install(|| evaluate(&args.suite, &args.output, &options, &on_scene))?;
    if io::stderr().is_terminal() {
        eprintln!();
    }
    print(&summary_table(&summary))?;
    Ok(DONE)
}
