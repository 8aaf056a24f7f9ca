//! Which way a surface faces a camera.

use nalgebra::Vector3;

use crate::math::increasing_root;
use crate::ray::outward_normal;
use crate::shape::LevelSet;
use crate::view::Viewpoint;

/// A surface and where it is seen from, both in one frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Facing<'a, S> {
    pub solid: &'a S,
    pub viewpoint: Viewpoint,
}

impl<S: LevelSet> Facing<'_, S> {
    /// `(x - c) . n(x)` or `v . n(x)` (JLS Eqs. 2.44, 2.45): negative where the surface faces the
    /// camera, 0 on the rim.
    pub fn away(&self, x: &Vector3<f64>) -> f64 {
        let normal = outward_normal(self.solid, x);
        match self.viewpoint {
            Viewpoint::At(centre) => (x - centre).dot(&normal),
            Viewpoint::Along(direction) => direction.dot(&normal),
        }
    }

    /// Where the rim passes a path on the surface, from 0, where it faces the camera, to 1, where it
    /// does not. Where the path passes an edge of which one side faces the camera, that is at the
    /// edge.
    pub fn crossing(&self, path: impl Fn(f64) -> Vector3<f64>) -> f64 {
        increasing_root(|place| self.away(&path(place)), [0.0, 1.0])
    }
}
