//! `superquadric render`: a solid and a camera in, depths, normals and a picture out.

use std::path::Path;

use super::DONE;
use super::args::RenderArgs;
use super::error::CliError;
use super::input::read_solid;
use super::progress::Progress;
use crate::output::write_whole;
use crate::ray::{Rendering, Shading, SolidTarget, render};
use crate::view::{Camera, read_camera_from_world};

/// Unit of a depth image's counts if neither the camera nor the user tells one: a millimetre.
const DEPTH_UNIT: f64 = 1e-3;

pub(super) fn run(args: &RenderArgs) -> Result<u8, CliError> {
    let camera = Camera::read(&args.view.camera)?;
    let solid = read_solid(&args.view.model)?;
    let solid_camera = match &args.view.pose {
        Some(pose) => solid.moved(&read_camera_from_world(pose)?),
        None => solid,
    };
    let progress = Progress::new("rows", camera.height as usize);
    let rendering = render(&SolidTarget::new(&solid_camera), &camera, || progress.step());
    progress.end();
    write(args, &rendering, &camera)?;
    Ok(DONE)
}

fn write(args: &RenderArgs, rendering: &Rendering, camera: &Camera) -> Result<(), CliError> {
    if let Some(path) = &args.depth {
        let unit = args.depth_unit.or(camera.depth_unit).unwrap_or(DEPTH_UNIT);
        write_whole(path, |writer| match is_npy(path) {
            true => rendering.write_depth_npy(writer),
            false => rendering.write_depth_png(unit, writer),
        })?;
    }
    if let Some(path) = &args.normals {
        write_whole(path, |writer| rendering.write_normals_png(writer))?;
    }
    if let Some(path) = &args.shaded {
        let picture = Shading::default().picture(rendering, camera);
        write_whole(path, |writer| rendering.write_picture(&picture, writer))?;
    }
    Ok(())
}

fn is_npy(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("npy"))
}
