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
/// the solid, up to its length beyond its ends where an edge of the solid passes between two of a
/// kind.
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
        let bracket = match () {
            () if excess(0.0) >= 0.0 => [-1.0, 0.0],
            () if excess(1.0) <= 0.0 => [1.0, 2.0],
            () => [0.0, 1.0],
        };
        inner.lerp(&outer, increasing_root(excess, bracket))
    }
}

fn blend(points: [Vector3<f64>; 3], weights: [f64; 3]) -> Vector3<f64> {
    points.iter().zip(weights).map(|(x, weight)| x * weight).sum()
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use super::*;
    use crate::deform::{Bend, Chain, Deformation, Line, Taper, Twist};
    use crate::shape::{
        Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
        ThreeExponent,
    };
    use crate::solid::{Primitive, Tree};

    fn primitives() -> Vec<Primitive<Shape>> {
        let size = [1.2, 0.8, 0.5];
        let shapes: [Shape; 5] = [
            Superellipsoid::new(size, [0.3, 1.4]).unwrap().into(),
            ThreeExponent::new(size, [1.5, 3.0, 2.0]).unwrap().into(),
            SuperhyperboloidOneSheet::new(size, [0.6, 0.4], 0.9).unwrap().into(),
            SuperhyperboloidTwoSheets::new(size, [0.7, 1.3], 2.0).unwrap().into(),
            Supertoroid::new([0.3, 0.4, 0.3], [0.5, 1.5], 2.0).unwrap().into(),
        ];
        let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
        let stages = [
            Deformation::new(Taper::new(line(1.0, -0.3))),
            Deformation::new(Twist::new(line(0.0, 0.8))),
            Deformation::new(Bend::new(0.3, 0.0, [-1.0, 1.0]).unwrap()),
        ];
        let pose = Pose::from_euler_zyz([0.3, 1.2, -0.5], Vector3::new(1.0, 2.0, 3.0));
        let deformed = |shape| Deformed::new(shape, Chain::new(stages.clone())).unwrap();
        shapes.map(|shape| Primitive { deformed: deformed(shape), pose }).into()
    }

    /// Points over a side are the same for both triangles; the share of points over the insides of
    /// triangles that are on the surface.
    fn share_on_surface(sheet: &dyn Sheet, solid: &Tree, slack: f64) -> f64 {
        let mut over_sides: HashMap<[u32; 2], Vector3<f64>> = HashMap::new();
        let mut on_surface = 0;
        for &[a, b, c] in sheet.triangles() {
            let level = solid.level(sheet.point([a, b, c], [0.2, 0.3, 0.5]).into());
            on_surface += usize::from((level - 1.0).abs() < slack);
            for corners @ [p, q, _] in [[a, b, c], [b, c, a], [c, a, b]] {
                let x = sheet.point(corners, [0.5, 0.5, 0.0]);
                if let Some(other) = over_sides.remove(&[q, p]) {
                    assert!((x - other).norm() < 1e-12, "{x:?} {other:?} of {solid:?}");
                } else {
                    over_sides.insert([p, q], x);
                }
            }
        }
        assert!(over_sides.is_empty() && sheet.count() > 200);
        on_surface as f64 / sheet.triangles().len() as f64
    }

    #[test]
    fn points_over_charts_are_on_the_boundary_and_the_same_on_both_sides_of_a_side() {
        for primitive in primitives() {
            let resolution = Resolution::new(8).unwrap();
            let sheet = ChartSheet::new(&primitive.deformed, &primitive.pose, resolution);
            // Bands along edges cut them by a millionth of a triangle.
            assert_eq!(share_on_surface(&sheet, &primitive.clone().into(), 1e-6), 1.0);
        }
    }

    #[test]
    fn points_over_grids_are_on_the_boundary_and_the_same_on_both_sides_of_a_side() {
        let solids: Vec<Tree> = primitives().into_iter().map(Tree::from).collect();
        let moved =
            |i: usize| solids[i].moved(&Pose::new(Default::default(), Vector3::new(0.4, 0.3, 0.1)));
        let bite = Tree::Difference(Box::new(solids[0].clone()), vec![moved(1)]);
        let common = Tree::Intersection(vec![solids[0].clone(), moved(2)]);
        for solid in [bite, common] {
            let sheet = GridSheet::new(&solid, solid.bounding_box(), 40);
            let share = share_on_surface(&sheet, &solid, 1e-9);
            // All but those at sharp edges.
            assert!(share > 0.99, "{share}");
        }
    }
}
