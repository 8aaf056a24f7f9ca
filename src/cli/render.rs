//! `superquadric render`: a scene in, depths, normals and a picture out.

use std::path::Path;

use super::DONE;
use super::args::RenderArgs;
use super::error::CliError;
use super::input::{name, read_scene};
use super::progress::Progress;
use crate::output::write_whole;
use crate::ray::{Rendering, Scene};
use crate::view::{AnyCamera, read_camera_from_world};

/// Unit of a depth image's counts if neither the camera nor the user tells one: a millimetre.
const DEPTH_UNIT: f64 = 1e-3;

pub(super) fn run(args: &RenderArgs) -> Result<u8, CliError> {
    let mut scene = read_scene(&args.scene)?;
    let typed = args.camera.as_ref().map(AnyCamera::read).transpose()?;
    let camera = typed.or(scene.camera).ok_or_else(|| CliError::NoCamera(name(&args.scene)))?;
    if let Some(pose) = &args.pose {
        scene.camera_from_world = read_camera_from_world(pose)?;
    }
    let progress = Progress::new("rows", camera.size()[1] as usize);
    let rendering = scene.rendering(&camera, || progress.step());
    progress.end();
    write(args, &scene, &rendering, &camera)?;
    Ok(DONE)
}

fn write(
    args: &RenderArgs,
    scene: &Scene,
    rendering: &Rendering,
    camera: &AnyCamera,
) -> Result<(), CliError> {
    if let Some(path) = &args.depth {
        let unit = args.depth_unit.or(depth_unit(camera)).unwrap_or(DEPTH_UNIT);
        write_whole(path, |writer| match is_npy(path) {
            true => rendering.write_depth_npy(writer),
            false => rendering.write_depth_png(unit, writer),
        })?;
    }
    if let Some(path) = &args.normals {
        write_whole(path, |writer| rendering.write_normals_png(writer))?;
    }
    if let Some(path) = &args.shaded {
        let picture = scene.shading().picture(rendering, camera);
        write_whole(path, |writer| rendering.write_picture(&picture, writer))?;
    }
    Ok(())
}

fn depth_unit(camera: &AnyCamera) -> Option<f64> {
    match camera {
        AnyCamera::Pinhole(camera) => camera.depth_unit,
        AnyCamera::Orthographic(_) => None,
    }
}

fn is_npy(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("npy"))
}
