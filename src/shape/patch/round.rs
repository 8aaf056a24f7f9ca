//! Patches of shapes that are products of superellipses, or nearly so: their octants.

use nalgebra::Vector3;

use super::{Patch, Patched, SurfaceElement, octants};
use crate::shape::arc::{ArcNode, arc_node, greatest_arc_parameter};
use crate::shape::{Superellipsoid, Supertoroid, ThreeExponent, area_element};

/// The range of the parameter of a quarter of a superellipse.
fn arc_range(e: f64) -> [f64; 2] {
    let last = greatest_arc_parameter(e);
    [-last, last]
}

/// The products of two semi-axes each.
fn faces([a1, a2, a3]: &[f64; 3]) -> [f64; 3] {
    [a2 * a3, a1 * a3, a1 * a2]
}

impl Patched for Superellipsoid {
    /// The octants, over the parameters of the meridian and of the equator.
    fn patches(&self) -> Vec<Patch<'_>> {
        let (size, [e1, e2]) = (self.size(), self.exponents());
        let element = move |s: f64, t: f64| {
            let (meridian, equator) = (arc_node(e1, s), arc_node(e2, t));
            let ([radius, height], [x, y]) = (meridian.point, equator.point);
            let position = Vector3::new(radius * x, radius * y, height);
            SurfaceElement {
                position: position.component_mul(&Vector3::from(size)),
                area: area_element(&faces(&size), &meridian, &equator),
            }
        };
        let ranges = [arc_range(e1), arc_range(e2)];
        let octant = |signs| Patch::new(ranges, move |s, t| element(s, t).mirrored(&signs));
        octants().map(octant).collect()
    }
}

impl Patched for Supertoroid {
    /// The octants of the outer and of the inner half, over the parameters of tube and ring.
    fn patches(&self) -> Vec<Patch<'_>> {
        let (size, [e1, e2], ring) = (self.size(), self.exponents(), self.ring());
        let ranges = [arc_range(e1), arc_range(e2)];
        let half = |outwards: f64| {
            let element = move |s: f64, t: f64| {
                let (tube, around) = (arc_node(e1, s), arc_node(e2, t));
                tube_element(&size, [ring, outwards], &tube, &around)
            };
            octants()
                .map(move |signs| Patch::new(ranges, move |s, t| element(s, t).mirrored(&signs)))
        };
        half(1.0).chain(half(-1.0)).collect()
    }
}

/// An element of a torus in the octant of positive coordinates, on the half of its tube that
/// faces outwards (1) or inwards (-1).
fn tube_element(
    size: &[f64; 3],
    [ring, outwards]: [f64; 2],
    tube: &ArcNode,
    around: &ArcNode,
) -> SurfaceElement {
    let ([across, up], [radial, axial]) = (tube.point, tube.shares);
    let ([x, y], [share_x, share_y]) = (around.point, around.shares);
    let radius = ring + outwards * across;
    let position = Vector3::new(radius * x, radius * y, up);
    let upright = outwards * up * radial * radius;
    let projections =
        Vector3::new(upright * y * share_x, upright * x * share_y, across * axial * radius * x * y);
    SurfaceElement {
        position: position.component_mul(&Vector3::from(*size)),
        area: tube.weight * around.weight * projections.component_mul(&Vector3::from(faces(size))),
    }
}

impl Patched for ThreeExponent {
    /// The octants, over the log-odds of `|x/a1|^n1` against `|y/a2|^n2` and of both against
    /// `|z/a3|^n3`.
    fn patches(&self) -> Vec<Patch<'_>> {
        let e = 2.0 * self.least_order();
        let element = move |s: f64, t: f64| self.element(&arc_node(e, s), &arc_node(e, t));
        let octant =
            |signs| Patch::new([arc_range(e); 2], move |s, t| element(s, t).mirrored(&signs));
        octants().map(octant).collect()
    }
}
