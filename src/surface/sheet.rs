//! Boundaries over triangles: not only a mesh's vertices are on them, but a point for every place of
//! its triangles.

use nalgebra::Vector3;

use super::boundary::march;
use super::covering::Covering;
use super::grading::Grading;
use super::tessellate::Resolution;
use crate::deform::Deformed;
use crate::math::increasing_root;
use crate::pose::Pose;
use crate::shape::{LevelSet, Shape};

/// A closed surface over triangles that share their corners.
///
/// Points over one triangle are a continuous function of the place on it, and over a side the same
/// for both triangles that it joins.
pub(crate) trait Sheet: Send + Sync {
    /// How many corners there are.
    fn count(&self) -> usize;

    /// The numbers of the corners of every triangle, counter-clockwise as seen from outside.
    fn triangles(&self) -> &[[u32; 3]];

    /// The point of the surface over the place that is so much of each corner, 1 in all.
    fn point(&self, corners: [u32; 3], weights: [f64; 3]) -> Vector3<f64>;
}

/// The boundary of a deformed shape, over the polyhedron of its chart. Where a cap ends, corners are
/// next to the edge on both sides of it, so that both of its normals are seen.
pub(crate) struct ChartSheet<'a> {
    covering: Covering<'a>,
    pose: &'a Pose,
    places: Vec<Vector3<f64>>,
    triangles: Vec<[u32; 3]>,
}

impl<'a> ChartSheet<'a> {
    /// The boundary in the pose's world.
    pub fn new(deformed: &'a Deformed<Shape>, pose: &'a Pose, resolution: Resolution) -> Self {
        let covering = Covering { shape: deformed.shape(), chain: deformed.chain() };
        let lattice = covering.lattice(resolution.segments(), Grading::Even);
        let (places, triangles) = lattice.banded(covering.shape);
        Self { covering, pose, places, triangles }
    }
}

impl Sheet for ChartSheet<'_> {
    fn count(&self) -> usize {
        self.places.len()
    }

    fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    fn point(&self, corners: [u32; 3], weights: [f64; 3]) -> Vector3<f64> {
        let place = blend(corners.map(|corner| self.places[corner as usize]), weights);
        self.pose.world_from_model(&self.covering.point(&place))
    }
}

/// The boundary of any solid, across the edges of tetrahedra. A place is one of a line between
/// blends of the edges' ends, from within the solid to without; its point is where the line leaves
/// the solid.
pub(crate) struct GridSheet<'a, S> {
    solid: &'a S,
    /// From within to without.
    edges: Vec<[Vector3<f64>; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl<'a, S: LevelSet + Sync> GridSheet<'a, S> {
    /// The boundary within a box, as of [`boundary_mesh`](super::boundary_mesh).
    pub fn new(solid: &'a S, bounds: [Vector3<f64>; 2], cells: usize) -> Self {
        let (edges, triangles) = march(solid, bounds, cells);
        Self { solid, edges, triangles }
    }
}

impl<S: LevelSet + Sync> Sheet for GridSheet<'_, S> {
    fn count(&self) -> usize {
        self.edges.len()
    }

    fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    fn point(&self, corners: [u32; 3], weights: [f64; 3]) -> Vector3<f64> {
        let edges = corners.map(|corner| self.edges[corner as usize]);
        let [inner, outer] = [0, 1].map(|end| blend(edges.map(|edge| edge[end]), weights));
        let excess = |share: f64| self.solid.level(inner.lerp(&outer, share).into()) - 1.0;
        inner.lerp(&outer, increasing_root(excess, [0.0, 1.0]))
    }
}

fn blend(points: [Vector3<f64>; 3], weights: [f64; 3]) -> Vector3<f64> {
    points.iter().zip(weights).map(|(x, weight)| x * weight).sum()
}
