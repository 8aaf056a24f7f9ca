//! `superquadric curve`: a plane curve in, points along it out.

use super::DONE;
use super::args::CurveArgs;
use super::error::CliError;
use super::input::{is_stream, read_curve};
use super::output::write_text;
use crate::report::CurveFormat;

/// Quadrants of a plane.
const QUADRANTS: usize = 4;

pub(super) fn run(args: &CurveArgs) -> Result<u8, CliError> {
    let format = match is_stream(&args.output) {
        true => CurveFormat::Csv,
        false => CurveFormat::from_extension(&args.output)?,
    };
    let segments = (args.points as usize).div_ceil(QUADRANTS);
    write_text(&args.output, &format.text(&read_curve(&args.curve)?.polylines(segments)))?;
    Ok(DONE)
}
