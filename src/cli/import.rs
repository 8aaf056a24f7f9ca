//! `superquadric import`: a file of another program, or a mesh of ours, in, a model out.

use std::num::NonZeroUsize;
use std::path::Path;

use super::DONE;
use super::args::ImportArgs;
use super::error::CliError;
use super::input::{name, read_mesh_model, read_text};
use super::output::write_text;
use crate::exchange::ImportFormat;
use crate::model::Model;
use crate::report::ModelDocument;

/// Most bytes that are read of another program's file: a million particles and more.
const BYTES: u64 = 1 << 28;

pub(super) fn run(args: &ImportArgs) -> Result<u8, CliError> {
    let model = match args.from.text_format() {
        Some(format) => read_one(&args.file, format, args.number)?.into(),
        None => read_mesh_model(&args.file)?,
    };
    write_text(&args.output, &ModelDocument::from(&model).to_json())?;
    Ok(DONE)
}

/// The superquadric in a file, or the one of that number.
fn read_one(
    file: &Path,
    format: ImportFormat,
    number: Option<NonZeroUsize>,
) -> Result<Model, CliError> {
    let text = read_text(file, BYTES)?;
    let models =
        format.models(&text).map_err(|source| CliError::Import { name: name(file), source })?;
    match (number, &models[..]) {
        (None, [model]) => Ok(*model),
        (Some(number), _) if number.get() <= models.len() => Ok(models[number.get() - 1]),
        _ => Err(CliError::Number { name: name(file), count: models.len() }),
    }
}
