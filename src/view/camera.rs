//! Pinhole cameras.

use std::path::Path;

use serde::Deserialize;

use super::error::{ImageError, ImageProblem};

/// Most bytes of a camera's document.
const DOCUMENT_BYTES: u64 = 1 << 20;

/// A pinhole camera without distortion: x to the right, y down, z forward, as in OpenCV; the
/// centre of the pixel in column i and row j is (i, j).
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
}

impl Camera {
    /// Reads a camera from JSON, `{"fx": .., "fy": .., "cx": .., "cy": .., "width": .., "height":
    /// .., "depth_units_m": ..}`; other keys are left alone.
    ///
    /// # Errors
    /// If the file cannot be read, is not such a document, or holds numbers that no camera has.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ImageError> {
        let path = path.as_ref();
        let read = || {
            let bytes = super::image::read_bytes(path, DOCUMENT_BYTES)?;
            let camera: Self = serde_json::from_slice(&bytes).map_err(ImageProblem::Camera)?;
            camera.checked()
        };
        read().map_err(|problem| ImageError::new(path, problem))
    }

    fn checked(self) -> Result<Self, ImageProblem> {
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
    /// parameter.
    pub fn ray(&self, column: f64, row: f64) -> [f64; 3] {
        [(column - self.cx) / self.fx, (row - self.cy) / self.fy, 1.0]
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
        assert_eq!(camera.ray(319.5, 239.5 + 610.5), [0.0, 1.0, 1.0]);
        let without = text.replace(r#""depth_units_m": 0.0001,"#, "");
        assert_eq!(read(&without).unwrap().depth_unit, None);
    }

    #[test]
    fn what_is_no_camera_is_refused_by_its_key() {
        let text = r#"{"fx": 0, "fy": 1, "cx": 0, "cy": 0, "width": 2, "height": 2}"#;
        let message = read(text).unwrap_err().to_string();
        assert!(message.ends_with("expected a positive fx, found 0"), "{message}");
        let message = read("{\"fx\": 1}").unwrap_err().to_string();
        assert!(message.contains("missing field `fy`"), "{message}");
        let unit = text.replace("\"fx\": 0", "\"fx\": 1, \"depth_units_m\": -1");
        assert!(read(&unit).unwrap_err().to_string().contains("depth_units_m"));
    }
}
