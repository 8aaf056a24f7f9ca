//! What a fit is given: the object's points, and what is known besides them.

use std::path::Path;

use super::args::{SensorArgs, SupportArg};
use super::error::CliError;
use super::input::{name, read_cloud};
use crate::cloud::PointCloud;
use crate::recover::{Plane, Sight};
use crate::view::{Camera, DepthMap, find_plane, points_above};

/// An object before a sensor.
pub(super) struct Scene {
    pub cloud: PointCloud,
    pub sight: Option<Sight>,
    pub support: Option<Plane>,
}

impl Scene {
    /// Reads the cloud or depth map, and finds the plane if that is asked for.
    pub fn read(path: &Path, sensor: &SensorArgs, seed: u64) -> Result<Self, CliError> {
        let Some(camera) = &sensor.camera else {
            return Self::of_cloud(path, sensor, seed);
        };
        let camera = Camera::read(camera)?;
        let map = DepthMap::read(path, camera, sensor.mask.as_deref(), sensor.depth_unit)?;
        let sight = Some(map.sight());
        let cloud = map.object_points();
        match sensor.support {
            Some(SupportArg::Auto) if sensor.mask.is_some() => {
                let found = find_plane(&map.surroundings(), [0.0; 3], seed);
                let plane = found.ok_or_else(|| CliError::NoPlane(name(path)))?;
                Ok(Self { cloud, sight, support: Some(plane) })
            }
            Some(SupportArg::Auto) => Self::on_its_plane(path, cloud, [0.0; 3], sight, seed),
            Some(SupportArg::Plane(plane)) => Ok(Self { cloud, sight, support: Some(plane) }),
            None => Ok(Self { cloud, sight, support: None }),
        }
    }

    fn of_cloud(path: &Path, sensor: &SensorArgs, seed: u64) -> Result<Self, CliError> {
        let sight = sensor.viewpoint.map(Sight::from_viewpoint);
        let support = match (sensor.support, sensor.viewpoint) {
            (None, _) => None,
            (Some(SupportArg::Plane(plane)), _) => Some(plane),
            (Some(SupportArg::Auto), None) => return Err(CliError::NoUpside),
            (Some(SupportArg::Auto), Some(viewpoint)) => {
                return Self::on_its_plane(path, read_cloud(path)?, viewpoint, sight, seed);
            }
        };
        Ok(Self { cloud: read_cloud(path)?, sight, support })
    }

    /// The object on a plane that is in the same cloud: the points above it.
    fn on_its_plane(
        path: &Path,
        cloud: PointCloud,
        viewpoint: [f64; 3],
        sight: Option<Sight>,
        seed: u64,
    ) -> Result<Self, CliError> {
        let found = find_plane(&cloud, viewpoint, seed);
        let plane = found.ok_or_else(|| CliError::NoPlane(name(path)))?;
        Ok(Self { cloud: points_above(&cloud, &plane, viewpoint), sight, support: Some(plane) })
    }
}
