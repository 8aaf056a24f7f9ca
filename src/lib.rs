//! Superquadrics: recovery from range points, and their geometry.

pub mod cloud;
