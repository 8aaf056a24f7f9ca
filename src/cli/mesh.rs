//! `superquadric mesh`: a model in, a mesh file out.

use super::DONE;
use super::args::MeshArgs;
use super::error::CliError;
use super::input::read_any_model;
use super::output::write_mesh;

pub(super) fn run(args: &MeshArgs) -> Result<u8, CliError> {
    let model = read_any_model(&args.model)?;
    write_mesh(&args.output, &model, args.resolution)?;
    Ok(DONE)
}
