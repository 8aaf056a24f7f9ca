//! Recursive subdivision where adjacent normals diverge too greatly (B84 section 4).
//!
//! Triangles are cut through the middle of their longest side (Rivara 1984), which keeps them from
//! becoming thin; whether a side is cut is a matter of the side alone, so that neighbours agree
//! and the mesh stays closed.

mod forecast;

use std::collections::HashMap;

use nalgebra::Vector3;
use rayon::prelude::*;

use super::chart::{Chart, Lattice};
use super::covering::Covering;
use super::deviation::deviation;
use super::grading::Grading;
use super::tolerance::{MOST_TRIANGLES, TooMany};
use forecast::Forecast;

/// Segments of the lattice that it begins with, the coarsest.
const FIRST_SEGMENTS: usize = 2;

/// How far into a triangle, as a share of its sides, tangents are taken at a corner: the normal is
/// then that of the triangle's own side of a bend.
const INTO: f64 = 1e-4;

/// The lattice of a closed mesh from which the surface departs by at most `tolerance`, as far as
/// [`deviation`] shows.
///
/// It begins with the coarsest lattice. A side of length L whose ends' normals diverge by an
/// angle delta is cut while the sagitta of such an arc, `L delta / 8`, is greater than the
/// tolerance; and the longest side of a triangle from which the surface departs by more. Coarser
/// tolerances come first, and tell how many triangles the finest needs.
///
/// # Errors
/// If these are more than a mesh may have.
pub(super) fn subdivide(surface: &Covering, tolerance: f64) -> Result<Lattice, TooMany> {
    let mut subdivision = Subdivision::new(surface);
    let mut forecast = Forecast::new(tolerance, subdivision.extent());
    while let Some(stage) = forecast.next_tolerance() {
        subdivision.start(stage);
        while subdivision.refine() {
            if subdivision.triangles.len() > MOST_TRIANGLES {
                return Err(TooMany(forecast.triangles(subdivision.triangles.len())));
            }
        }
        forecast.reached(subdivision.triangles.len())?;
    }
    Ok(subdivision.lattice())
}

/// A side by its vertices, the lower number first.
type Side = [u32; 2];

fn side(a: u32, b: u32) -> Side {
    [a.min(b), a.max(b)]
}

/// A mesh on the way. Lengths of sides are compared on the shape of semi-axes one, which those and
/// the deformations stretch afterwards.
struct Subdivision<'a> {
    surface: &'a Covering<'a>,
    tolerance: f64,
    /// Of each vertex: the place on the polyhedron, and the points there.
    places: Vec<Vector3<f64>>,
    unit_points: Vec<Vector3<f64>>,
    points: Vec<Vector3<f64>>,
    /// The longest side first.
    triangles: Vec<[u32; 3]>,
    /// Whether a triangle is known to be fine enough.
    settled: Vec<bool>,
}

impl<'a> Subdivision<'a> {
    fn new(surface: &'a Covering<'a>) -> Self {
        let lattice = surface.lattice(FIRST_SEGMENTS, Grading::Even);
        let points = lattice.unit_points.iter().map(|x| surface.stretched(x)).collect();
        let mut subdivision = Self {
            surface,
            tolerance: f64::INFINITY,
            places: lattice.places,
            unit_points: lattice.unit_points,
            points,
            triangles: Vec::new(),
            settled: vec![true; lattice.triangles.len()],
        };
        subdivision.triangles =
            lattice.triangles.into_iter().map(|t| subdivision.longest_first(t)).collect();
        subdivision
    }

    /// How far vertices are from each other along the axes, at most.
    fn extent(&self) -> f64 {
        let [least, greatest] = [Vector3::inf, Vector3::sup]
            .map(|of| self.points.iter().skip(1).fold(self.points[0], |a, b| of(&a, b)));
        (greatest - least).max()
    }

    /// Looks at all triangles anew, by a lower tolerance.
    fn start(&mut self, tolerance: f64) {
        self.tolerance = tolerance;
        self.settled.fill(false);
    }

    fn lattice(self) -> Lattice {
        let Self { places, unit_points, triangles, .. } = self;
        Lattice { places, unit_points, triangles }
    }

    /// Cuts every triangle that is not fine enough once, and those whose sides that cuts; says
    /// whether there was any.
    fn refine(&mut self) -> bool {
        let mut middles = self.sides_to_cut();
        if middles.is_empty() {
            return false;
        }
        self.close(&mut middles);
        self.place(&mut middles);
        let (mut triangles, mut settled) = (Vec::new(), Vec::new());
        for (&triangle, &is_settled) in self.triangles.iter().zip(&self.settled) {
            let parts = cut(triangle, &middles);
            settled.extend(parts.iter().map(|_| is_settled && parts.len() == 1));
            triangles.extend(parts.into_iter().map(|part| self.longest_first(part)));
        }
        (self.triangles, self.settled) = (triangles, settled);
        true
    }

    /// The sides that ask for it themselves, their middles yet to be placed.
    fn sides_to_cut(&mut self) -> HashMap<Side, u32> {
        let wanted: Vec<Vec<Side>> = (0..self.triangles.len())
            .into_par_iter()
            .map(
                |i| if self.settled[i] { Vec::new() } else { self.coarse_sides(self.triangles[i]) },
            )
            .collect();
        for (settled, sides) in self.settled.iter_mut().zip(&wanted) {
            *settled |= sides.is_empty();
        }
        wanted.into_iter().flatten().map(|side| (side, u32::MAX)).collect()
    }

    /// The sides of a triangle whose normals diverge too greatly, or its longest where the surface
    /// is too far off nonetheless.
    fn coarse_sides(&self, triangle: [u32; 3]) -> Vec<Side> {
        let at = triangle.map(|i| i as usize);
        let [places, corners] = [&self.places, &self.points].map(|of| at.map(|i| of[i]));
        let tangents = [0, 1, 2].map(|i| self.tangents(&places, &corners, i));
        let normals = tangents.map(|[next, last]| next.cross(&last));
        let mut sides: Vec<Side> = (0..3)
            .map(|i| [i, (i + 1) % 3])
            .filter(|&[i, j]| {
                let chord = corners[j] - corners[i];
                let divergence = angle(&normals[i], &normals[j]);
                chord.norm() * divergence / 8.0 > self.tolerance
                    || self.leaves(&chord, &tangents[i][0])
                    || self.leaves(&chord, &tangents[j][1])
            })
            .map(|[i, j]| side(triangle[i], triangle[j]))
            .collect();
        if sides.is_empty() && deviation(self.surface, &places, &corners) > self.tolerance {
            sides.push(side(triangle[0], triangle[1]));
        }
        sides
    }

    /// The tangents at a corner of a triangle along its two sides there, to the next corner and to the
    /// last, each as long as the side were if it went on like that.
    fn tangents(
        &self,
        places: &[Vector3<f64>; 3],
        corners: &[Vector3<f64>; 3],
        i: usize,
    ) -> [Vector3<f64>; 2] {
        [(i + 1) % 3, (i + 2) % 3]
            .map(|j| (self.surface.point(&places[i].lerp(&places[j], INTO)) - corners[i]) / INTO)
    }

    /// Whether a deformed side leaves its chord by more than the tolerance, as an arc with that
    /// tangent does: a quarter of the tangent's part across the chord. Normals alone do not tell
    /// whole turns of a twist.
    fn leaves(&self, chord: &Vector3<f64>, tangent: &Vector3<f64>) -> bool {
        let is_deformed = !self.surface.chain.stages().is_empty();
        is_deformed && chord.cross(tangent).norm() > 4.0 * self.tolerance * chord.norm()
    }

    /// Where any side of a triangle is cut, its longest is too.
    fn close(&self, middles: &mut HashMap<Side, u32>) {
        loop {
            let missing: Vec<Side> = self
                .triangles
                .iter()
                .filter(|[a, b, c]| {
                    [(b, c), (c, a)].iter().any(|(p, q)| middles.contains_key(&side(**p, **q)))
                })
                .map(|&[a, b, _]| side(a, b))
                .filter(|longest| !middles.contains_key(longest))
                .collect();
            if missing.is_empty() {
                return;
            }
            middles.extend(missing.into_iter().map(|side| (side, u32::MAX)));
        }
    }

    /// Puts the middles of the sides to be cut on the surface, in the order of the triangles.
    fn place(&mut self, middles: &mut HashMap<Side, u32>) {
        for &[a, b, c] in &self.triangles {
            for [p, q] in [side(a, b), side(b, c), side(c, a)] {
                let Some(middle) = middles.get_mut(&[p, q]).filter(|middle| **middle == u32::MAX)
                else {
                    continue;
                };
                *middle = self.places.len() as u32;
                let place = 0.5 * (self.places[p as usize] + self.places[q as usize]);
                let unit_point = self.surface.shape.unit_point(&place);
                self.points.push(self.surface.stretched(&unit_point));
                self.unit_points.push(unit_point);
                self.places.push(place);
            }
        }
    }

    /// The triangle turned so that its longest side comes first; of equal ones, the side of lower
    /// numbers, whichever triangle asks.
    fn longest_first(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        let key = |[p, q, _]: [u32; 3]| {
            let [x, y] = [p, q].map(|i| self.unit_points[i as usize]);
            ((x - y).norm_squared(), std::cmp::Reverse(side(p, q)))
        };
        let longer = |p: [u32; 3], q: [u32; 3]| {
            let ((p_length, p_side), (q_length, q_side)) = (key(p), key(q));
            let order = p_length.total_cmp(&q_length).then(p_side.cmp(&q_side));
            if order.is_lt() { q } else { p }
        };
        [[b, c, a], [c, a, b]].into_iter().fold([a, b, c], longer)
    }
}

/// The angle between two vectors, exact for small ones too.
fn angle(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// The parts of a triangle, its longest side first, after the cuts through its sides' middles.
fn cut([a, b, c]: [u32; 3], middles: &HashMap<Side, u32>) -> Vec<[u32; 3]> {
    let middle = |p, q| middles.get(&side(p, q)).copied();
    let Some(m) = middle(a, b) else { return vec![[a, b, c]] };
    let halves = |second: [u32; 3]| {
        // The half's third side m..c is inside; its first is half of the longest.
        let [p, q, r] = second;
        match middle(p, q) {
            Some(n) => vec![[p, n, r], [n, q, r]],
            None => vec![[p, q, r]],
        }
    };
    let mut parts = halves([c, a, m]);
    parts.extend(halves([b, c, m]));
    parts
}
