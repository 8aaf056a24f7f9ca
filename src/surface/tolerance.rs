//! Meshes as fine as a tolerance asks for.

use thiserror::Error;

use super::deviation::mesh_deviation;
use super::grading::Grading;
use super::mesh::Mesh;
use super::subdivision::subdivide;
use super::tessellate::{Resolution, lattice_mesh};
use crate::shape::Superellipsoid;

/// Share of the tolerance that is used up: what a grid on each triangle shows of the deviation
/// is a little less than the whole.
const USED_SHARE: f64 = 0.8;

/// Most segments along the lattice's edges: 13 million triangles.
const MOST_SEGMENTS: usize = 1024;

/// How a mesh comes about.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum MeshMethod {
    /// The lattice of [`tessellate`](super::tessellate()), as fine everywhere as it must be
    /// somewhere.
    Lattice,
    /// The same lattice with its lines placed by the curvature (B81).
    Curvature,
    /// Recursive subdivision where normals diverge (B84 section 4). It takes the fewest triangles
    /// where a shape is bent sharply in places.
    #[default]
    Subdivision,
}

/// Why no mesh is within a tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ToleranceError {
    /// It is not a positive, finite number.
    #[error("the tolerance must be a positive number, found {0}")]
    NotPositive(f64),
    /// It asks for more triangles than a mesh may have.
    #[error("a tolerance of {0} needs more than 13 million triangles by this method")]
    TooFine(f64),
}

/// A closed mesh, its vertices on the surface, from which no point of the surface is further away
/// than `tolerance`, nor any point of it from the surface, in the shape's unit.
///
/// The deviation is measured at 28 places of every triangle. Domain: exponents up to 2.
///
/// # Errors
/// If the tolerance is not positive and finite, or needs too many triangles.
pub fn tessellate_within(
    shape: &Superellipsoid,
    tolerance: f64,
    method: MeshMethod,
) -> Result<Mesh, ToleranceError> {
    if !(tolerance.is_finite() && tolerance > 0.0) {
        return Err(ToleranceError::NotPositive(tolerance));
    }
    let measured = USED_SHARE * tolerance;
    let mesh = match method {
        MeshMethod::Lattice => lattice_within(shape, measured, Grading::Even),
        MeshMethod::Curvature => lattice_within(shape, measured, Grading::Curvature),
        MeshMethod::Subdivision => subdivide(shape, measured),
    };
    mesh.ok_or(ToleranceError::TooFine(tolerance))
}

/// The first lattice of those tried whose deviation is within the tolerance; the next one tried is
/// as much finer as deviations fall with the square of the segments' length.
fn lattice_within(shape: &Superellipsoid, tolerance: f64, grading: Grading) -> Option<Mesh> {
    let mut segments = 2;
    while segments <= MOST_SEGMENTS {
        let mesh = lattice_mesh(shape, Resolution::new(segments).ok()?, grading);
        let excess = mesh_deviation(shape, &mesh) / tolerance;
        if excess <= 1.0 {
            return Some(mesh);
        }
        let wanted = (segments as f64 * excess.sqrt()).min(2.0 * MOST_SEGMENTS as f64);
        segments = (wanted.ceil() as usize).max(segments + 1).next_multiple_of(2);
    }
    None
}

#[cfg(test)]
mod tests;
