//! Recovery of a shape from points.

mod radial;
