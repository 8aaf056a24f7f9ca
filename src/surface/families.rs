//! Closed meshes of shapes of any family.

use super::chart::Chart;
use super::grading::Grading;
use super::mesh::Mesh;
use super::tessellate::Resolution;
use crate::shape::Shape;

/// A closed mesh of a shape's boundary, the caps of a clip included, in the model's frame: its
/// vertices on the boundary, its triangles counter-clockwise as seen from outside.
///
/// A superellipsoid's is that of [`tessellate`](super::tessellate()). A tower has `12 n^2`
/// triangles at a resolution n, two bowls `8 n^2`, a torus `32 n^2`.
pub fn tessellate_shape(shape: &Shape, resolution: Resolution) -> Mesh {
    shape.lattice(resolution.segments(), Grading::Even).mesh(Chart::size(shape))
}

#[cfg(test)]
pub(super) use tests::examples;

#[cfg(test)]
mod tests;
