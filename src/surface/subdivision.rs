//! Recursive subdivision where adjacent normals diverge too greatly (B84 section 4).
//!
//! Triangles are cut through the middle of their longest side (Rivara 1984), which keeps them from
//! becoming thin; whether a side is cut is a matter of the side alone, so that neighbours agree
//! and the mesh stays closed.

use std::collections::HashMap;

use nalgebra::Vector3;
use rayon::prelude::*;

use super::deviation::deviation;
use super::grading::Grading;
use super::mesh::Mesh;
use super::tessellate::{Resolution, lattice_mesh};
use crate::shape::Superellipsoid;

/// Most triangles of a mesh.
const MOST_TRIANGLES: usize = 13_000_000;

/// Share of a semi-axis at which a normal is taken beside a plane of symmetry: at exponent 2
/// there is a crease, and a triangle's normals are those of its own side.
const BESIDE: f64 = 1e-12;

/// A closed mesh from which the surface departs by at most `tolerance`, as far as
/// [`deviation`] shows; none if that takes too many triangles.
///
/// It begins with the coarsest lattice. A side of length L whose ends' normals diverge by an
/// angle delta is cut while the sagitta of such an arc, `L delta / 8`, is greater than the
/// tolerance; and the longest side of a triangle from which the surface departs by more.
pub(super) fn subdivide(shape: &Superellipsoid, tolerance: f64) -> Option<Mesh> {
    let coarsest =
        lattice_mesh(&shape.with_size([1.0; 3]), Resolution::new(2).ok()?, Grading::Even);
    let mut subdivision = Subdivision::new(shape, &coarsest, tolerance);
    while subdivision.refine() {
        if subdivision.triangles.len() > MOST_TRIANGLES {
            return None;
        }
    }
    Some(subdivision.mesh())
}

/// A side by its vertices, the lower number first.
type Side = [u32; 2];

fn side(a: u32, b: u32) -> Side {
    [a.min(b), a.max(b)]
}

/// A mesh on the way. Lengths of sides are compared on the unit shape, which semi-axes stretch
/// afterwards.
struct Subdivision {
    shape: Superellipsoid,
    unit_shape: Superellipsoid,
    size: Vector3<f64>,
    tolerance: f64,
    unit_vertices: Vec<Vector3<f64>>,
    /// The longest side first.
    triangles: Vec<[u32; 3]>,
    /// Whether a triangle is known to be fine enough.
    settled: Vec<bool>,
}

impl Subdivision {
    fn new(shape: &Superellipsoid, start: &Mesh, tolerance: f64) -> Self {
        let mut subdivision = Self {
            shape: *shape,
            unit_shape: shape.with_size([1.0; 3]),
            size: Vector3::from(shape.size()),
            tolerance,
            unit_vertices: start.vertices().to_vec(),
            triangles: Vec::new(),
            settled: vec![false; start.triangles().len()],
        };
        subdivision.triangles =
            start.triangles().iter().map(|&triangle| subdivision.longest_first(triangle)).collect();
        subdivision
    }

    fn mesh(self) -> Mesh {
        let vertices = self.unit_vertices.iter().map(|x| x.component_mul(&self.size)).collect();
        Mesh::new(vertices, self.triangles)
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
        let corners = triangle.map(|i| self.unit_vertices[i as usize].component_mul(&self.size));
        let middle = corners.iter().sum::<Vector3<f64>>();
        let normals = corners.map(|x| self.normal(&x, &middle));
        let mut sides: Vec<Side> = (0..3)
            .map(|i| [i, (i + 1) % 3])
            .filter(|&[i, j]| {
                let divergence = angle(&normals[i], &normals[j]);
                (corners[j] - corners[i]).norm() * divergence / 8.0 > self.tolerance
            })
            .map(|[i, j]| side(triangle[i], triangle[j]))
            .collect();
        if sides.is_empty() && deviation(&self.shape, &corners) > self.tolerance {
            sides.push(side(triangle[0], triangle[1]));
        }
        sides
    }

    /// The normal at a vertex as a triangle of that middle has it.
    fn normal(&self, x: &Vector3<f64>, middle: &Vector3<f64>) -> Vector3<f64> {
        let beside = x.zip_zip_map(middle, &self.size, |x, middle, size| {
            if x == 0.0 { (BESIDE * size).copysign(middle) } else { x }
        });
        self.shape.gauge_gradient(&beside)
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
                *middle = self.unit_vertices.len() as u32;
                let [x, y] = [p, q].map(|i| self.unit_vertices[i as usize]);
                self.unit_vertices.push(self.unit_shape.radial_projection(&(0.5 * (x + y))));
            }
        }
    }

    /// The triangle turned so that its longest side comes first; of equal ones, the side of lower
    /// numbers, whichever triangle asks.
    fn longest_first(&self, [a, b, c]: [u32; 3]) -> [u32; 3] {
        let key = |[p, q, _]: [u32; 3]| {
            let [x, y] = [p, q].map(|i| self.unit_vertices[i as usize]);
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
