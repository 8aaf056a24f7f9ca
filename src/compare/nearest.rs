//! The point of a superellipsoid's surface nearest to a given point.

use nalgebra::Vector3;

use crate::shape::Superellipsoid;
use crate::surface::{Resolution, tessellate};

/// Segments of the mesh whose vertices in one octant are the starts of the search.
const START_SEGMENTS: usize = 16;

/// Most steps of one descent; a smooth foot takes about ten.
const GREATEST_STEPS: usize = 200;

/// Most halvings of one step.
const GREATEST_HALVINGS: i32 = 50;

/// Share of the mean semi-axis to which a distance is sought.
const TOLERANCE: f64 = 1e-10;

/// Euclidean projection onto one surface.
///
/// The solid is symmetric about its three planes, so a nearest point lies in the octant of the
/// given one, in which the surface has no ridges: the search is confined to the first. Domain:
/// exponents up to 2; beyond, a nearest point among local ones is not assured. Far from needles
/// of aspect 1:50, a few points in ten thousand are given a distance too large by up to 1e-4 of
/// the mean semi-axis.
#[derive(Debug, Clone)]
pub(super) struct EuclideanProjection {
    shape: Superellipsoid,
    /// Vertices by the axis along which they are furthest out, in semi-axes.
    starts: [Vec<Vector3<f64>>; 3],
}

impl EuclideanProjection {
    pub fn new(shape: &Superellipsoid) -> Self {
        let mut starts = [const { Vec::new() }; 3];
        let resolution = Resolution::new(START_SEGMENTS).unwrap_or_default();
        for &vertex in tessellate(shape, resolution).vertices() {
            if vertex.iter().all(|&c| c >= 0.0) {
                let axis = vertex.component_div(&Vector3::from(shape.size())).imax();
                starts[axis].push(vertex);
            }
        }
        Self { shape: *shape, starts }
    }

    /// Unsigned Euclidean distance of a point of the shape's frame from the surface.
    ///
    /// From outside the distance has one local minimum, from inside one for each side of a box:
    /// there the search starts on each.
    pub fn distance(&self, x: &Vector3<f64>) -> f64 {
        let x = x.abs();
        let radial = Some(self.shape.radial_projection(&x)).filter(|y| *y != Vector3::zeros());
        let sides = self.starts.iter().filter_map(|starts| nearest_of(starts, &x));
        let starts = sides.chain(radial);
        if self.shape.gauge(&x) > 1.0 {
            let start = starts.reduce(|best, next| nearer(best, next, &x));
            return start.map_or(f64::INFINITY, |start| self.descend(&x, start));
        }
        starts.map(|start| self.descend(&x, start)).fold(f64::INFINITY, f64::min)
    }

    /// The distance of `x` from the surface next to `y`, by projected gradient descent with the
    /// step lengths of Barzilai and Borwein (1988), halved until the distance falls.
    ///
    /// Of the offset `x - y`, only the part along the surface can shorten it; the squared
    /// distance cannot fall by more than about that part's square.
    fn descend(&self, x: &Vector3<f64>, mut y: Vector3<f64>) -> f64 {
        let tolerance = TOLERANCE * self.shape.mean_semi_axis();
        let is_met = |slope: &Vector3<f64>, distance: f64| {
            slope.norm_squared() <= tolerance * distance.max(tolerance)
        };
        let mut free = self.tangential(x, &y);
        let mut step = 1.0;
        for _ in 0..GREATEST_STEPS {
            let distance = (x - y).norm();
            if is_met(&free, distance) {
                break;
            }
            let along_ridge = without_ridges(&free, &y);
            let slope = if is_met(&along_ridge, distance) { free } else { along_ridge };
            let Some(next) = self.shortened(x, &y, &(slope * step)) else { break };
            let next_free = self.tangential(x, &next);
            step = barzilai_borwein(&(next - y), &(free - next_free));
            (y, free) = (next, next_free);
        }
        (x - y).norm()
    }

    /// The part of the offset `x - y` that is tangential to the surface at `y`.
    fn tangential(&self, x: &Vector3<f64>, y: &Vector3<f64>) -> Vector3<f64> {
        let normal = self.shape.gauge_gradient(y).normalize();
        let offset = x - y;
        offset - normal * normal.dot(&offset)
    }

    /// A surface point of the first octant next to `y + step`, or less far that way, that is
    /// nearer to `x` than `y`.
    fn shortened(
        &self,
        x: &Vector3<f64>,
        y: &Vector3<f64>,
        step: &Vector3<f64>,
    ) -> Option<Vector3<f64>> {
        let distance = (x - y).norm_squared();
        (0..GREATEST_HALVINGS)
            .map(|halvings| (y + step * 0.5_f64.powi(halvings)).map(|c| c.max(0.0)))
            .map(|trial| self.shape.radial_projection(&trial))
            .find(|next| (x - next).norm_squared() < distance)
    }
}

/// A tangential offset without its components across planes of symmetry on which `y` lies: the
/// surface may turn sharply there, and steps across would hold back those along.
fn without_ridges(slope: &Vector3<f64>, y: &Vector3<f64>) -> Vector3<f64> {
    slope.zip_map(y, |slope, y| if y == 0.0 { 0.0 } else { slope })
}

/// The step `s.s / s.g` from the last displacement s and the change g of the slope over it.
fn barzilai_borwein(moved: &Vector3<f64>, turned: &Vector3<f64>) -> f64 {
    const LONGEST: f64 = 1e3;
    let step = moved.norm_squared() / moved.dot(turned);
    if step > 0.0 { step.min(LONGEST) } else { 1.0 }
}

fn nearest_of(points: &[Vector3<f64>], x: &Vector3<f64>) -> Option<Vector3<f64>> {
    points.iter().copied().reduce(|best, next| nearer(best, next, x))
}

fn nearer(p: Vector3<f64>, q: Vector3<f64>, x: &Vector3<f64>) -> Vector3<f64> {
    if (q - x).norm_squared() < (p - x).norm_squared() { q } else { p }
}

#[cfg(test)]
mod tests;
