//! `superquadric sample`: a model in, points of its surface out.

use super::DONE;
use super::args::SampleArgs;
use super::error::CliError;
use super::input::{name, read_primitive};
use super::output::{point_table_format, write_point_table};
use crate::report::surface_table;

pub(super) fn run(args: &SampleArgs) -> Result<u8, CliError> {
    let (format, spread) = (point_table_format(&args.output)?, args.spread()?);
    let table = surface_table(&read_primitive(&args.model)?, spread)
        .map_err(|source| CliError::NotUniform { name: name(&args.model), source })?;
    write_point_table(&args.output, format, &table)?;
    Ok(DONE)
}
