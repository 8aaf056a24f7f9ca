//! A triangle mesh.

use std::collections::HashMap;

use nalgebra::Vector3;

use crate::pose::Pose;

/// Triangles over shared vertices, counter-clockwise as seen from outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    vertices: Vec<Vector3<f64>>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A mesh of vertices, and triangles that index them.
    pub(crate) fn new(vertices: Vec<Vector3<f64>>, triangles: Vec<[u32; 3]>) -> Self {
        debug_assert!(triangles.iter().flatten().all(|&i| (i as usize) < vertices.len()));
        Self { vertices, triangles }
    }

    /// The vertices.
    pub fn vertices(&self) -> &[Vector3<f64>] {
        &self.vertices
    }

    /// The triangles: three indices of vertices each.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The corners of every triangle, in the order of [`triangles`](Self::triangles).
    pub fn corners(&self) -> impl ExactSizeIterator<Item = [Vector3<f64>; 3]> {
        self.triangles.iter().map(|triangle| triangle.map(|i| self.vertices[i as usize]))
    }

    /// Sum of the triangles' areas.
    pub fn area(&self) -> f64 {
        self.corners().map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm()).sum()
    }

    /// Enclosed volume `sum a . (b x c) / 6`, by the divergence theorem; positive for triangles
    /// that face outwards.
    ///
    /// Domain: a closed mesh; of another it is the volume of the cone from the first vertex.
    pub fn volume(&self) -> f64 {
        let Some(apex) = self.vertices.first() else { return 0.0 };
        self.corners().map(|[a, b, c]| (a - apex).dot(&(b - apex).cross(&(c - apex)))).sum::<f64>()
            / 6.0
    }

    /// Directed edges `[from, to]` that are not matched by exactly one edge `[to, from]`.
    ///
    /// None are left where the mesh is closed and its triangles agree on the outside.
    pub fn boundary_edges(&self) -> Vec<[u32; 2]> {
        let edges = || self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let mut uses: HashMap<[u32; 2], u32> = HashMap::with_capacity(3 * self.triangles.len());
        edges().for_each(|edge| *uses.entry(edge).or_default() += 1);
        let is_single = |edge: [u32; 2]| uses.get(&edge) == Some(&1);
        edges().filter(|&[a, b]| !(is_single([a, b]) && is_single([b, a]))).collect()
    }

    /// Whether every edge joins exactly two triangles, which pass it in opposite directions.
    pub fn is_closed(&self) -> bool {
        self.boundary_edges().is_empty()
    }

    /// The mesh moved from the model's frame to the world.
    pub fn transformed(&self, pose: &Pose) -> Self {
        self.mapped(|x| pose.world_from_model(x))
    }

    /// The mesh after a map that keeps sides: one of positive determinant.
    pub(crate) fn mapped(&self, map: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Self {
        let vertices = self.vertices.iter().map(map).collect();
        Self { vertices, triangles: self.triangles.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tetrahedron of the origin and the unit points of the axes.
    fn tetrahedron() -> Mesh {
        let vertices = vec![Vector3::zeros(), Vector3::x(), Vector3::y(), Vector3::z()];
        Mesh::new(vertices, vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    }

    #[test]
    fn tetrahedron_has_its_closed_form_area_and_volume() {
        let mesh = tetrahedron();
        // A handful of roundings of numbers near one.
        assert!((mesh.volume() - 1.0 / 6.0).abs() < 1e-15);
        assert!((mesh.area() - (1.5 + 0.75_f64.sqrt())).abs() < 1e-15);
        assert!(mesh.is_closed());
    }

    #[test]
    fn a_motion_keeps_area_and_volume() {
        let far = Vector3::new(1e6, -2e6, 3e6);
        let moved = tetrahedron().transformed(&Pose::from_euler_zyz([0.4, 1.0, -2.0], far));
        // Coordinates of 3e6 are rounded to 5e-10.
        assert!((moved.volume() - 1.0 / 6.0).abs() < 1e-8);
        assert!((moved.area() - (1.5 + 0.75_f64.sqrt())).abs() < 1e-8);
        assert!(moved.is_closed());
    }

    #[test]
    fn a_missing_and_a_reversed_triangle_leave_boundary_edges() {
        let Mesh { vertices, mut triangles } = tetrahedron();
        let open = Mesh::new(vertices.clone(), triangles[..3].to_vec());
        let mut edges = open.boundary_edges();
        edges.sort_unstable();
        assert_eq!(edges, [[1, 3], [2, 1], [3, 2]]);

        triangles[3].reverse();
        assert_eq!(Mesh::new(vertices, triangles).boundary_edges().len(), 6);
    }

    #[test]
    fn an_empty_mesh_has_no_volume() {
        let mesh = Mesh::new(Vec::new(), Vec::new());
        assert_eq!((mesh.volume(), mesh.area()), (0.0, 0.0));
    }
}
