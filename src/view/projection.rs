//! How a camera's frame becomes an image: central or parallel.

use nalgebra::Vector3;

use super::camera::Camera;
use super::error::ImageProblem;
use super::rim::Viewpoint;
use crate::pose::Pose;

/// A camera, in its own frame: x to the right, y down, z forward.
pub trait Projection {
    /// The pixel `[column, row]` at which a point of the camera's frame is seen; none if it is
    /// not.
    fn project(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]>;

    /// The pixel at which a point would be seen without distortion by the lens.
    fn project_undistorted(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]>;

    /// The pixel at which a lens shows what would be seen at another without it.
    fn distort(&self, undistorted: [f64; 2]) -> Option<[f64; 2]>;

    /// Where it stands or how it looks, in the frame of something at a pose in the camera's frame.
    fn viewpoint(&self, camera_from_model: &Pose) -> Viewpoint;

    /// Pixels to a unit of x and y of the image plane.
    fn focal_lengths(&self) -> [f64; 2];

    /// Columns and rows.
    fn size(&self) -> [u32; 2];
}

impl Projection for Camera {
    fn project(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]> {
        Camera::project(self, x_camera)
    }

    fn project_undistorted(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]> {
        // Written so that NaN is refused too.
        let is_in_front = x_camera.z > 0.0;
        let [x, y] = [x_camera.x / x_camera.z, x_camera.y / x_camera.z];
        is_in_front.then_some([self.cx + self.fx * x, self.cy + self.fy * y])
    }

    fn distort(&self, [column, row]: [f64; 2]) -> Option<[f64; 2]> {
        let ideal = [(column - self.cx) / self.fx, (row - self.cy) / self.fy];
        let [x, y] = self.distortion.distort(ideal)?;
        Some([self.cx + self.fx * x, self.cy + self.fy * y])
    }

    fn viewpoint(&self, camera_from_model: &Pose) -> Viewpoint {
        Viewpoint::At(camera_from_model.model_from_world(&Vector3::zeros()))
    }

    fn focal_lengths(&self) -> [f64; 2] {
        [self.fx, self.fy]
    }

    fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }
}

/// A camera that looks along z everywhere, as if from far away, without distortion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrthographicCamera {
    /// Pixels to a unit of length along rows and columns.
    pub scale: [f64; 2],
    /// Column and row at which the origin is seen.
    pub origin: [f64; 2],
    /// Number of columns.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
}

impl OrthographicCamera {
    /// The camera itself, if its numbers are a camera's.
    pub(crate) fn checked(self) -> Result<Self, ImageProblem> {
        let Self { scale, origin, .. } = &self;
        if !scale.iter().all(|value| value.is_finite() && *value > 0.0) {
            let expected = format!("a scale of two positive numbers, found {scale:?}");
            return Err(ImageProblem::CameraModel(expected));
        }
        if !origin.iter().all(|value| value.is_finite()) {
            let expected = format!("an origin of two finite numbers, found {origin:?}");
            return Err(ImageProblem::CameraModel(expected));
        }
        Ok(self)
    }
}

impl Projection for OrthographicCamera {
    fn project(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]> {
        let [column, row] = self.origin;
        Some([column + self.scale[0] * x_camera.x, row + self.scale[1] * x_camera.y])
    }

    fn project_undistorted(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]> {
        self.project(x_camera)
    }

    fn distort(&self, undistorted: [f64; 2]) -> Option<[f64; 2]> {
        Some(undistorted)
    }

    fn viewpoint(&self, camera_from_model: &Pose) -> Viewpoint {
        Viewpoint::Along(camera_from_model.rotation().inverse_transform_vector(&Vector3::z()))
    }

    fn focal_lengths(&self) -> [f64; 2] {
        self.scale
    }

    fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }
}
