//! `superquadric contour`: solids and a camera in, the outline out.

use super::DONE;
use super::args::{ContourArgs, ViewArgs};
use super::error::CliError;
use super::input::{is_stream, name, read_scene};
use super::output::write_text;
use crate::outline::{ContourFormat, Outline};
use crate::pose::Pose;
use crate::solid::Tree;
use crate::view::{AnyCamera, read_camera_from_world};

pub(super) fn run(args: &ContourArgs) -> Result<u8, CliError> {
    let format = match is_stream(&args.output) {
        true => ContourFormat::Json,
        false => ContourFormat::from_extension(&args.output)?,
    };
    let View { solid_camera, camera, .. } = View::read(&args.view)?;
    let outline = Outline::of(&solid_camera, &camera)
        .map_err(|source| CliError::Rim { name: name(&args.view.model), source })?;
    write_text(&args.output, &format.text(&outline, camera.size()))?;
    Ok(DONE)
}

/// A camera and what is before it, in its frame.
pub(super) struct View {
    pub solid_camera: Tree,
    pub camera_from_world: Pose,
    pub camera: AnyCamera,
}

impl View {
    /// Reads what was named; the scene's own camera and pose where no others were.
    pub fn read(args: &ViewArgs) -> Result<Self, CliError> {
        let typed = args.camera.as_ref().map(AnyCamera::read).transpose()?;
        let scene = read_scene(&args.model)?;
        let camera = typed.or(scene.camera).ok_or_else(|| CliError::NoCamera(name(&args.model)))?;
        let camera_from_world = match &args.pose {
            Some(pose) => read_camera_from_world(pose)?,
            None => scene.camera_from_world,
        };
        let solid_camera = scene.solid().moved(&camera_from_world);
        Ok(Self { solid_camera, camera_from_world, camera })
    }
}
