//! What a fit is given: the object's points, and what is known besides them.

use std::path::Path;

use super::args::{SensorArgs, SupportArg};
use super::error::CliError;
use super::input::{name, read_cloud};
use crate::cloud::PointCloud;
use crate::recover::{Plane, Sight};
use crate::view::{Camera, DepthMap, find_plane, points_above};

/// Where a depth map's camera stands in its own frame.
const CAMERA: [f64; 3] = [0.0; 3];

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
        let cloud = map.inner_points();
        let plane = match sensor.support {
            None => return Ok(Self { cloud, sight, support: None }),
            Some(SupportArg::Plane(plane)) => plane,
            Some(SupportArg::Auto) => {
                let around = if sensor.mask.is_some() { &map.surroundings() } else { &cloud };
                find_plane(around, CAMERA, seed).ok_or_else(|| CliError::NoPlane(name(path)))?
            }
        };
        Ok(Self { cloud: points_above(&cloud, &plane, CAMERA), sight, support: Some(plane) })
    }

    fn of_cloud(path: &Path, sensor: &SensorArgs, seed: u64) -> Result<Self, CliError> {
        let sight = sensor.viewpoint.map(Sight::from_viewpoint);
        let support = match (sensor.support, sensor.viewpoint) {
            (None, _) => None,
            (Some(SupportArg::Plane(plane)), _) => Some(plane),
            (Some(SupportArg::Auto), None) => return Err(CliError::NoUpside),
            (Some(SupportArg::Auto), Some(viewpoint)) => {
                let cloud = read_cloud(path)?;
                let found = find_plane(&cloud, viewpoint, seed);
                let plane = found.ok_or_else(|| CliError::NoPlane(name(path)))?;
                let cloud = points_above(&cloud, &plane, viewpoint);
                return Ok(Self { cloud, sight, support: Some(plane) });
            }
        };
        Ok(Self { cloud: read_cloud(path)?, sight, support })
    }
}
