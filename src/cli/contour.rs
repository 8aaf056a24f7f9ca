//! `superquadric contour`: a model and a camera in, the outline out.

use super::DONE;
use super::args::{ContourArgs, ViewArgs};
use super::error::CliError;
use super::input::{is_stream, name, read_model, read_primitive};
use super::output::write_text;
use crate::model::Model;
use crate::outline::{ContourFormat, Outline};
use crate::solid::Primitive;
use crate::view::{AnyCamera, Camera, model_in_camera, read_camera_from_world};

pub(super) fn run(args: &ContourArgs) -> Result<u8, CliError> {
    let format = match is_stream(&args.output) {
        true => ContourFormat::Json,
        false => ContourFormat::from_extension(&args.output)?,
    };
    let camera = AnyCamera::read(&args.view.camera)?;
    let primitive = read_primitive(&args.view.model)?;
    let primitive_camera = match &args.view.pose {
        Some(pose) => {
            let pose = read_camera_from_world(pose)?.after(&primitive.pose);
            Primitive { pose, ..primitive }
        }
        None => primitive,
    };
    let outline = match &camera {
        AnyCamera::Pinhole(camera) => Outline::of(&primitive_camera, camera),
        AnyCamera::Orthographic(camera) => Outline::of(&primitive_camera, camera),
    }
    .map_err(|source| CliError::Rim { name: name(&args.view.model), source })?;
    write_text(&args.output, &format.text(&outline, camera.size()))?;
    Ok(DONE)
}

/// The model in the camera's frame, and the camera.
pub(super) fn read_view(args: &ViewArgs) -> Result<(Model, Camera), CliError> {
    let model = read_model(&args.model)?;
    let camera = Camera::read(&args.camera)?;
    let model_camera = match &args.pose {
        Some(pose) => model_in_camera(&read_camera_from_world(pose)?, &model),
        None => model,
    };
    Ok((model_camera, camera))
}
