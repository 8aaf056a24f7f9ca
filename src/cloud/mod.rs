//! Point clouds: the structure-of-arrays container and, one file a format, its readers.

mod error;
mod inliers;
mod input;
mod npy;
mod number;
mod pcd;
mod ply;
mod point_cloud;
mod point_rows;
mod points;
mod read;
mod records;
mod scalar;
mod text;
mod text_rows;

pub use error::{Place, Problem, ReadError};
pub use inliers::write_inliers;
pub use point_cloud::{PointCloud, PointColumns};
pub use point_rows::PointRows;
pub use read::{read, read_rows, read_stream};
