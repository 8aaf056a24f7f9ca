//! Cameras in the files of others: our JSON, OpenCV's YAML, and ROS's `camera_info`.

use std::borrow::Cow;

use serde::Deserialize;
use serde_json::Value;

use super::camera::Camera;
use super::distortion::Distortion;
use super::error::ImageProblem;

/// Distortion models that are Brown's and Conrady's; an empty name is none at all.
const MODELS: [&str; 4] = ["plumb_bob", "rational_polynomial", "none", ""];

/// The camera in a document of any of the formats.
pub(super) fn parse(bytes: &[u8]) -> Result<Camera, ImageProblem> {
    let document = parse_values(bytes)?;
    let camera = if document.get("camera_matrix").is_some() {
        value_as::<Calibration>(document)?.camera()
    } else if document.get("K").or_else(|| document.get("k")).is_some() {
        value_as::<CameraInfo>(document)?.camera()
    } else {
        Ok(value_as::<Camera>(document)?)
    };
    camera.map_err(ImageProblem::CameraModel)?.checked()
}

/// The values of a JSON or YAML document.
pub(super) fn parse_values(bytes: &[u8]) -> Result<Value, ImageProblem> {
    let text = std::str::from_utf8(bytes)
        .map_err(|_| ImageProblem::CameraModel("text in UTF-8, found other bytes".to_owned()))?;
    if text.trim_start().starts_with('{') {
        return serde_json::from_str(text).map_err(ImageProblem::Camera);
    }
    let text = without_opencvs_dialect(text);
    serde_saphyr::from_str(&text).map_err(|error| {
        let message = error.without_snippet().to_string();
        ImageProblem::CameraYaml(message)
    })
}

/// The first document of a YAML text, without what OpenCV writes and YAML does not know: a colon in
/// the version, and tags of types that are not declared.
fn without_opencvs_dialect(text: &str) -> Cow<'_, str> {
    let lines = text.lines().skip_while(|line| line.starts_with('%') || line.trim() == "---");
    let lines = lines.take_while(|line| !matches!(line.trim_end(), "---" | "..."));
    lines.map(|line| line.replace("!!opencv-matrix", "")).collect::<Vec<_>>().join("\n").into()
}

pub(super) fn value_as<T: for<'a> Deserialize<'a>>(value: Value) -> Result<T, ImageProblem> {
    serde_json::from_value(value).map_err(ImageProblem::Camera)
}

/// What OpenCV's and ROS's calibration programs write.
#[derive(Deserialize)]
struct Calibration {
    image_width: u32,
    image_height: u32,
    camera_matrix: Matrix,
    #[serde(default)]
    distortion_model: String,
    distortion_coefficients: Option<Matrix>,
}

#[derive(Deserialize)]
struct Matrix {
    data: Vec<f64>,
}

impl Calibration {
    fn camera(self) -> Result<Camera, String> {
        let coefficients = self.distortion_coefficients.map(|matrix| matrix.data);
        camera(
            [self.image_width, self.image_height],
            &self.camera_matrix.data,
            &self.distortion_model,
            &coefficients.unwrap_or_default(),
        )
    }
}

/// ROS's message `sensor_msgs/CameraInfo`, in version 1 with upper and in 2 with lower case.
#[derive(Deserialize)]
struct CameraInfo {
    width: u32,
    height: u32,
    #[serde(default)]
    distortion_model: String,
    #[serde(default, rename = "D", alias = "d")]
    coefficients: Vec<f64>,
    #[serde(rename = "K", alias = "k")]
    matrix: Vec<f64>,
}

impl CameraInfo {
    fn camera(self) -> Result<Camera, String> {
        let size = [self.width, self.height];
        camera(size, &self.matrix, &self.distortion_model, &self.coefficients)
    }
}

/// The camera of a matrix of three rows, `fx 0 cx, 0 fy cy, 0 0 1`.
fn camera(
    [width, height]: [u32; 2],
    matrix: &[f64],
    model: &str,
    coefficients: &[f64],
) -> Result<Camera, String> {
    let expected = "a camera matrix fx 0 cx, 0 fy cy, 0 0 1";
    let Ok([fx, skew, cx, below_fx, fy, cy, a, b, c]) = <[f64; 9]>::try_from(matrix) else {
        return Err(format!("{expected}, found {} numbers", matrix.len()));
    };
    if [skew, below_fx, a, b, c] != [0.0, 0.0, 0.0, 0.0, 1.0] {
        return Err(format!("{expected}, found {matrix:?}"));
    }
    if !MODELS.contains(&model) {
        return Err(format!("distortion model plumb_bob or rational_polynomial, found {model}"));
    }
    let distortion = Distortion::new(coefficients)?;
    Ok(Camera { fx, fy, cx, cy, width, height, depth_unit: None, distortion })
}

#[cfg(test)]
mod tests {
    use super::*;

    const OPENCV: &str = "%YAML:1.0
---
calibration_time: \"Thu Nov 26 2026\"
image_width: 640
image_height: 480
board_width: 9
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 5.3591573396163199e+02, 0., 3.4228315473308373e+02, 0.,
       5.3591573396163199e+02, 2.3557082909788173e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -2.6637260909660682e-01, -3.8588898922304653e-02,
       1.7831947042852964e-03, -2.8122100441115472e-04,
       2.3839153080878486e-01 ]
";

    const CALIBRATION: &str = "image_width: 640
image_height: 480
camera_name: head_camera
camera_matrix:
  rows: 3
  cols: 3
  data: [535.5, 0, 342.25, 0, 536.5, 235.5, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.25, 0.5, 0.125, -0.0625, 0]
";

    const CAMERA_INFO: &str = "header:
  seq: 3
  stamp: {secs: 1, nsecs: 2}
  frame_id: camera
height: 480
width: 640
distortion_model: \"plumb_bob\"
D: [-0.25, 0.5, 0.125, -0.0625, 0.0]
K: [535.5, 0.0, 342.25, 0.0, 536.5, 235.5, 0.0, 0.0, 1.0]
R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
---
height: 1
";

    const JSON: &str = r#"{"fx": 535.5, "fy": 536.5, "cx": 342.25, "cy": 235.5, "width": 640,
        "height": 480, "distortion": [-0.25, 0.5, 0.125, -0.0625]}"#;

    fn refusal(text: &str) -> String {
        parse(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn one_camera_in_all_formats() {
        let camera = parse(JSON.as_bytes()).unwrap();
        assert_eq!(parse(CALIBRATION.as_bytes()).unwrap(), camera);
        assert_eq!(parse(CAMERA_INFO.as_bytes()).unwrap(), camera);
        let lower = CAMERA_INFO.replace("D: ", "d: ").replace("K: ", "k: ");
        assert_eq!(parse(lower.as_bytes()).unwrap(), camera);
        let of_opencv = parse(OPENCV.as_bytes()).unwrap();
        assert_eq!((of_opencv.fx, of_opencv.cy), (535.915733961632, 235.57082909788173));
        assert_eq!(of_opencv.distortion.coefficients()[4], 0.23839153080878486);
    }

    #[test]
    fn what_is_not_modelled_or_not_a_camera_is_refused() {
        for (text, expected) in [
            (CALIBRATION.replace("plumb_bob", "equidistant"), "found equidistant"),
            (CALIBRATION.replace("535.5, 0,", "535.5, 1.5,"), "fx 0 cx"),
            (CALIBRATION.replace("535.5, 0,", ""), "found 7 numbers"),
            (CALIBRATION.replace("image_height: 480\n", ""), "image_height"),
            (CALIBRATION.replace("0.125, -0.0625, 0]", "0.125]"), "found 3 numbers"),
            (CALIBRATION.replace("535.5", "-535.5"), "positive fx"),
            (CAMERA_INFO.replace("K: [535.5", "K: [x"), "expected f64"),
            ("a: [1, 2".to_owned(), "line 1"),
            ("- 1\n- 2\n".to_owned(), "camera"),
            (String::new(), "camera"),
            ("{\"fx\": 1,\n".to_owned(), "line 2"),
        ] {
            let message = refusal(&text);
            assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        }
    }

    #[test]
    fn damaged_files_are_read_or_refused() {
        for text in [OPENCV, CALIBRATION, CAMERA_INFO, JSON] {
            for length in 0..text.len() {
                let _ = parse(&text.as_bytes()[..length]);
                for byte in [b'\n', b':', b'&', b'*', b'[', b'9', 0xff] {
                    let mut damaged = text.as_bytes().to_vec();
                    damaged[length] = byte;
                    let _ = parse(&damaged);
                }
            }
        }
    }

    #[test]
    fn aliases_that_multiply_are_refused() {
        let mut bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n".to_owned();
        for i in 1..12 {
            let many = vec![format!("*a{}", i - 1); 10].join(", ");
            bomb += &format!("a{i}: &a{i} [{many}]\n");
        }
        refusal(&bomb);
    }
}
