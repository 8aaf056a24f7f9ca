//! What of its own surface a solid hides.

use nalgebra::Vector3;

use crate::deform::Deformed;
use crate::pose::Pose;
use crate::ray::{Hittable, Ray, Target, outward_normal};
use crate::shape::Shape;
use crate::solid::Primitive;
use crate::view::Viewpoint;

/// Share of the solid's size by which a ray passes above the point that it is sent to: where it
/// grazes the surface there, it is not to hit it.
const CLEARANCE: f64 = 1e-6;

/// Sizes of the solid from which a parallel ray comes.
const DISTANCE: f64 = 2.0;

/// A solid and where it is seen from, both in the solid's frame.
pub(super) struct Visibility {
    target: Target<Primitive<Shape>>,
    viewpoint: Viewpoint,
    size: f64,
}

impl Visibility {
    pub fn new(solid: &Deformed<Shape>, viewpoint: Viewpoint) -> Self {
        let primitive = Primitive { deformed: solid.clone(), pose: Pose::identity() };
        let bounds = primitive.bounding_box();
        Self {
            target: Target::new(primitive, bounds),
            viewpoint,
            size: (bounds[1] - bounds[0]).norm(),
        }
    }

    /// Whether the solid is in the way to a point of its surface.
    pub fn is_hidden(&self, x: &Vector3<f64>) -> bool {
        let goal = x + CLEARANCE * self.size * outward_normal(self.target.solid(), x);
        let direction = match self.viewpoint {
            Viewpoint::At(centre) => goal - centre,
            Viewpoint::Along(direction) => DISTANCE * self.size * direction.normalize(),
        };
        let ray = Ray { origin: goal - direction, direction };
        self.target.first_hit(&ray).is_some_and(|hit| hit.t < 1.0)
    }
}
