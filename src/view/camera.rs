//! Pinhole cameras.

use std::path::Path;

use nalgebra::Vector3;
use serde::Deserialize;

use super::camera_file;
use super::distortion::Distortion;
use super::error::{ImageError, ImageProblem};

/// Most bytes of a camera's document.
pub(super) const DOCUMENT_BYTES: u64 = 1 << 20;

/// A pinhole camera with a lens: x to the right, y down, z forward, as in OpenCV; the centre of
/// the pixel in column i and row j is (i, j).
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Camera {
    /// Focal length along rows, in pixels.
    pub fx: f64,
    /// Focal length along columns, in pixels.
    pub fy: f64,
    /// Column of the principal point.
    pub cx: f64,
    /// Row of the principal point.
    pub cy: f64,
    /// Number of columns.
    pub width: u32,
    /// Number of rows.
    pub height: u32,
    /// Metres to one count of a depth map, where the camera's document says so.
    #[serde(rename = "depth_units_m")]
    pub depth_unit: Option<f64>,
    /// Distortion by the lens; in JSON OpenCV's coefficients as a list.
    #[serde(default)]
    pub distortion: Distortion,
}

impl Camera {
    /// Reads a camera from OpenCV's or ROS's calibration in YAML, ROS's `camera_info`, or JSON, `{"fx": .., "fy": .., "cx": .., "cy": .., "width": .., "height":
    /// .., "depth_units_m": .., "distortion": [k1, k2, p1, p2, ..]}`, the last two of which may be
    /// missing; other keys are left alone.
    ///
    /// # Errors
    /// If the file cannot be read, is not such a document, or holds numbers that no camera has.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ImageError> {
        let path = path.as_ref();
        let read = || {
            let bytes = super::image::read_bytes(path, DOCUMENT_BYTES)?;
            camera_file::parse(&bytes)
        };
        read().map_err(|problem| ImageError::new(path, problem))
    }

    /// The camera itself, if its numbers are a camera's.
    pub(crate) fn checked(self) -> Result<Self, ImageProblem> {
        let refuse = |key, value: f64| Err(ImageProblem::CameraNumber { key, value });
        for (key, value) in [("fx", self.fx), ("fy", self.fy)] {
            if !(value.is_finite() && value > 0.0) {
                return refuse(key, value);
            }
        }
        for (key, value) in [("cx", self.cx), ("cy", self.cy)] {
            if !value.is_finite() {
                return refuse(key, value);
            }
        }
        match self.depth_unit {
            Some(unit) if !(unit.is_finite() && unit > 0.0) => refuse("depth_units_m", unit),
            _ => Ok(self),
        }
    }

    /// Direction of a pixel's ray in the camera's frame, z being 1: along it the depth is the
    /// parameter. None where distortion lets no ray through.
    pub fn ray(&self, column: f64, row: f64) -> Option<[f64; 3]> {
        let seen = [(column - self.cx) / self.fx, (row - self.cy) / self.fy];
        self.distortion.undistort(seen).map(|[x, y]| [x, y, 1.0])
    }

    /// The pixel `[column, row]` at which a point of the camera's frame is seen, which may lie
    /// beside the image; none behind the camera and where distortion lets no ray through.
    pub fn project(&self, x_camera: &Vector3<f64>) -> Option<[f64; 2]> {
        // Written so that NaN is refused too.
        let is_in_front = x_camera.z > 0.0;
        let seen = [x_camera.x / x_camera.z, x_camera.y / x_camera.z];
        let [x, y] = self.distortion.distort(seen).filter(|_| is_in_front)?;
        Some([self.cx + self.fx * x, self.cy + self.fy * y])
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;

    fn read(text: &str) -> Result<Camera, ImageError> {
        let mut file = tempfile::NamedTempFile::new().unwrap();
        file.write_all(text.as_bytes()).unwrap();
        Camera::read(file.path())
    }

    #[test]
    fn a_camera_with_and_without_a_depth_unit() {
        let text = r#"{"fx": 600, "fy": 610.5, "cx": 319.5, "cy": 239.5, "width": 640,
            "height": 480, "depth_units_m": 0.0001, "note": "left alone"}"#;
        let camera = read(text).unwrap();
        assert_eq!(camera.depth_unit, Some(1e-4));
        assert_eq!(camera.ray(319.5, 239.5 + 610.5), Some([0.0, 1.0, 1.0]));
        let without = text.replace(r#""depth_units_m": 0.0001,"#, "");
        assert_eq!(read(&without).unwrap().depth_unit, None);
    }

    #[test]
    fn a_point_is_seen_where_its_ray_goes_through() {
        let text = r#"{"fx": 600, "fy": 610.5, "cx": 319.5, "cy": 239.5, "width": 640,
            "height": 480, "distortion": [-0.28, 0.07, 1e-3, -5e-4]}"#;
        let camera = read(text).unwrap();
        for [column, row] in [[0.0, 0.0], [319.5, 239.5], [639.0, 12.25]] {
            let ray = Vector3::from(camera.ray(column, row).unwrap());
            let [u, v] = camera.project(&(3e-6 * ray)).unwrap();
            assert!((u - column).hypot(v - row) < 1e-8, "{u} {v}");
        }
        assert_eq!(camera.project(&Vector3::new(0.0, 0.0, -1.0)), None);
        assert_eq!(camera.project(&Vector3::zeros()), None);
    }

    #[test]
    fn what_is_no_camera_is_refused_by_its_key() {
        let text = r#"{"fx": 0, "fy": 1, "cx": 0, "cy": 0, "width": 2, "height": 2}"#;
        let message = read(text).unwrap_err().to_string();
        assert!(message.ends_with("expected a positive fx, found 0"), "{message}");
        let message = read("{\"fx\": 1}").unwrap_err().to_string();
        assert!(message.contains("missing field `fy`"), "{message}");
        let bent = text.replace("\"fx\": 0", "\"fx\": 1, \"distortion\": [1, 2]");
        assert!(read(&bent).unwrap_err().to_string().contains("k1 k2 p1 p2"));
        let unit = text.replace("\"fx\": 0", "\"fx\": 1, \"depth_units_m\": -1");
        assert!(read(&unit).unwrap_err().to_string().contains("depth_units_m"));
    }
}
