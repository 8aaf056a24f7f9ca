//! Surfaces of any family as triangles and as points.

use nalgebra::Vector3;

use super::chart::Chart;
use super::covering::Covering;
use super::grading::Grading;
use super::mesh::Mesh;
use super::patches::sample;
use super::sample::sample_surface;
use super::tessellate::Resolution;
use crate::deform::Chain;
use crate::shape::Shape;

/// A closed mesh of a shape's boundary, the caps of a clip included, in the model's frame: its
/// vertices on the boundary, its triangles counter-clockwise as seen from outside.
///
/// A superellipsoid's is that of [`tessellate`](super::tessellate()). A tower has `12 n^2`
/// triangles at a resolution n, two bowls `8 n^2`, a torus `32 n^2`.
pub fn tessellate_shape(shape: &Shape, resolution: Resolution) -> Mesh {
    shape.lattice(resolution.segments(), Grading::Even).mesh(Chart::size(shape))
}

/// `count` independent points of a shape's boundary, the caps of a clip included, uniform by area,
/// in the model's frame; the same for the same seed.
///
/// A superellipsoid's are those of [`sample_surface`]. Domain: exponents up to 2; of three
/// exponents, from 1.
pub fn sample_shape_surface(shape: &Shape, count: usize, seed: u64) -> Vec<Vector3<f64>> {
    match shape {
        Shape::Superellipsoid(shape) => sample_surface(shape, count, seed),
        shape => sample(&Covering { shape, chain: &Chain::default() }, count, seed),
    }
}

#[cfg(test)]
pub(super) use tests::examples;

#[cfg(test)]
mod tests;
