//! Point clouds: the structure-of-arrays container and, one file a format, its readers.

mod point_cloud;

pub use point_cloud::PointCloud;
