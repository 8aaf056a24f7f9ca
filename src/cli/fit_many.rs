//! `superquadric fit` of several files or a folder: a result each, several at a time.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use rayon::prelude::*;

use super::args::FitArgs;
use super::error::CliError;
use super::fit::{Fitted, fit_file};
use super::input::{is_stream, name};
use super::output::{print, write_text};
use super::progress::Progress;
use super::threads::pool;
use super::{BAD_INPUT, DONE, UNTRUSTED};
use crate::recover::FitOptions;
use crate::report::{FitDocument, fit_line};

/// Endings of the files of a folder that are clouds.
const CLOUDS: [&str; 6] = ["ply", "pcd", "npy", "xyz", "csv", "txt"];

/// That of depth maps.
const DEPTH_MAPS: [&str; 1] = ["png"];

pub(super) fn run(args: &FitArgs) -> Result<u8, CliError> {
    refuse_single_outputs(args)?;
    let files = files(args)?;
    let names = output_names(&files)?;
    if let Some(folder) = &args.output {
        fs::create_dir_all(folder)
            .map_err(|source| CliError::Folder { folder: folder.clone(), source })?;
    }
    let progress = Progress::new("clouds", files.len());
    let outcomes: Vec<Result<Fitted, CliError>> = pool(args.threads)?.install(|| {
        let fit = |(file, output): (&PathBuf, &OsString)| {
            let outcome = fit_one(args, file, output);
            progress.step();
            outcome
        };
        files.par_iter().zip(&names).map(fit).collect()
    });
    progress.end();
    tell(&files, &outcomes)
}

/// Fits a file on one thread, and writes its document.
fn fit_one(args: &FitArgs, file: &Path, output: &OsString) -> Result<Fitted, CliError> {
    let options =
        FitOptions { threads: std::num::NonZeroUsize::new(1), ..args.search.options(None) };
    let fitted = fit_file(args, file, options)?;
    if let Some(folder) = &args.output {
        let document = FitDocument::new(&fitted.fit, fitted.seconds);
        write_text(&folder.join(output), &document.to_json())?;
    }
    Ok(fitted)
}

/// A line for each file in their order; what failed to stderr.
fn tell(files: &[PathBuf], outcomes: &[Result<Fitted, CliError>]) -> Result<u8, CliError> {
    let mut code = DONE;
    for (file, outcome) in files.iter().zip(outcomes) {
        match outcome {
            Ok(fitted) => {
                print(&fit_line(&name(file), &fitted.fit))?;
                code = code.max(if fitted.fit.is_trusted() { DONE } else { UNTRUSTED });
            }
            Err(error) => {
                eprintln!("superquadric: {error}");
                code = BAD_INPUT;
            }
        }
    }
    Ok(code)
}

/// What there can be only one of is refused.
fn refuse_single_outputs(args: &FitArgs) -> Result<(), CliError> {
    let single = [("--mesh", &args.mesh), ("--inliers", &args.inliers)];
    if let Some((option, _)) = single.into_iter().find(|(_, path)| path.is_some()) {
        return Err(CliError::OneCloudOnly(option));
    }
    match &args.output {
        Some(output) if is_stream(output) => Err(CliError::OneCloudOnly("-o -")),
        _ if args.sensor.mask.is_some() => Err(CliError::OneCloudOnly("--mask")),
        _ => Ok(()),
    }
}

/// The files that are meant, those of a folder by name.
fn files(args: &FitArgs) -> Result<Vec<PathBuf>, CliError> {
    let endings = if args.sensor.camera.is_some() { &DEPTH_MAPS[..] } else { &CLOUDS[..] };
    let mut files = Vec::new();
    for path in &args.clouds {
        if path.is_dir() {
            files.extend(files_in(path, endings)?);
        } else {
            files.push(path.clone());
        }
    }
    Ok(files)
}

fn files_in(folder: &Path, endings: &[&str]) -> Result<Vec<PathBuf>, CliError> {
    let cannot_list = |source| CliError::Input { name: name(folder), source };
    let is_meant = |path: &PathBuf| {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        path.is_file() && ending.is_some_and(|ending| endings.contains(&ending.as_str()))
    };
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(cannot_list)? {
        files.push(entry.map_err(cannot_list)?.path());
    }
    files.retain(is_meant);
    files.sort();
    if files.is_empty() {
        return Err(CliError::NoFiles { folder: folder.to_owned(), endings: endings.join(", ") });
    }
    Ok(files)
}

/// Names of the documents, each different: the files' own with .json after them.
fn output_names(files: &[PathBuf]) -> Result<Vec<OsString>, CliError> {
    let mut taken = BTreeSet::new();
    let named = |file: &PathBuf| {
        let mut output = file.file_name().unwrap_or(file.as_os_str()).to_owned();
        output.push(".json");
        if taken.insert(output.clone()) {
            Ok(output)
        } else {
            Err(CliError::SameName(file.clone()))
        }
    };
    files.iter().map(named).collect()
}
