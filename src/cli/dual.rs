//! `superquadric dual`: a model in, its dual out.

use super::DONE;
use super::args::DualArgs;
use super::error::CliError;
use super::input::{name, read_any_model};
use super::output::write_text;
use crate::report::ModelDocument;

pub(super) fn run(args: &DualArgs) -> Result<u8, CliError> {
    let dual = read_any_model(&args.model)?
        .dual()
        .map_err(|source| CliError::Dual { name: name(&args.model), source })?;
    write_text(&args.output, &ModelDocument::from(&dual).to_json())?;
    Ok(DONE)
}
