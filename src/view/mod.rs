//! What a camera sees: cameras, depth maps, and what lies around an object in them.

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
#[cfg(feature = "overlay")]
mod overlay;
mod projection;
mod rim;
mod table;
mod wireframe;

pub use any_camera::AnyCamera;
pub use camera::Camera;
pub use contour::Contour;
pub use depth_map::DepthMap;
pub use distortion::Distortion;
pub use error::ImageError;
pub use extrinsics::read_camera_from_world;
pub use mask::Mask;
#[cfg(feature = "overlay")]
pub use overlay::Picture;
pub use projection::{OrthographicCamera, Projection, model_in_camera};
pub use rim::{RimError, Viewpoint, orthographic_rim_meridians, orthographic_rim_point, rim};
pub use table::{find_plane, points_above};
pub use wireframe::Wireframe;
