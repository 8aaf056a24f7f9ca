//! What a camera sees: cameras, depth maps, and what lies around an object in them; rim and
//! contour of convex solids.

mod any_camera;
mod camera;
mod camera_file;
mod contour;
mod depth_map;
mod distortion;
mod error;
mod extrinsics;
mod image;
mod mask;
mod projection;
mod rim;
mod table;

pub use any_camera::AnyCamera;
pub use camera::Camera;
pub use contour::Contour;
pub use depth_map::DepthMap;
pub use distortion::Distortion;
pub use error::ImageError;
#[cfg(feature = "overlay")]
pub(crate) use error::ImageProblem;
pub use extrinsics::read_camera_from_world;
#[cfg(feature = "overlay")]
pub(crate) use image::{Pixels, read_png};
pub use mask::Mask;
pub use projection::{OrthographicCamera, Projection};
pub use rim::{RimError, Viewpoint, orthographic_rim_meridians, orthographic_rim_point, rim};
pub use table::{find_plane, points_above};
