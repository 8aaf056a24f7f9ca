//! Surfaces as patches over rectangles, over which integrals converge fast.

mod clipped;
mod round;

use nalgebra::Vector3;

use super::family::Shape;

/// A part of a closed surface over a rectangle of two parameters, throughout which its elements
/// are smooth but for the shape's own edges; towards the rectangle's sides they vanish or are
/// smooth, too.
pub struct Patch<'a> {
    ranges: [[f64; 2]; 2],
    element: Box<dyn Fn(f64, f64) -> SurfaceElement + Send + Sync + 'a>,
}

/// An element of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceElement {
    /// Where it is, in the shape's frame.
    pub position: Vector3<f64>,
    /// Its area along the outward normal, to a unit of both parameters.
    pub area: Vector3<f64>,
}

/// A shape whose whole boundary, the caps of a clip included, is known as patches.
pub trait Patched: Sync {
    /// The patches. They share no more than their sides.
    fn patches(&self) -> Vec<Patch<'_>>;
}

impl<'a> Patch<'a> {
    fn new(
        ranges: [[f64; 2]; 2],
        element: impl Fn(f64, f64) -> SurfaceElement + Send + Sync + 'a,
    ) -> Self {
        Self { ranges, element: Box::new(element) }
    }

    /// The ranges of both parameters.
    pub fn ranges(&self) -> [[f64; 2]; 2] {
        self.ranges
    }

    /// The element at a pair of parameters.
    pub fn element(&self, s: f64, t: f64) -> SurfaceElement {
        (self.element)(s, t)
    }
}

impl SurfaceElement {
    /// The element mirrored at the planes of symmetry across which a sign is negative.
    fn mirrored(self, signs: &Vector3<f64>) -> Self {
        Self { position: self.position.component_mul(signs), area: self.area.component_mul(signs) }
    }
}

/// The eight triples of signs.
fn octants() -> impl Iterator<Item = Vector3<f64>> {
    (0..8).map(|octant| Vector3::from_fn(|i, _| if octant >> i & 1 == 0 { 1.0 } else { -1.0 }))
}

impl Patched for Shape {
    fn patches(&self) -> Vec<Patch<'_>> {
        match self {
            Self::Superellipsoid(shape) => shape.patches(),
            Self::SuperhyperboloidOneSheet(shape) => shape.patches(),
            Self::SuperhyperboloidTwoSheets(shape) => shape.patches(),
            Self::Supertoroid(shape) => shape.patches(),
            Self::ThreeExponent(shape) => shape.patches(),
        }
    }
}
