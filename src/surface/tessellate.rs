//! A superellipsoid's surface as triangles, from a lattice on the surface of a cube.

use thiserror::Error;

use super::chart::Chart;
use super::grading::Grading;
use super::mesh::Mesh;
use crate::shape::Superellipsoid;

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
    shape.lattice(resolution.segments(), Grading::Even).mesh(shape.size())
}

#[cfg(test)]
mod tests;
