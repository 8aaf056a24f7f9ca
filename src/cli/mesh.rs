//! `superquadric mesh`: a model in, a mesh file out.

use super::DONE;
use super::args::MeshArgs;
use super::error::CliError;
use super::input::read_primitive;
use super::output::{write_mesh, write_mesh_of};
use crate::surface::tessellate_deformed;

pub(super) fn run(args: &MeshArgs) -> Result<u8, CliError> {
    let primitive = read_primitive(&args.model)?;
    if let Some(model) = primitive.undeformed() {
        write_mesh(&args.output, &model, args.resolution)?;
        return Ok(DONE);
    }
    let mesh = tessellate_deformed(&primitive.deformed, args.resolution);
    write_mesh_of(&args.output, &mesh.transformed(&primitive.pose), None)?;
    Ok(DONE)
}
