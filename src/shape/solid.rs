//! What every solid can be asked.

use nalgebra::{Matrix3, Vector3};

use super::curvature::Curvatures;
use super::mass::MassProperties;

/// A solid in its own frame, bounded by the level 1 of an inside-outside function F.
///
/// Lengths are in the unit of the shape's size. Solids that have no end are clipped: F does not
/// know of the clip, everything else does.
pub trait Solid {
    /// The inside-outside function F: below 1 inside, 1 on the surface, above 1 outside.
    fn inside_outside(&self, x: &Vector3<f64>) -> f64;

    /// Gradient of F, in one over the unit of length: on the surface it points outwards.
    ///
    /// A component along an axis on whose plane of symmetry the point lies is 0, even where F
    /// has an edge there.
    fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64>;

    /// Second derivatives of F. One of them is infinite on a plane across which F has a bend.
    fn inside_outside_hessian(&self, x: &Vector3<f64>) -> Matrix3<f64>;

    /// Curvatures of the level surface of F through a point, the boundary among them; they need no
    /// latitude, and exist on the planes of symmetry too.
    fn curvatures(&self, x: &Vector3<f64>) -> Curvatures {
        let gradient = self.inside_outside_gradient(x);
        Curvatures::of_level_surface(&gradient, &self.inside_outside_hessian(x))
    }

    /// Whether a point is inside, the clip included.
    fn contains(&self, x: &Vector3<f64>) -> bool {
        self.inside_outside(x) < 1.0
    }

    /// Signed distance to the surface along a ray of the family, negative inside: from the
    /// centre, or from the middle of a ring's tube. Infinite where the ray never meets it.
    fn radial_distance(&self, x: &Vector3<f64>) -> f64;

    /// The support function `max { n . x : x in the solid }`, in the unit of length times that
    /// of `n`.
    fn support(&self, n: &Vector3<f64>) -> f64;

    /// The least box along the axes that holds the solid: `[min, max]`.
    fn bounding_box(&self) -> [Vector3<f64>; 2] {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        [
            Vector3::from(axes.map(|axis| -self.support(&-axis))),
            Vector3::from(axes.map(|axis| self.support(&axis))),
        ]
    }

    /// Volume, centroid and second moments of unit density.
    fn mass_properties(&self) -> MassProperties;

    /// The volume.
    fn volume(&self) -> f64 {
        self.mass_properties().volume()
    }

    /// Area of the whole boundary, the caps of a clip included.
    fn surface_area(&self) -> f64;
}
