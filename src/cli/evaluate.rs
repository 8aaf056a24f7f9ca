//! `superquadric evaluate`: a model and points in, where the points lie to it out.

use super::DONE;
use super::args::EvaluateArgs;
use super::error::CliError;
use super::input::{is_stream, read_cloud, read_scene};
use super::output::{point_table_format, write_point_table};
use crate::report::evaluation_table;

pub(super) fn run(args: &EvaluateArgs) -> Result<u8, CliError> {
    if is_stream(&args.model) && is_stream(&args.points) {
        return Err(CliError::OneStdin);
    }
    let format = point_table_format(&args.output)?;
    let solid = read_scene(&args.model)?.solid();
    let table = evaluation_table(&solid, &read_cloud(&args.points)?);
    write_point_table(&args.output, format, &table)?;
    Ok(DONE)
}
