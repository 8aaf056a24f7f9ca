//! The cameras of scenes, and where they stand.

use nalgebra::{Matrix3, Vector3};
use serde::Deserialize;

use super::model_document::DocumentError;
use crate::pose::Pose;
use crate::ray::camera_looking_at;
use crate::view::{AnyCamera, Camera, Distortion, OrthographicCamera};

/// Most columns or rows of a picture.
const MOST_PIXELS: u32 = 16_384;

/// A camera, in pixels, and its place in the world.
#[derive(Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(super) enum CameraDocument {
    Pinhole(PinholeDocument),
    Orthographic(OrthographicDocument),
}

/// As [`Camera`].
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PinholeDocument {
    fx: f64,
    fy: f64,
    cx: f64,
    cy: f64,
    width: u32,
    height: u32,
    depth_units_m: Option<f64>,
    #[serde(default)]
    distortion: Distortion,
    #[serde(default)]
    view: ViewDocument,
}

/// As [`OrthographicCamera`].
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OrthographicDocument {
    scale: [f64; 2],
    origin: [f64; 2],
    width: u32,
    height: u32,
    #[serde(default)]
    view: ViewDocument,
}

/// Where a camera stands: a matrix of rows `[R | t]`, or what it looks at; if neither is given, the
/// camera's frame is the world.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ViewDocument {
    camera_from_world: Option<[[f64; 4]; 3]>,
    eye: Option<[f64; 3]>,
    target: Option<[f64; 3]>,
    up: Option<[f64; 3]>,
}

impl CameraDocument {
    /// The camera, and the motion from the world to its frame.
    pub fn placed(&self) -> Result<(AnyCamera, Pose), DocumentError> {
        let (camera, view) = match self {
            Self::Pinhole(document) => (AnyCamera::Pinhole(document.camera()?), &document.view),
            Self::Orthographic(document) => {
                (AnyCamera::Orthographic(document.camera()?), &document.view)
            }
        };
        if camera.size().iter().any(|side| !(1..=MOST_PIXELS).contains(side)) {
            return Err(invalid("a width and a height from 1 to 16384"));
        }
        Ok((camera, view.pose().map_err(|error| error.at("view"))?))
    }
}

impl PinholeDocument {
    fn camera(&self) -> Result<Camera, DocumentError> {
        let Self { fx, fy, cx, cy, width, height, depth_units_m, distortion, .. } = *self;
        let depth_unit = depth_units_m;
        let camera = Camera { fx, fy, cx, cy, width, height, depth_unit, distortion };
        camera.checked().map_err(|error| DocumentError::Camera(error.to_string()))
    }
}

impl OrthographicDocument {
    fn camera(&self) -> Result<OrthographicCamera, DocumentError> {
        let Self { scale, origin, width, height, .. } = *self;
        let camera = OrthographicCamera { scale, origin, width, height };
        camera.checked().map_err(|error| DocumentError::Camera(error.to_string()))
    }
}

impl ViewDocument {
    fn pose(&self) -> Result<Pose, DocumentError> {
        match (self.camera_from_world, self.eye, self.target, self.up) {
            (None, None, None, None) => Ok(Pose::identity()),
            (Some(rows), None, None, None) => {
                let translation = Vector3::from_fn(|i, _| rows[i][3]);
                Ok(Pose::from_matrix(Matrix3::from_fn(|i, j| rows[i][j]), translation)?)
            }
            (None, Some(eye), Some(target), Some(up)) => {
                let [eye, target, up] = [eye, target, up].map(Vector3::from);
                camera_looking_at(&eye, &target, &up)
                    .ok_or_else(|| invalid("eye, target and up not on a line"))
            }
            _ => Err(invalid("either camera_from_world, or eye, target and up")),
        }
    }
}

fn invalid(expected: &str) -> DocumentError {
    DocumentError::Camera(format!("expected {expected}"))
}
