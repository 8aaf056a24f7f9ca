//! Lattices cut open along the edges of caps, where wall and cap have normals of their own.

use std::collections::{HashMap, HashSet};

use nalgebra::Vector3;

use super::{Chart, Lattice};

/// How far from an edge its two sides are told, as a share of a triangle.
const INTO: f64 = 1e-6;

impl Lattice {
    /// Places and triangles in which each corner on the edge of a cap is two, one next to the edge
    /// on the wall and one next to it on the cap, with a narrow band of triangles along the edge
    /// between them.
    pub fn banded(self, chart: &impl Chart) -> (Vec<Vector3<f64>>, Vec<[u32; 3]>) {
        let is_on_cap = |triangle: &[u32; 3]| chart.is_on_cap(&self.centroid(triangle));
        let (caps, walls): (Vec<_>, Vec<_>) = self.triangles.iter().partition(|t| is_on_cap(t));
        let edge = common_sides(&caps, &walls);
        let count = self.places.len();
        // Every corner of an edge begins one of its sides.
        let twins = edge.iter().map(|[corner, _]| *corner).zip(count as u32..);
        let twins: HashMap<u32, u32> = twins.collect();
        let twin = |corner: u32| twins.get(&corner).copied().unwrap_or(corner);

        let mut places = self.places.clone();
        places.resize(count + edge.len(), Vector3::zeros());
        for (triangles, is_cap) in [(&walls, false), (&caps, true)] {
            for triangle in triangles {
                for corner in triangle.iter().filter(|corner| twins.contains_key(corner)) {
                    let number = if is_cap { twin(*corner) } else { *corner };
                    places[number as usize] = self.within(*corner, triangle);
                }
            }
        }
        let caps = caps.iter().map(|triangle| triangle.map(twin));
        let band = edge.iter().flat_map(|&[p, q]| [[p, q, twin(q)], [p, twin(q), twin(p)]]);
        (places, walls.iter().copied().chain(caps).chain(band).collect())
    }

    /// The place next to a corner of a triangle, within the triangle.
    fn within(&self, corner: u32, triangle: &[u32; 3]) -> Vector3<f64> {
        self.places[corner as usize].lerp(&self.centroid(triangle), INTO)
    }

    fn centroid(&self, triangle: &[u32; 3]) -> Vector3<f64> {
        triangle.iter().map(|corner| self.places[*corner as usize]).sum::<Vector3<f64>>() / 3.0
    }
}

/// The sides of some triangles that others pass in the other direction.
fn common_sides(of: &[[u32; 3]], others: &[[u32; 3]]) -> Vec<[u32; 2]> {
    if of.is_empty() {
        return Vec::new();
    }
    let others: HashSet<[u32; 2]> = others.iter().flat_map(sides).collect();
    of.iter().flat_map(sides).filter(|[p, q]| others.contains(&[*q, *p])).collect()
}

fn sides(&[a, b, c]: &[u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{
        LevelSet, Shape, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets,
    };
    use crate::surface::Mesh;
    use crate::surface::grading::Grading;

    fn banded(shape: &Shape) -> (Mesh, usize) {
        let lattice = shape.lattice(8, Grading::Even);
        let count = lattice.places.len();
        let (places, triangles) = lattice.banded(shape);
        let size = Vector3::from(Chart::size(shape));
        let point = |place| shape.unit_point(place).component_mul(&size);
        (Mesh::new(places.iter().map(point).collect(), triangles), count)
    }

    #[test]
    fn edges_of_caps_become_bands_of_a_closed_surface() {
        let size = [1.2, 0.8, 0.5];
        for (e1, e2) in [(1.0, 1.0), (0.3, 1.7), (1.7, 0.2)] {
            for shape in [
                Shape::from(SuperhyperboloidOneSheet::new(size, [e1, e2], 0.9).unwrap()),
                SuperhyperboloidTwoSheets::new(size, [e1, e2], 2.5).unwrap().into(),
            ] {
                let (mesh, count) = banded(&shape);
                assert!(mesh.is_closed());
                // Two caps, each with the four sides of a square of 8 by 8 cells around it.
                assert_eq!(mesh.vertices().len(), count + 2 * 4 * 8);
                for x in mesh.vertices() {
                    assert!((shape.level((*x).into()) - 1.0).abs() < 1e-12, "{x:?} of {shape:?}");
                }
            }
        }
    }

    #[test]
    fn what_has_no_caps_stays_as_it_is() {
        let shape = Superellipsoid::new([1.0, 2.0, 3.0], [0.3, 0.5]).unwrap().into();
        let (mesh, count) = banded(&shape);
        assert!(mesh.is_closed());
        assert_eq!(mesh.vertices().len(), count);
    }
}
