//! `superquadric completions`: a script for a shell.

use clap::CommandFactory;

use super::DONE;
use super::args::{Args, CompletionsArgs};
use super::error::CliError;
use super::output::print;

pub(super) fn run(args: &CompletionsArgs) -> Result<u8, CliError> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "superquadric", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(DONE)
}
