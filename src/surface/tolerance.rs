//! Meshes as fine as a tolerance asks for.

use thiserror::Error;

use super::chart::Lattice;
use super::covering::Covering;
use super::deviation::lattice_deviation;
use super::grading::Grading;
use super::mesh::Mesh;
use super::subdivision::subdivide;
use crate::deform::{Chain, Deformed};
use crate::shape::Shape;

/// Share of the tolerance that is used up: what a grid on each triangle shows of the deviation
/// is a little less than the whole.
const USED_SHARE: f64 = 0.8;

/// Most triangles of a mesh.
pub(super) const MOST_TRIANGLES: usize = 13_000_000;

/// Segments of a lattice from which on deviations fall with the square of their number, so that
/// they tell how many more are needed.
const TELLING_SEGMENTS: usize = 32;

/// How a mesh comes about.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum MeshMethod {
    /// The lattice of [`tessellate_shape`](super::tessellate_shape()), as fine everywhere as it
    /// must be somewhere.
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
    #[error(
        "a tolerance of {tolerance} needs about {wanted:.1e} triangles by this method, \
         and a mesh may have 13 million"
    )]
    TooFine {
        /// The tolerance asked for.
        tolerance: f64,
        /// How many triangles it needs, as far as a coarser mesh tells.
        wanted: f64,
    },
}

/// A closed mesh of a shape's boundary, its vertices on it, from which no point of the boundary is
/// further away than `tolerance`, nor any point of it from the boundary, in the shape's unit.
///
/// The deviation is measured at 32 places of every triangle. Caps of a clip are flat, and exact but
/// for their rims. Domain: exponents from 0.05 to 2; beyond, tips take many triangles.
///
/// # Errors
/// If the tolerance is not positive and finite, or needs too many triangles; that is told by coarser
/// meshes, without making so fine a one.
pub fn tessellate_within(
    shape: impl Into<Shape>,
    tolerance: f64,
    method: MeshMethod,
) -> Result<Mesh, ToleranceError> {
    let surface = Covering { shape: &shape.into(), chain: &Chain::default() };
    Ok(surface.mesh(within(&surface, tolerance, method)?))
}

/// The same of a deformed shape: within the tolerance after the deformations.
///
/// # Errors
/// Those of [`tessellate_within`].
pub fn tessellate_deformed_within<S: Copy + Into<Shape>>(
    solid: &Deformed<S>,
    tolerance: f64,
    method: MeshMethod,
) -> Result<Mesh, ToleranceError> {
    let surface = Covering { shape: &(*solid.shape()).into(), chain: solid.chain() };
    Ok(surface.mesh(within(&surface, tolerance, method)?))
}

/// The lattice of the mesh.
fn within(
    surface: &Covering,
    tolerance: f64,
    method: MeshMethod,
) -> Result<Lattice, ToleranceError> {
    if !(tolerance.is_finite() && tolerance > 0.0) {
        return Err(ToleranceError::NotPositive(tolerance));
    }
    let measured = USED_SHARE * tolerance;
    let lattice = match method {
        MeshMethod::Lattice => lattice_within(surface, measured, Grading::Even),
        MeshMethod::Curvature => lattice_within(surface, measured, Grading::Curvature),
        MeshMethod::Subdivision => subdivide(surface, measured),
    };
    lattice.map_err(|TooMany(wanted)| ToleranceError::TooFine { tolerance, wanted })
}

/// About how many triangles are needed, more than a mesh may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TooMany(pub f64);

/// The first lattice of those tried whose deviation is within the tolerance; the next one tried is
/// as much finer as deviations fall with the square of the segments' length.
fn lattice_within(
    surface: &Covering,
    tolerance: f64,
    grading: Grading,
) -> Result<Lattice, TooMany> {
    let mut segments = 2;
    loop {
        let lattice = surface.lattice(segments, grading);
        let excess = lattice_deviation(surface, &lattice) / tolerance;
        if excess <= 1.0 {
            return Ok(lattice);
        }
        let triangles = lattice.triangles.len() as f64;
        let most_times_finer = (MOST_TRIANGLES as f64 / triangles).sqrt();
        let is_telling = segments >= TELLING_SEGMENTS || most_times_finer < 2.0;
        if is_telling && excess.sqrt() > most_times_finer {
            return Err(TooMany(triangles * excess));
        }
        let most = if is_telling { f64::INFINITY } else { TELLING_SEGMENTS as f64 };
        let wanted = (segments as f64 * excess.sqrt()).min(most);
        segments = (wanted.ceil() as usize).max(segments + 1).next_multiple_of(2);
    }
}

#[cfg(test)]
mod families;
#[cfg(test)]
mod tests;
