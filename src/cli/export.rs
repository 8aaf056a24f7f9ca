//! `superquadric export`: a model in, the text of another program out.

use super::DONE;
use super::args::ExportArgs;
use super::error::CliError;
use super::input::{name, read_any_model};
use super::output::write_text;
use crate::exchange::ExportFormat;

pub(super) fn run(args: &ExportArgs) -> Result<u8, CliError> {
    let model = read_any_model(&args.model)?;
    let text = ExportFormat::from(args.to)
        .text(model)
        .map_err(|source| CliError::Export { name: name(&args.model), source })?;
    write_text(&args.output, &text)?;
    Ok(DONE)
}
