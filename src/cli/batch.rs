//! `superquadric batch`: a suite of scenes in, scores out.

use super::DONE;
use super::args::BatchArgs;
use super::error::CliError;
use super::output::print;
use super::progress::Progress;
use super::threads::pool;
use crate::batch::{evaluate, summary_table};

pub(super) fn run(args: &BatchArgs) -> Result<u8, CliError> {
    let options = args.search.options(None);
    let progress = Progress::new("scenes", 0);
    let on_scene = |_done: usize, total: usize| progress.step_of(total);
    let summary =
        pool(args.threads)?.install(|| evaluate(&args.suite, &args.output, &options, &on_scene))?;
    progress.end();
    print(&summary_table(&summary))?;
    Ok(DONE)
}
