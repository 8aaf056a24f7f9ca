//! `superquadric info`: a model in, what is known of it out.

use super::DONE;
use super::args::InfoArgs;
use super::error::CliError;
use super::input::{name, read_primitive};
use super::output::print;
use crate::model::Model;
use crate::report::{InfoDocument, PrimitiveInfoDocument, model_table, primitive_table};

pub(super) fn run(args: &InfoArgs) -> Result<u8, CliError> {
    let primitive = read_primitive(&args.model)?;
    let is_deformed = !primitive.deformed.chain().stages().is_empty();
    let model = Model { shape: *primitive.deformed.shape(), pose: primitive.pose };
    let text = match (is_deformed, args.json) {
        (false, false) => model_table(&model),
        (false, true) => InfoDocument::new(&model).to_json(),
        (true, false) => primitive_table(&primitive),
        (true, true) => PrimitiveInfoDocument::new(&primitive)
            .map_err(|source| CliError::Document { name: name(&args.model), source })?
            .to_json(),
    };
    print(&text)?;
    Ok(DONE)
}
