//! Lines of sight that touch a solid, one in each half-plane that ends at the line from camera to
//! centre.

use std::f64::consts::PI;

use nalgebra::Vector3;

use super::{RimError, Viewpoint};
use crate::shape::Superellipsoid;

/// Halvings of an angle, at most: none is left of the digits of a double after so many.
const HALVINGS: usize = 128;

/// The touching lines of sight of a convex superellipsoid.
///
/// Touching is kept by linear maps, so all is done on the shape of the same exponents and
/// semi-axes 1, whatever the aspect and the unit. In the half-plane at the angle theta around the
/// line from centre to camera the solid is a convex figure, and the point at the angle phi from
/// that line is `d / H(d)` with `d = cos(phi) towards + sin(phi) side(theta)`. Its normal is the
/// gauge's gradient g, with `g . x = 1`, and so
///
/// `(x - c) . n = 0`  becomes  `g(d) . towards = 1 / |c|`, 0 for an orthographic camera.
///
/// The left side falls from its greatest value at phi = 0 to its least at pi, because g goes around
/// the convex polar figure (B81's dual): there is one solution, and bisection finds it to rounding.
#[derive(Debug, Clone)]
pub(in crate::view) struct Tangents {
    /// Of semi-axes 1.
    unit_shape: Superellipsoid,
    size: Vector3<f64>,
    /// Direction to the camera.
    towards: Vector3<f64>,
    sides: [Vector3<f64>; 2],
    /// `1 / |c|`; 0 for an orthographic camera.
    nearness: f64,
}

impl Tangents {
    /// The lines of sight to a superellipsoid, in its own frame.
    ///
    /// # Errors
    /// If the solid is not convex or the camera not outside it.
    pub fn new(shape: &Superellipsoid, viewpoint: &Viewpoint) -> Result<Self, RimError> {
        if let Some(exponent) = shape.exponents().into_iter().find(|e| *e > 2.0) {
            return Err(RimError::NotConvex(exponent));
        }
        let size = Vector3::from(shape.size());
        let unit_shape = shape.with_size([1.0; 3]);
        let (to_camera, is_near) = match viewpoint {
            Viewpoint::At(centre) => (centre.component_div(&size), true),
            Viewpoint::Along(direction) => (-direction.component_div(&size), false),
        };
        // Scaled first: no length may be too great or small to be squared.
        let greatest = to_camera.amax();
        let is_finite = to_camera.iter().all(|component| component.is_finite());
        if !is_finite || (greatest == 0.0 && !is_near) {
            return Err(RimError::Viewpoint);
        }
        if is_near && unit_shape.gauge(&to_camera) <= 1.0 {
            return Err(RimError::Inside);
        }
        let towards = (to_camera / greatest).normalize();
        let nearness =
            if is_near { towards.dot(&(to_camera / greatest)).recip() / greatest } else { 0.0 };
        let first = towards.cross(&Vector3::ith(towards.iamin(), 1.0)).normalize();
        Ok(Self { unit_shape, size, towards, sides: [first, towards.cross(&first)], nearness })
    }

    /// The touching line of sight in the half-plane at an angle in radians.
    pub fn touch(&self, theta: f64) -> Touch {
        let (sin_theta, cos_theta) = theta.sin_cos();
        let side = cos_theta * self.sides[0] + sin_theta * self.sides[1];
        let direction = |phi: f64| phi.cos() * self.towards + phi.sin() * side;
        let gradient = |phi: f64| self.unit_shape.gauge_gradient(&direction(phi));
        // How far the surface faces the camera.
        let facing = |gradient: &Vector3<f64>| gradient.dot(&self.towards) - self.nearness;
        let (mut low, mut high) = (0.0, PI);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if facing(&gradient(middle)) > 0.0 { low = middle } else { high = middle }
        }
        // Where the surface is all but an edge, no digit of phi is left to tell the normals of its
        // two sides apart: the one between them whose plane holds the line of sight is it.
        let (before, behind) = (gradient(low), gradient(high));
        let (facing_before, facing_behind) = (facing(&before), facing(&behind));
        let fall = facing_before - facing_behind;
        let share = if fall > 0.0 { (facing_before / fall).clamp(0.0, 1.0) } else { 0.0 };
        Touch {
            point: self.unit_shape.radial_projection(&direction(high)).component_mul(&self.size),
            normal: before.lerp(&behind, share).component_div(&self.size),
        }
    }

    /// The point of the rim in the half-plane at an angle in radians.
    pub fn point(&self, theta: f64) -> Vector3<f64> {
        self.touch(theta).point
    }
}

/// Where a line of sight touches a solid.
#[derive(Debug, Clone, Copy)]
pub(in crate::view) struct Touch {
    pub point: Vector3<f64>,
    /// The normal of a plane that touches the solid there and holds the line of sight.
    pub normal: Vector3<f64>,
}
