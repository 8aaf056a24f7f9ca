//! The boundary of any solid as a watertight mesh, by marching tetrahedra.

use std::collections::HashMap;

use nalgebra::Vector3;
use rayon::prelude::*;

use super::mesh::Mesh;
use crate::shape::LevelSet;

/// Halvings that find where an edge passes the surface: 1e-9 of its length.
const HALVINGS: u32 = 30;

/// Share of the box by which the grid is wider, so that all of the boundary lies inside it.
const MARGIN: f64 = 0.013;

/// The three axes in every order: the tetrahedra of a cell go from its lowest corner to its
/// highest along them (Freudenthal 1942, Kuhn 1960), and so meet those of its neighbours.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [1, 0, 2], [0, 2, 1], [2, 1, 0]];

/// The boundary of a solid within a box `[min, max]` that holds it, on a grid of so many cells
/// along the longest side: closed, and oriented outwards. Parts thinner than a cell may be
/// missed; nothing is returned for an empty box.
///
/// Vertices lie on the surface, where it passes the edges of tetrahedra.
pub fn boundary_mesh(
    solid: &(impl LevelSet + Sync),
    bounds: [Vector3<f64>; 2],
    cells: usize,
) -> Mesh {
    let (edges, triangles) = march(solid, bounds, cells);
    let vertices = edges.into_par_iter().map(|edge| crossing(solid, edge)).collect();
    Mesh::new(vertices, triangles)
}

/// The edges of tetrahedra, from within a solid to without, that its boundary passes, and triangles
/// of the places where it does.
pub(super) fn march(
    solid: &(impl LevelSet + Sync),
    [min, max]: [Vector3<f64>; 2],
    cells: usize,
) -> (Vec<[Vector3<f64>; 2]>, Vec<[u32; 3]>) {
    let extent = max - min;
    let is_empty = extent.iter().any(|&side| !(side > 0.0 && side.is_finite()));
    if is_empty || cells == 0 {
        return (Vec::new(), Vec::new());
    }
    let step = extent.max() / cells as f64;
    let count = extent.map(|side| (side * (1.0 + 2.0 * MARGIN) / step).ceil() as usize);
    let grid = Grid { origin: min - MARGIN * extent, step, count: count.into() };
    let levels: Vec<f64> =
        (0..grid.nodes()).into_par_iter().map(|node| solid.level(grid.position(node))).collect();
    let mut march = March { grid, levels, edges: Vec::new(), known: HashMap::new() };
    let triangles = (0..grid.cells()).flat_map(|cell| march.cell(cell)).collect();
    (march.edges, triangles)
}

/// Where the boundary passes an edge from within a solid to without.
fn crossing(solid: &impl LevelSet, [mut inner, mut outer]: [Vector3<f64>; 2]) -> Vector3<f64> {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inner + outer);
        if solid.level(middle.into()) < 1.0 { inner = middle } else { outer = middle }
    }
    0.5 * (inner + outer)
}

/// Nodes at equal steps.
#[derive(Debug, Clone, Copy)]
struct Grid {
    origin: Vector3<f64>,
    step: f64,
    /// Cells along the axes.
    count: [usize; 3],
}

impl Grid {
    fn cells(&self) -> usize {
        self.count.iter().product()
    }

    fn nodes(&self) -> usize {
        self.count.iter().map(|count| count + 1).product()
    }

    fn position(&self, node: usize) -> [f64; 3] {
        let [nx, ny, _] = self.count.map(|count| count + 1);
        let place = [node % nx, node / nx % ny, node / (nx * ny)];
        std::array::from_fn(|i| self.origin[i] + self.step * place[i] as f64)
    }

    /// The lowest node of a cell.
    fn lowest(&self, cell: usize) -> usize {
        let [nx, ny, _] = self.count;
        let [i, j, k] = [cell % nx, cell / nx % ny, cell / (nx * ny)];
        i + (nx + 1) * (j + (ny + 1) * k)
    }

    /// From a node to the next along each axis.
    fn strides(&self) -> [usize; 3] {
        let [nx, ny, _] = self.count.map(|count| count + 1);
        [1, nx, nx * ny]
    }
}

/// The march through the cells, and the edges found on the way, from within to without.
struct March {
    grid: Grid,
    levels: Vec<f64>,
    edges: Vec<[Vector3<f64>; 2]>,
    known: HashMap<[usize; 2], u32>,
}

impl March {
    fn cell(&mut self, cell: usize) -> Vec<[u32; 3]> {
        let lowest = self.grid.lowest(cell);
        let strides = self.grid.strides();
        let mut triangles = Vec::new();
        for (index, order) in ORDERS.into_iter().enumerate() {
            let mut corners = [lowest; 4];
            for (i, axis) in order.into_iter().enumerate() {
                corners[i + 1] = corners[i] + strides[axis];
            }
            // The first three orders are even: their tetrahedra are right-handed.
            if index >= 3 {
                corners.swap(2, 3);
            }
            self.tetrahedron(corners, &mut triangles);
        }
        triangles
    }

    /// The triangles of a right-handed tetrahedron `[a, b, c, d]`: `(b - a) x (c - a)` points
    /// to d.
    fn tetrahedron(&mut self, corners: [usize; 4], triangles: &mut Vec<[u32; 3]>) {
        let is_inside = corners.map(|corner| self.levels[corner] < 1.0);
        let inner: Vec<usize> = (0..4).filter(|&i| is_inside[i]).collect();
        match inner[..] {
            [one] => triangles.push(self.cap(corners, one, true)),
            [a, b] => triangles.extend(self.strip(corners, [a, b])),
            [_, _, _] => {
                let outer = (0..4).find(|&i| !is_inside[i]).unwrap_or(0);
                let [a, b, c] = self.cap(corners, outer, false);
                triangles.push([a, c, b]);
            }
            _ => {}
        }
    }

    /// The triangle around a corner that alone is inside or outside; it faces away from the corner.
    fn cap(&mut self, corners: [usize; 4], apex: usize, is_inside: bool) -> [u32; 3] {
        opposite(apex).map(|other| {
            let [from, to] = [corners[apex], corners[other]];
            if is_inside { self.vertex(from, to) } else { self.vertex(to, from) }
        })
    }

    /// The two triangles between an inner edge and the outer one.
    fn strip(&mut self, corners: [usize; 4], [a, b]: [usize; 2]) -> [[u32; 3]; 2] {
        // The face opposite to a, turned so that it begins at b.
        let face = opposite(a);
        let start = face.iter().position(|&corner| corner == b).unwrap_or(0);
        let [c, d] = [face[(start + 1) % 3], face[(start + 2) % 3]];
        let [ac, ad] = [c, d].map(|outer| self.vertex(corners[a], corners[outer]));
        let [bc, bd] = [c, d].map(|outer| self.vertex(corners[b], corners[outer]));
        [[ac, ad, bd], [ac, bd, bc]]
    }

    /// The number of an edge from a node within to one without.
    fn vertex(&mut self, inner: usize, outer: usize) -> u32 {
        *self.known.entry([inner, outer]).or_insert_with(|| {
            self.edges.push([inner, outer].map(|node| self.grid.position(node).into()));
            self.edges.len() as u32 - 1
        })
    }
}

/// The other three corners of a right-handed tetrahedron, counter-clockwise as seen from
/// opposite the corner.
fn opposite(corner: usize) -> [usize; 3] {
    [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]][corner]
}
