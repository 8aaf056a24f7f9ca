//! `superquadric product`: two plane curves in, a mesh of their spherical product out.

use super::DONE;
use super::args::ProductArgs;
use super::error::CliError;
use super::input::read_curve;
use super::output::write_mesh;
use crate::surface::spherical_product_mesh;

pub(super) fn run(args: &ProductArgs) -> Result<u8, CliError> {
    let [north, east] = [read_curve(&args.north)?, read_curve(&args.east)?];
    write_mesh(&args.output, &spherical_product_mesh(&north, &east, args.resolution), None)?;
    Ok(DONE)
}
