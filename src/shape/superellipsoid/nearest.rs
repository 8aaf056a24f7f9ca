//! The true Euclidean distance to a superellipsoid (JLS section 2.4.2: no closed form is known).
//!
//! By symmetry the first octant will do. Both superellipses of the spherical product run over a
//! parameter from 0 to 2: the slope up to the diagonal, then one more than the reciprocal slope
//! falls short of 1. There edges are at 1 and planes of symmetry at the ends, and a grid that is
//! dense at all three sees every hollow of the distance. From its lowest nodes nested root finding
//! on both derivatives descends within a bracket, which moves on until the foot is inside it.

use std::f64::consts::PI;

use nalgebra::Vector3;

use super::Superellipsoid;
use crate::math::increasing_root;

/// Nodes of the grid along half of a superellipse, between a plane of symmetry and the edge.
const HALF_NODES: usize = 16;

/// Nodes of the grid along a superellipse.
const NODES: usize = 2 * HALF_NODES + 1;

/// Hollows that are descended into: a box has three.
const HOLLOWS: usize = 6;

/// Times a bracket may move on.
const MOVES: usize = 64;

impl Superellipsoid {
    /// The point of the surface that is nearest to `x`; one of them, where several are.
    ///
    /// Domain: exponents up to 2, aspects up to 1:100, any finite point. The foot is off by about
    /// 1e-8 of the distance to the centre of curvature; it takes some tenths of a millisecond.
    pub fn nearest_point(&self, x: &Vector3<f64>) -> Vector3<f64> {
        let octant = Octant { shape: self, target: x.abs() };
        let foot = octant.nearest();
        Vector3::from_fn(|i, _| foot[i].copysign(x[i]))
    }

    /// Signed Euclidean distance of `x` from the surface, negative inside; in the domain of
    /// [`nearest_point`](Self::nearest_point).
    pub fn euclidean_distance(&self, x: &Vector3<f64>) -> f64 {
        let distance = (x - self.nearest_point(x)).norm();
        if self.gauge(x) < 1.0 { -distance } else { distance }
    }
}

/// A point of the first quarter of the unit superellipse, and its derivative by the parameter.
#[derive(Debug, Clone, Copy)]
struct QuarterPoint {
    point: [f64; 2],
    tangent: [f64; 2],
}

impl QuarterPoint {
    /// At a parameter from 0, on the x axis, to 2, on the y axis.
    fn at(s: f64, e: f64) -> Self {
        if s > 1.0 {
            let Self { point: [x, y], tangent: [dx, dy] } = Self::at(2.0 - s, e);
            return Self { point: [y, x], tangent: [-dy, -dx] };
        }
        let power = s.powf(2.0 / e);
        let x = (1.0 + power).powf(-0.5 * e);
        let shrink = s.powf(2.0 / e - 1.0) / (1.0 + power);
        Self { point: [x, s * x], tangent: [-x * shrink, x / (1.0 + power)] }
    }
}

/// A place on the octant: the parameters of the meridian and of the equator.
type Place = [f64; 2];

/// The first octant of a surface, and a point in the octant.
struct Octant<'a> {
    shape: &'a Superellipsoid,
    target: Vector3<f64>,
}

impl Octant<'_> {
    fn nearest(&self) -> Vector3<f64> {
        self.hollows()
            .into_iter()
            .map(|hollow| self.position(self.descend(hollow)))
            .min_by(|a, b| self.height(a).total_cmp(&self.height(b)))
            // There is a lowest node.
            .unwrap_or(self.target)
    }

    /// The squared distance, less that of the target from the centre, which would drown it.
    fn height(&self, x: &Vector3<f64>) -> f64 {
        x.dot(&(x - 2.0 * self.target))
    }

    fn position(&self, [meridian, equator]: Place) -> Vector3<f64> {
        let [e1, e2] = self.shape.exponents;
        self.spherical_product(
            QuarterPoint::at(meridian, e1).point,
            QuarterPoint::at(equator, e2).point,
        )
    }

    fn spherical_product(&self, [radius, z]: [f64; 2], [x, y]: [f64; 2]) -> Vector3<f64> {
        Vector3::new(radius * x, radius * y, z).component_mul(&Vector3::from(self.shape.size))
    }

    /// The lowest nodes of the grid that are no higher than their neighbours.
    fn hollows(&self) -> Vec<Place> {
        let [e1, e2] = self.shape.exponents;
        let parameters: Vec<f64> = (0..NODES).map(grid_parameter).collect();
        let points = |e: f64| parameters.iter().map(move |&s| QuarterPoint::at(s, e).point);
        let equator: Vec<_> = points(e2).collect();
        let heights: Vec<f64> = points(e1)
            .flat_map(|m| equator.iter().map(move |h| (m, *h)))
            .map(|(m, h)| self.height(&self.spherical_product(m, h)))
            .collect();
        let mut nodes: Vec<usize> =
            (0..heights.len()).filter(|&node| is_hollow(&heights, node)).collect();
        nodes.sort_by(|&a, &b| heights[a].total_cmp(&heights[b]));
        nodes.truncate(HOLLOWS);
        nodes.iter().map(|node| [parameters[node / NODES], parameters[node % NODES]]).collect()
    }

    /// The place of no slope that is reached from a node.
    fn descend(&self, start: Place) -> Place {
        let [mut meridian, mut equator] = start.map(bracket_around);
        let mut place = start;
        for _ in 0..MOVES {
            place = self.lowest_within(meridian, equator);
            let is_inside = |s: f64, [low, high]: [f64; 2]| {
                (s > low || low == 0.0) && (s < high || high == 2.0)
            };
            if is_inside(place[0], meridian) && is_inside(place[1], equator) {
                break;
            }
            [meridian, equator] = place.map(bracket_around);
        }
        place
    }

    /// Where both slopes vanish within brackets, or the ends that they point to.
    fn lowest_within(&self, meridian: [f64; 2], equator: [f64; 2]) -> Place {
        let [e1, e2] = self.shape.exponents;
        let along_equator = |m: &QuarterPoint| {
            increasing_root(|s| self.slopes(m, &QuarterPoint::at(s, e2))[1], equator)
        };
        let slope = |s: f64| {
            let m = QuarterPoint::at(s, e1);
            self.slopes(&m, &QuarterPoint::at(along_equator(&m), e2))[0]
        };
        let s = increasing_root(slope, meridian);
        [s, along_equator(&QuarterPoint::at(s, e1))]
    }

    /// Derivatives of half the squared distance along the meridian and along the equator.
    fn slopes(&self, m: &QuarterPoint, h: &QuarterPoint) -> [f64; 2] {
        let offset = self.spherical_product(m.point, h.point) - self.target;
        let north = self.spherical_product(m.tangent, h.point);
        let east = self.spherical_product([m.point[0], 0.0], h.tangent);
        [offset.dot(&north), offset.dot(&east)]
    }
}

/// The parameter of a node: dense at 0, 1 and 2.
fn grid_parameter(i: usize) -> f64 {
    if i > HALF_NODES {
        return 2.0 - grid_parameter(NODES - 1 - i);
    }
    0.5 - 0.5 * (PI * i as f64 / HALF_NODES as f64).cos()
}

/// From the node below a parameter to the node above it.
fn bracket_around(s: f64) -> [f64; 2] {
    let after = (0..NODES).find(|&i| grid_parameter(i) > s).unwrap_or(NODES - 1);
    let before = (0..NODES).rev().find(|&i| grid_parameter(i) < s).unwrap_or(0);
    [grid_parameter(before), grid_parameter(after)]
}

/// Whether no neighbour of a node is lower.
fn is_hollow(heights: &[f64], node: usize) -> bool {
    let (row, column) = (node / NODES, node % NODES);
    let around = |i: usize| i.saturating_sub(1)..=(i + 1).min(NODES - 1);
    around(row).all(|i| around(column).all(|j| heights[i * NODES + j] >= heights[node]))
}

#[cfg(test)]
mod tests;
