//! `superquadric info`: a model in, what is known of it out.

use super::DONE;
use super::args::InfoArgs;
use super::error::CliError;
use super::input::{name, read_primitive};
use super::output::print;
use crate::report::{
    DocumentError, InfoDocument, PrimitiveInfoDocument, model_table, primitive_table,
};
use crate::shape::Shape;
use crate::solid::Primitive;

pub(super) fn run(args: &InfoArgs) -> Result<u8, CliError> {
    let primitive = read_primitive(&args.model)?;
    let text = text(&primitive, args.json)
        .map_err(|source| CliError::Document { name: name(&args.model), source })?;
    print(&text)?;
    Ok(DONE)
}

fn text(primitive: &Primitive<Shape>, as_json: bool) -> Result<String, DocumentError> {
    Ok(match (primitive.undeformed(), as_json) {
        (Some(model), false) => model_table(&model),
        (Some(model), true) => InfoDocument::new(&model).to_json(),
        (None, false) => primitive_table(primitive)?,
        (None, true) => PrimitiveInfoDocument::new(primitive)?.to_json(),
    })
}
