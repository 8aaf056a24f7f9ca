//! A deformed shape in general position.

use nalgebra::Vector3;

use crate::deform::{Deformed, MassEstimate};
use crate::math::Scalar;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::{LevelSet, Patched, Solid, Superellipsoid};

/// A deformed shape, and where it stands in the world: first deformed, then moved.
#[derive(Debug, Clone, PartialEq)]
pub struct Primitive<S = Superellipsoid> {
    /// The shape and its deformations, in the shape's frame.
    pub deformed: Deformed<S>,
    /// The motion from the shape's frame to the world.
    pub pose: Pose,
}

impl<S: Solid + LevelSet> Primitive<S> {
    /// The inside-outside function F at a point of the world.
    pub fn inside_outside(&self, x_world: &Vector3<f64>) -> f64 {
        self.deformed.inside_outside(&self.pose.model_from_world(x_world))
    }

    /// Whether a point of the world is inside.
    pub fn contains(&self, x_world: &Vector3<f64>) -> bool {
        self.deformed.contains(&self.pose.model_from_world(x_world))
    }

    /// A bound on `n . x` over the solid in the world, as tight as [`Deformed::support`].
    pub fn support(&self, n_world: &Vector3<f64>) -> f64 {
        let n_model = self.pose.rotation().inverse_transform_vector(n_world);
        n_world.dot(self.pose.translation()) + self.deformed.support(&n_model)
    }

    /// A box along the world's axes that holds the solid, `[min, max]`.
    pub fn bounding_box(&self) -> [Vector3<f64>; 2] {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        [
            Vector3::from(axes.map(|axis| -self.support(&-axis))),
            Vector3::from(axes.map(|axis| self.support(&axis))),
        ]
    }
}

impl<S> From<Model<S>> for Primitive<S> {
    fn from(Model { shape, pose }: Model<S>) -> Self {
        Self { deformed: Deformed::plain(shape), pose }
    }
}

impl<S: Copy> Primitive<S> {
    /// The plain model, if nothing deforms it.
    pub fn undeformed(&self) -> Option<Model<S>> {
        let is_plain = self.deformed.chain().stages().is_empty();
        is_plain.then(|| Model { shape: *self.deformed.shape(), pose: self.pose })
    }
}

impl<S: Patched> Primitive<S> {
    /// The masses in the world's frame, to a tolerance as in [`Deformed::mass_estimate`].
    pub fn mass_estimate(&self, tolerance: f64) -> MassEstimate {
        let estimate = self.deformed.mass_estimate(tolerance);
        MassEstimate { properties: estimate.properties.transformed(&self.pose), ..estimate }
    }
}

impl<S: LevelSet> LevelSet for Primitive<S> {
    /// The level at a point of the world.
    fn level<T: Scalar>(&self, x_world: [T; 3]) -> T {
        self.deformed.level(self.pose.model_from_world_of(x_world))
    }
}
