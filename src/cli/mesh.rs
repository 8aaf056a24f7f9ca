//! `superquadric mesh`: a model or a solid in, a mesh file out.

use super::DONE;
use super::args::MeshArgs;
use super::error::CliError;
use super::input::{name, read_scene};
use super::output::write_mesh;
use crate::solid::Tree;
use crate::surface::boundary_mesh;

/// Cells along the longest side of a solid to a segment of a model's lattice: both then resolve
/// about the same.
const CELLS_TO_A_SEGMENT: usize = 3;

pub(super) fn run(args: &MeshArgs) -> Result<u8, CliError> {
    let solid = read_scene(&args.model)?.solid();
    let Tree::Leaf(primitive) = &solid else {
        if args.fineness.tolerance.is_some() {
            return Err(CliError::NoTolerance(name(&args.model)));
        }
        let cells = CELLS_TO_A_SEGMENT * args.fineness.resolution.segments();
        write_mesh(&args.output, &boundary_mesh(&solid, solid.bounding_box(), cells), None)?;
        return Ok(DONE);
    };
    let mesh = args.fineness.mesh(&primitive.deformed)?.transformed(&primitive.pose);
    write_mesh(&args.output, &mesh, primitive.undeformed().as_ref())?;
    Ok(DONE)
}
