//! `superquadric mesh`: a model in, a mesh file out.

use super::DONE;
use super::args::MeshArgs;
use super::error::CliError;
use super::input::read_any_model;
use super::output::write_mesh;

pub(super) fn run(args: &MeshArgs) -> Result<u8, CliError> {
    let model = read_any_model(&args.model)?;
    let mesh = args.fineness.mesh(&model.shape)?.transformed(&model.pose);
    write_mesh(&args.output, &mesh, &model)?;
    Ok(DONE)
}
