//! What a camera sees: cameras, depth maps, and what lies around an object in them.

mod camera;
mod depth_map;
mod distortion;
mod error;
mod image;
mod mask;
mod table;

pub use camera::Camera;
pub use depth_map::DepthMap;
pub use distortion::Distortion;
pub use error::ImageError;
pub use mask::Mask;
pub use table::{find_plane, points_above};
