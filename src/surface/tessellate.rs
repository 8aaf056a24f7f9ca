//! A superellipsoid's surface as triangles, from a lattice on the surface of a cube.

use nalgebra::Vector3;
use thiserror::Error;

use super::grading::{Grading, lattice_lines};
use super::lattice::CubeLattice;
use super::mesh::Mesh;
use crate::shape::{Superellipsoid, superellipse_norm};

/// Number of segments along each edge of the cube whose lattice is laid on the surface.
///
/// It is even, so that vertices lie on the planes of symmetry; a mesh has `12 n^2` triangles
/// and `6 n^2 + 2` vertices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Resolution(usize);

/// A number of segments that is no [`Resolution`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("the resolution must be an even number from 2 to {}, found {found}", Resolution::MAX)]
pub struct ResolutionError {
    /// The number found.
    pub found: usize,
}

impl Resolution {
    /// Greatest number of segments: 200 million triangles.
    pub const MAX: usize = 4096;

    /// A resolution of so many segments.
    ///
    /// # Errors
    /// If the number is not even or not in 2..=4096.
    pub fn new(segments: usize) -> Result<Self, ResolutionError> {
        let is_valid = (2..=Self::MAX).contains(&segments) && segments.is_multiple_of(2);
        if is_valid { Ok(Self(segments)) } else { Err(ResolutionError { found: segments }) }
    }

    /// The number of segments.
    pub fn segments(self) -> usize {
        self.0
    }
}

impl Default for Resolution {
    fn default() -> Self {
        Self(32)
    }
}

/// A closed mesh of the surface, in the model's frame, its vertices on the surface.
///
/// Lattice lines run along the edges `|z/a3| = h` (where `h^(2/e2) = |x/a1|^(2/e2) +
/// |y/a2|^(2/e2)`) and `|x/a1| = |y/a2|`, at which small exponents bend the surface, and along
/// the planes of symmetry, at which exponents near 2 do; triangles' sides run along `|x/a1| =
/// |y/a2|` on the lids too. Semi-axes stretch the mesh of the unit
/// shape.
pub fn tessellate(shape: &Superellipsoid, resolution: Resolution) -> Mesh {
    lattice_mesh(shape, resolution, Grading::Even)
}

/// [`tessellate`] with lattice lines by a grading.
pub(super) fn lattice_mesh(
    shape: &Superellipsoid,
    resolution: Resolution,
    grading: Grading,
) -> Mesh {
    let n = resolution.segments();
    let [e1, e2] = shape.exponents();
    let across = lattice_lines(n, &[e1, e2], grading);
    let along = lattice_lines(n, &[e1], grading);
    let lattice = CubeLattice::new(n);
    let unit_shape = shape.with_size([1.0; 3]);
    let unit: Vec<Vector3<f64>> = lattice
        .points()
        .map(|[i, j, k]| flattened_cube_point([across[i], across[j], along[k]], e2))
        .map(|x| unit_shape.radial_projection(&x))
        .collect();
    let triangles = lattice
        .squares()
        .flat_map(|square| {
            let numbers = |corners: [[usize; 3]; 4]| corners.map(|corner| lattice.number(corner));
            match along_crease(square, n) {
                Some(corners) => split_ac(numbers(corners)),
                None => split(numbers(square), &unit),
            }
        })
        .collect();
    let size = Vector3::from(shape.size());
    Mesh::new(unit.iter().map(|x| x.component_mul(&size)).collect(), triangles)
}

/// A point of the cube's surface, moved so that squares about the z axis become superellipses
/// of exponent e2: edges of the cube become edges of the solid.
pub(crate) fn flattened_cube_point([x, y, z]: [f64; 3], e2: f64) -> Vector3<f64> {
    let side = x.abs().max(y.abs());
    let shrink = if side == 0.0 { 1.0 } else { side / superellipse_norm(x.abs(), y.abs(), e2) };
    Vector3::new(x * shrink, y * shrink, z)
}

/// The corners of a square from one on, if that and the third are where a lid is bent along
/// `|x/a1| = |y/a2|`.
fn along_crease(square: [[usize; 3]; 4], n: usize) -> Option<[[usize; 3]; 4]> {
    let is_on_lid = square.iter().all(|&[_, _, k]| k == square[0][2] && (k == 0 || k == n));
    let is_on_crease = |&[i, j, _]: &[usize; 3]| i == j || i + j == n;
    let [a, b, c, d] = square;
    match [[a, c], [b, d]].map(|diagonal| diagonal.iter().all(is_on_crease)) {
        [true, _] if is_on_lid => Some([a, b, c, d]),
        [_, true] if is_on_lid => Some([b, c, d, a]),
        _ => None,
    }
}

/// Two triangles of a quadrilateral, cut along the diagonal that leaves the fatter ones.
pub(super) fn split([a, b, c, d]: [usize; 4], vertices: &[Vector3<f64>]) -> [[u32; 3]; 2] {
    let least_fatness = |[first, second]: [[u32; 3]; 2]| {
        let fatness = |triangle: [u32; 3]| fatness(triangle.map(|i| vertices[i as usize]));
        fatness(first).min(fatness(second))
    };
    let [along_ac, along_bd] = [split_ac([a, b, c, d]), split_ac([b, c, d, a])];
    if least_fatness(along_ac) >= least_fatness(along_bd) { along_ac } else { along_bd }
}

/// Two triangles of a quadrilateral, cut from its first corner to its third.
fn split_ac(corners: [usize; 4]) -> [[u32; 3]; 2] {
    let [a, b, c, d] = corners.map(|i| i as u32);
    [[a, b, c], [a, c, d]]
}

/// A triangle's area over the sum of its squared sides, up to a factor: 0 for a sliver.
fn fatness([a, b, c]: [Vector3<f64>; 3]) -> f64 {
    let sides = (b - a).norm_squared() + (c - b).norm_squared() + (a - c).norm_squared();
    (b - a).cross(&(c - a)).norm() / sides
}

#[cfg(test)]
mod tests;
