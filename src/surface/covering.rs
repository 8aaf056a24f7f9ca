//! A deformed boundary over the polyhedron of its shape's chart.

use nalgebra::Vector3;

use super::chart::{Chart, Lattice};
use super::grading::Grading;
use super::mesh::Mesh;
use crate::deform::{Chain, Deform};
use crate::shape::Shape;

/// A shape's boundary after deformations, over a polyhedron.
#[derive(Debug, Clone, Copy)]
pub(super) struct Covering<'a> {
    pub shape: &'a Shape,
    pub chain: &'a Chain,
}

impl Covering<'_> {
    /// The boundary's point at a place of the polyhedron.
    pub fn point(&self, place: &Vector3<f64>) -> Vector3<f64> {
        self.stretched(&self.shape.unit_point(place))
    }

    /// The point of the boundary that a point of the shape of semi-axes one becomes.
    pub fn stretched(&self, unit_point: &Vector3<f64>) -> Vector3<f64> {
        let x = unit_point.component_mul(&Vector3::from(Chart::size(self.shape)));
        self.chain.forward_of(x.into()).into()
    }

    /// The polyhedron, cut into triangles.
    pub fn lattice(&self, segments: usize, grading: Grading) -> Lattice {
        self.shape.lattice(segments, grading)
    }

    /// The mesh of a lattice.
    pub fn mesh(&self, lattice: Lattice) -> Mesh {
        let mesh = lattice.mesh(Chart::size(self.shape));
        mesh.mapped(|x| self.chain.forward_of((*x).into()).into())
    }
}
