//! `superquadric overlay`: a model, a camera and its picture in, the picture drawn over out.

use super::DONE;
use super::args::OverlayArgs;
use super::contour::View;
use super::error::CliError;
use super::input::{name, read_cloud};
use crate::cloud::PointCloud;
use crate::outline::Picture;
use crate::output::write_whole;
use crate::pose::Pose;
use crate::view::{AnyCamera, DepthMap};

pub(super) fn run(args: &OverlayArgs) -> Result<u8, CliError> {
    let View { solid_camera, camera_from_world, camera } = View::read(&args.view)?;
    let points_camera = read_points(args, &camera, &camera_from_world)?;
    let mut picture = Picture::read(&args.image, camera)?;
    picture
        .draw(&solid_camera, &points_camera)
        .map_err(|source| CliError::Rim { name: name(&args.view.model), source })?;
    write_whole(&args.output, |writer| picture.write(writer))?;
    Ok(DONE)
}

/// The points to colour, in the camera's frame; none if none were given.
fn read_points(
    args: &OverlayArgs,
    camera: &AnyCamera,
    camera_from_world: &Pose,
) -> Result<PointCloud, CliError> {
    if let Some(depth) = &args.depth {
        let AnyCamera::Pinhole(camera) = camera else { return Err(CliError::DepthOfParallel) };
        let map = DepthMap::read(depth, *camera, args.mask.as_deref(), args.depth_unit)?;
        return Ok(map.object_points());
    }
    let Some(points) = &args.points else { return Ok(PointCloud::new()) };
    let cloud = read_cloud(points)?;
    Ok(cloud.points().map(|x| camera_from_world.world_from_model(&x.into()).into()).collect())
}
