//! The command line: what was typed becomes validated values once, and each subcommand reads
//! straight down from input to output.

mod args;
mod batch;
mod completions;
mod contour;
mod curve;
mod dual;
mod error;
mod evaluate;
mod export;
mod fit;
mod fit_many;
mod import;
mod info;
mod input;
mod mesh;
mod output;
mod overlay;
mod product;
mod progress;
mod render;
mod sample;
mod scene;
mod threads;

use std::process::ExitCode;

use clap::Parser;

use args::{Args, Command};
use error::CliError;

/// The program ran and its result can be used.
const DONE: u8 = 0;
/// The program ran, but the fit cannot be trusted.
const UNTRUSTED: u8 = 1;
/// The input or the command is wrong.
const BAD_INPUT: u8 = 2;

/// Runs the command that was typed; the exit code is 0, 1 or 2 as the help says.
pub fn main() -> ExitCode {
    match run(Args::parse().command) {
        Ok(code) => code.into(),
        // Nobody reads the rest: no reason to complain.
        Err(error) if error.is_broken_pipe() => DONE.into(),
        Err(error) => {
            eprintln!("superquadric: {error}");
            BAD_INPUT.into()
        }
    }
}

fn run(command: Command) -> Result<u8, CliError> {
    match command {
        Command::Fit(args) => fit::run(&args),
        Command::Mesh(args) => mesh::run(&args),
        Command::Info(args) => info::run(&args),
        Command::Sample(args) => sample::run(&args),
        Command::Evaluate(args) => evaluate::run(&args),
        Command::Dual(args) => dual::run(&args),
        Command::Contour(args) => contour::run(&args),
        Command::Curve(args) => curve::run(&args),
        Command::Product(args) => product::run(&args),
        Command::Overlay(args) => overlay::run(&args),
        Command::Render(args) => render::run(&args),
        Command::Export(args) => export::run(&args),
        Command::Import(args) => import::run(&args),
        Command::Batch(args) => batch::run(&args),
        Command::Completions(args) => completions::run(&args),
    }
}
