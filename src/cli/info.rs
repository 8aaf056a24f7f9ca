//! `superquadric info`: a model in, what is known of it out.

use super::DONE;
use super::args::InfoArgs;
use super::error::CliError;
use super::input::read_any_model;
use super::output::print;
use crate::report::{InfoDocument, model_table};

pub(super) fn run(args: &InfoArgs) -> Result<u8, CliError> {
    let model = read_any_model(&args.model)?;
    if args.json {
        print(&InfoDocument::new(&model).to_json())?;
    } else {
        print(&model_table(&model))?;
    }
    Ok(DONE)
}
