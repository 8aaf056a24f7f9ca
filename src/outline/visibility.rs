//! What solids hide of their surfaces.

use nalgebra::Vector3;

use crate::ray::{Hittable, Ray, SolidTarget};
use crate::solid::Tree;
use crate::view::Viewpoint;

/// Share of the solid's size by which a ray passes above the point that it is sent to: where it
/// grazes the surface there, it is not to hit it.
const CLEARANCE: f64 = 1e-6;

/// Sizes of the solid from which a parallel ray comes.
const DISTANCE: f64 = 2.0;

/// A solid and where it is seen from.
pub(super) struct Visibility {
    target: SolidTarget,
    viewpoint: Viewpoint,
    middle: Vector3<f64>,
    size: f64,
}

impl Visibility {
    /// A solid, and a box `[min, max]` that holds it.
    pub fn new(solid: &Tree, [min, max]: [Vector3<f64>; 2], viewpoint: Viewpoint) -> Self {
        let (middle, size) = (0.5 * (min + max), (max - min).norm());
        Self { target: SolidTarget::new(solid), viewpoint, middle, size }
    }

    /// Whether a ray meets the solid, from its origin on; a parallel one from before the solid.
    pub fn is_hit(&self, ray: &Ray) -> bool {
        let Ray { mut origin, direction } = *ray;
        if let Viewpoint::Along(_) = self.viewpoint {
            let length = direction.norm();
            let to_middle = (self.middle - origin).dot(&direction) / length;
            origin += (to_middle - DISTANCE * self.size) / length * direction;
        }
        self.target.first_hit(&Ray { origin, direction }).is_some()
    }

    /// Whether the solid is in the way to a point of its surface, of which the outward normal is
    /// given.
    pub fn is_hidden(&self, x: &Vector3<f64>, normal: &Vector3<f64>) -> bool {
        let goal = x + CLEARANCE * self.size * normal;
        let direction = match self.viewpoint {
            Viewpoint::At(centre) => goal - centre,
            Viewpoint::Along(direction) => DISTANCE * self.size * direction.normalize(),
        };
        let ray = Ray { origin: goal - direction, direction };
        self.target.first_hit(&ray).is_some_and(|hit| hit.t < 1.0)
    }
}
