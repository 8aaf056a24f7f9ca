//! Cameras of either kind, told apart by their files.

use std::path::Path;

use nalgebra::Vector3;
use serde::Deserialize;

use super::camera::Camera;
use super::camera_file::{parse, parse_values, value_as};
use super::error::{ImageError, ImageProblem};
use super::projection::{OrthographicCamera, Projection};
use super::rim::Viewpoint;
use crate::pose::Pose;

/// A camera of either kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum AnyCamera {
    /// Lines of sight meet in its centre.
    Pinhole(Camera),
    /// Lines of sight are parallel.
    Orthographic(OrthographicCamera),
}

/// `{"model": "orthographic", "scale": [pixels per unit along rows, along columns], "origin":
/// [column, row], "width": .., "height": ..}`.
#[derive(Deserialize)]
struct OrthographicDocument {
    scale: [f64; 2],
    origin: [f64; 2],
    width: u32,
    height: u32,
}

impl AnyCamera {
    /// Reads an orthographic camera from JSON or YAML, `{"model": "orthographic", "scale": [..],
    /// "origin": [..], "width": .., "height": ..}` with the scale in pixels to a unit of length and
    /// the column and row at which the camera's origin is seen; or a pinhole camera as
    /// [`Camera::read`] does.
    ///
    /// # Errors
    /// If the file cannot be read, is not such a document, or holds numbers that no camera has.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ImageError> {
        let path = path.as_ref();
        let read = || {
            let bytes = super::image::read_bytes(path, super::camera::DOCUMENT_BYTES)?;
            let document = parse_values(&bytes)?;
            match document.get("model").and_then(|model| model.as_str()) {
                Some("orthographic") => {
                    value_as::<OrthographicDocument>(document)?.camera().map(Self::Orthographic)
                }
                _ => parse(&bytes).map(Self::Pinhole),
            }
        };
        read().map_err(|problem| ImageError::new(path, problem))
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.projection().size()
    }

    fn projection(&self) -> &dyn Projection {
        match self {
            Self::Pinhole(camera) => camera,
            Self::Orthographic(camera) => camera,
        }
    }
}

impl Projection for AnyCamera {
    fn project(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]> {
        self.projection().project(x_camera)
    }

    fn project_undistorted(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]> {
        self.projection().project_undistorted(x_camera)
    }

    fn distort(&self, undistorted: [f64; 2]) -> Option<[f64; 2]> {
        self.projection().distort(undistorted)
    }

    fn viewpoint(&self, camera_from_model: &Pose) -> Viewpoint {
        self.projection().viewpoint(camera_from_model)
    }

    fn focal_lengths(&self) -> [f64; 2] {
        self.projection().focal_lengths()
    }

    fn size(&self) -> [u32; 2] {
        self.projection().size()
    }
}

impl From<Camera> for AnyCamera {
    fn from(camera: Camera) -> Self {
        Self::Pinhole(camera)
    }
}

impl From<OrthographicCamera> for AnyCamera {
    fn from(camera: OrthographicCamera) -> Self {
        Self::Orthographic(camera)
    }
}

impl OrthographicDocument {
    fn camera(self) -> Result<OrthographicCamera, ImageProblem> {
        let Self { scale, origin, width, height } = self;
        OrthographicCamera { scale, origin, width, height }.checked()
    }
}
