//! What can go wrong with images and cameras, told so that the file can be mended.

use std::io;
use std::path::{Path, PathBuf};

/// An image or a camera that could not be read: the file and what is wrong with it.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", file.display())]
pub struct ImageError {
    file: PathBuf,
    problem: Box<ImageProblem>,
}

impl ImageError {
    pub(crate) fn new(file: &Path, problem: ImageProblem) -> Self {
        Self { file: file.to_owned(), problem: Box::new(problem) }
    }

    /// The kind of failure, where the system could not open or read the file.
    pub fn io_kind(&self) -> Option<io::ErrorKind> {
        match &*self.problem {
            ImageProblem::Io(error) => Some(error.kind()),
            _ => None,
        }
    }
}

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
pub(crate) enum ImageProblem {
    #[error("{0}")]
    Io(#[from] io::Error),
    #[error("longer than {0} bytes: not the file of a camera")]
    TooLong(u64),
    #[error("expected a camera: {0}")]
    Camera(serde_json::Error),
    #[error("expected a camera in JSON or YAML: {0}")]
    CameraYaml(String),
    #[error("expected {0}")]
    CameraModel(String),
    #[error("expected the JSON of a camera's pose: {0}")]
    Extrinsics(serde_json::Error),
    #[error("expected either camera_from_world or world_from_camera")]
    NoExtrinsics,
    #[error("{key}: expected 3 or 4 rows [R | t] of a rigid motion, found {found}")]
    Motion { key: &'static str, found: String },
    #[error("expected a {}{key}, found {value}", if matches!(*key, "cx" | "cy") { "finite " } else { "positive " })]
    CameraNumber { key: &'static str, value: f64 },
    #[error("expected a PNG image: {0}")]
    Png(#[from] png::DecodingError),
    #[error("has {found} pixels; at most {most} are read")]
    TooLarge { found: u64, most: u64 },
    #[error("expected {size:?} pixels as in its header, found only {file_bytes} bytes in all")]
    CutShort { size: [u32; 2], file_bytes: u64 },
    #[error("expected a depth map of 16 bits a pixel and one channel, found {0}")]
    NotDepth(String),
    #[error("expected {expected:?} pixels as in {of}, found {found:?}")]
    Size { expected: [u32; 2], found: [u32; 2], of: &'static str },
    #[error(
        "the camera's file has no depth_units_m: say how many metres a count of the depth map is"
    )]
    NoDepthUnit,
    #[error("no pixel of the object has a depth")]
    NoObject,
}
