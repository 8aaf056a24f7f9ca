//! Where a camera stands in the world.

use std::path::Path;

use nalgebra::{Matrix3, Vector3};
use serde::Deserialize;

use super::error::{ImageError, ImageProblem};
use super::image::read_bytes;
use crate::pose::Pose;

/// Most bytes of the document.
const DOCUMENT_BYTES: u64 = 1 << 20;

/// The key that names the frames: the matrix takes what is left of it from what is right.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
struct Document {
    camera_from_world: Option<Vec<[f64; 4]>>,
    world_from_camera: Option<Vec<[f64; 4]>>,
}

/// Reads `camera_from_world`, or its inverse `world_from_camera`, from JSON: a matrix of three or
/// four rows, `[R | t]`, as in a scene's `truth.json`. Gives the former.
///
/// # Errors
/// If the file cannot be read, has not just one of both, or the matrix is no rigid motion.
pub fn read_camera_from_world(path: impl AsRef<Path>) -> Result<Pose, ImageError> {
    let path = path.as_ref();
    let read = || {
        let bytes = read_bytes(path, DOCUMENT_BYTES)?;
        let document = serde_json::from_slice(&bytes).map_err(ImageProblem::Extrinsics)?;
        let Document { camera_from_world, world_from_camera } = document;
        match (camera_from_world, world_from_camera) {
            (Some(rows), None) => motion("camera_from_world", &rows),
            (None, Some(rows)) => Ok(motion("world_from_camera", &rows)?.inverse()),
            _ => Err(ImageProblem::NoExtrinsics),
        }
    };
    read().map_err(|problem| ImageError::new(path, problem))
}

/// The rigid motion of a matrix.
fn motion(key: &'static str, rows: &[[f64; 4]]) -> Result<Pose, ImageProblem> {
    let refuse = |found: String| ImageProblem::Motion { key, found };
    let (first, last) = match rows {
        [first @ .., last] if rows.len() == 4 => (first, *last),
        _ => (rows, [0.0, 0.0, 0.0, 1.0]),
    };
    if first.len() != 3 || last != [0.0, 0.0, 0.0, 1.0] {
        return Err(refuse(format!("{rows:?}")));
    }
    let translation = Vector3::from_fn(|i, _| first[i][3]);
    if !translation.iter().all(|component| component.is_finite()) {
        return Err(refuse(format!("{rows:?}")));
    }
    let rotation = Matrix3::from_fn(|i, j| first[i][j]);
    Pose::from_matrix(rotation, translation).map_err(|error| refuse(error.to_string()))
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;

    fn read(text: &str) -> Result<Pose, ImageError> {
        let mut file = tempfile::NamedTempFile::new().unwrap();
        file.write_all(text.as_bytes()).unwrap();
        read_camera_from_world(file.path())
    }

    #[test]
    fn either_direction_and_three_or_four_rows_will_do() {
        let rows = "[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]";
        let pose = read(&format!("{{\"camera_from_world\": [{rows}], \"other\": 1}}")).unwrap();
        assert_eq!(pose.world_from_model(&Vector3::x()), Vector3::new(5.0, 7.0, 7.0));
        let four = read(&format!("{{\"camera_from_world\": [{rows}, [0, 0, 0, 1]]}}")).unwrap();
        assert_eq!(four, pose);
        let inverse = read(&format!("{{\"world_from_camera\": [{rows}]}}")).unwrap();
        let back = inverse.world_from_model(&Vector3::new(5.0, 7.0, 7.0));
        assert!((back - Vector3::x()).norm() < 1e-15);
    }

    #[test]
    fn what_is_no_motion_is_refused() {
        for (text, expected) in [
            ("{}", "camera_from_world"),
            ("{\"camera_from_world\": [[1, 0, 0, 0]]}", "rows"),
            ("{\"camera_from_world\": [[1, 0], [2]]}", "expected"),
            ("{\"camera_from_world\": [[2,0,0,0],[0,1,0,0],[0,0,1,0]]}", "orthonormal"),
            ("{\"world_from_camera\": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,1]]}", "rows"),
        ] {
            let message = read(text).unwrap_err().to_string();
            assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        }
    }
}
