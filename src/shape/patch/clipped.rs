//! Patches of shapes that are clipped: their walls, and the caps.

use nalgebra::Vector3;

use super::{Patch, Patched, SurfaceElement, octants};
use crate::math::{DOUBLE_EXPONENTIAL, double_exponential};
use crate::shape::arc::{arc_node, greatest_arc_parameter};
use crate::shape::{SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets};

impl Patched for SuperhyperboloidOneSheet {
    /// The octants of the wall, below and above the height at which it bends most, and of the
    /// caps; over heights or radii and the parameter of the equator.
    fn patches(&self) -> Vec<Patch<'_>> {
        let last = greatest_arc_parameter(self.exponents()[1]);
        let around = [-last, last];
        let middle = self.top().min(1.0);
        let mut patches = Vec::new();
        for signs in octants() {
            for heights in [[0.0, middle], [middle, self.top()]] {
                let element = move |s: f64, t: f64| {
                    let (w, scale) = double_exponential(s, heights);
                    self.wall_element(w, scale, t).mirrored(&signs)
                };
                patches.push(Patch::new([DOUBLE_EXPONENTIAL, around], element));
            }
            let radii = [0.0, self.radius(self.top())];
            let element = move |s: f64, t: f64| self.cap_element(s, t).mirrored(&signs);
            patches.push(Patch::new([radii, around], element));
        }
        patches
    }
}

impl SuperhyperboloidOneSheet {
    /// The wall at the height `w a3`, to `1 / scale` of a unit of w.
    fn wall_element(&self, w: f64, scale: f64, t: f64) -> SurfaceElement {
        let [a1, a2, a3] = self.size();
        let [e1, e2] = self.exponents();
        let equator = arc_node(e2, t);
        let ([x, y], [share_x, share_y]) = (equator.point, equator.shares);
        let radius = self.radius(w);
        let slope = (w / radius).powf(2.0 / e1 - 1.0);
        let faces =
            Vector3::new(a2 * a3 * y * share_x, a1 * a3 * x * share_y, -a1 * a2 * slope * x * y);
        // Where it ends, a slope without bound counts for nothing.
        let weight = if scale == 0.0 { 0.0 } else { equator.weight * scale * radius };
        SurfaceElement {
            position: Vector3::new(a1 * radius * x, a2 * radius * y, a3 * w),
            area: if weight == 0.0 { Vector3::zeros() } else { weight * faces },
        }
    }

    /// The cap at so many waists from the axis.
    fn cap_element(&self, radius: f64, t: f64) -> SurfaceElement {
        let [a1, a2, _] = self.size();
        let equator = arc_node(self.exponents()[1], t);
        let [x, y] = equator.point;
        SurfaceElement {
            position: Vector3::new(a1 * radius * x, a2 * radius * y, self.clip()),
            area: Vector3::new(0.0, 0.0, equator.weight * a1 * a2 * radius * x * y),
        }
    }
}

impl Patched for SuperhyperboloidTwoSheets {
    /// The octants of bowls and caps, over `w = |z| / a3` and `v = |y| / a2`, in pieces between
    /// which the bowl bends most.
    fn patches(&self) -> Vec<Patch<'_>> {
        let cuts = self.cuts_of_w();
        let mut patches = Vec::new();
        for signs in octants() {
            for heights in cuts.windows(2).map(|cut| [cut[0], cut[1]]) {
                for is_beyond_waist in [false, true] {
                    for is_cap in [false, true] {
                        let element = move |s: f64, t: f64| {
                            let (w, scale_w) = double_exponential(s, heights);
                            let waist = self.waist(w).min(self.greatest_v(w));
                            let widths = match is_beyond_waist {
                                true => [waist, self.greatest_v(w)],
                                false => [0.0, waist],
                            };
                            let (v, scale_v) = double_exponential(t, widths);
                            let weight = scale_v * scale_w;
                            let element = if is_cap { self.cap(v, w) } else { self.bowl(v, w) };
                            let area = match weight == 0.0 {
                                true => Vector3::zeros(),
                                false => weight * element.area,
                            };
                            SurfaceElement { area, ..element }.mirrored(&signs)
                        };
                        patches.push(Patch::new([DOUBLE_EXPONENTIAL; 2], element));
                    }
                }
            }
        }
        patches
    }
}

impl SuperhyperboloidTwoSheets {
    pub(in crate::shape) fn bowl(&self, v: f64, w: f64) -> SurfaceElement {
        let [a1, a2, a3] = self.size();
        let [k1, k2] = self.exponents().map(|e| 2.0 / e - 1.0);
        let (waist, height) = (self.waist(w), self.height(v, w));
        let slope_v = (v / height).powf(k2);
        let slope_w = (waist / height).powf(k2) * (w / waist).powf(k1);
        SurfaceElement {
            position: Vector3::new(a1 * height, a2 * v, a3 * w),
            area: Vector3::new(-a2 * a3, a1 * a3 * slope_v, a1 * a2 * slope_w),
        }
    }

    pub(in crate::shape) fn cap(&self, v: f64, w: f64) -> SurfaceElement {
        let [_, a2, a3] = self.size();
        SurfaceElement {
            position: Vector3::new(self.clip(), a2 * v, a3 * w),
            area: Vector3::new(a2 * a3, 0.0, 0.0),
        }
    }
}
