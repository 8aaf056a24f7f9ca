//! `superquadric info`: a model in, what is known of it out.

use super::DONE;
use super::args::InfoArgs;
use super::error::CliError;
use super::input::{name, read_primitive};
use super::output::print;
use crate::report::{InfoDocument, PrimitiveInfoDocument, model_table, primitive_table};

pub(super) fn run(args: &InfoArgs) -> Result<u8, CliError> {
    let primitive = read_primitive(&args.model)?;
    let text = match (primitive.undeformed(), args.json) {
        (Some(model), false) => model_table(&model),
        (Some(model), true) => InfoDocument::new(&model).to_json(),
        (None, false) => primitive_table(&primitive),
        (None, true) => PrimitiveInfoDocument::new(&primitive)
            .map_err(|source| CliError::Document { name: name(&args.model), source })?
            .to_json(),
    };
    print(&text)?;
    Ok(DONE)
}
