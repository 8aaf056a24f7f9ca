//! Charts: every family's boundary as the image of a polyhedron.
//!
//! Faces of the polyhedron are flat, and points of a face go to points of one smooth part of the
//! boundary, but for bends that no edge follows. So whatever triangles a face is cut into, their
//! images cover the boundary, caps of a clip included, once.

mod bowls;
mod crease;
mod superellipsoid;
mod three_exponent;
mod torus;
mod tower;

pub(crate) use bowls::within_rim;
pub(crate) use superellipsoid::flattened_cube_point;

use nalgebra::Vector3;

use super::grading::Grading;
use super::mesh::Mesh;
use crate::shape::Shape;

/// A boundary over a polyhedron, in units of the semi-axes.
pub(super) trait Chart {
    /// The semi-axes, in the shape's unit.
    fn size(&self) -> [f64; 3];

    /// The boundary's point at a place of the polyhedron, each coordinate over its semi-axis.
    fn unit_point(&self, place: &Vector3<f64>) -> Vector3<f64>;

    /// Whether a place within a face is of one that goes to a cap, where a clip ends the shape.
    fn is_on_cap(&self, _place: &Vector3<f64>) -> bool {
        false
    }

    /// The polyhedron with `n` segments along the edges of its faces, `n` even, spread by a
    /// grading.
    fn lattice(&self, n: usize, grading: Grading) -> Lattice;
}

/// A polyhedron cut into triangles.
#[derive(Debug, Clone)]
pub(super) struct Lattice {
    /// Places on the polyhedron.
    pub places: Vec<Vector3<f64>>,
    /// The boundary's points there, each coordinate over its semi-axis.
    pub unit_points: Vec<Vector3<f64>>,
    /// Counter-clockwise as seen from outside the boundary.
    pub triangles: Vec<[u32; 3]>,
}

/// A quadrilateral of a lattice, by the numbers of its corners.
#[derive(Debug, Clone, Copy)]
pub(super) enum Square {
    /// To be cut along the diagonal that leaves the fatter triangles.
    Plain([usize; 4]),
    /// To be cut from the first corner to the third, along a bend.
    Creased([usize; 4]),
}

impl Lattice {
    /// The lattice of places and of squares between them.
    fn new(
        chart: &impl Chart,
        places: Vec<Vector3<f64>>,
        squares: impl Iterator<Item = Square>,
    ) -> Self {
        let unit_points: Vec<_> = places.iter().map(|place| chart.unit_point(place)).collect();
        let triangles = squares.flat_map(|square| square.cut(&unit_points)).collect();
        Self { places, unit_points, triangles }
    }

    /// The mesh on a shape of these semi-axes.
    pub fn mesh(self, size: [f64; 3]) -> Mesh {
        let size = Vector3::from(size);
        let vertices = self.unit_points.iter().map(|x| x.component_mul(&size)).collect();
        Mesh::new(vertices, self.triangles)
    }
}

impl Square {
    /// The square of other corners.
    fn map(self, number: impl Fn(usize) -> usize) -> Self {
        match self {
            Self::Plain(corners) => Self::Plain(corners.map(number)),
            Self::Creased(corners) => Self::Creased(corners.map(number)),
        }
    }

    /// The square as seen from its other side.
    fn reversed(self) -> Self {
        let reverse = |[a, b, c, d]: [usize; 4]| [a, d, c, b];
        match self {
            Self::Plain(corners) => Self::Plain(reverse(corners)),
            Self::Creased(corners) => Self::Creased(reverse(corners)),
        }
    }

    /// The two triangles.
    fn cut(self, points: &[Vector3<f64>]) -> [[u32; 3]; 2] {
        let [a, b, c, d] = match self {
            Self::Creased(corners) => return cut_ac(corners),
            Self::Plain(corners) => corners,
        };
        let least_fatness = |[first, second]: [[u32; 3]; 2]| {
            let fatness = |triangle: [u32; 3]| fatness(triangle.map(|i| points[i as usize]));
            fatness(first).min(fatness(second))
        };
        let [along_ac, along_bd] = [cut_ac([a, b, c, d]), cut_ac([b, c, d, a])];
        if least_fatness(along_ac) >= least_fatness(along_bd) { along_ac } else { along_bd }
    }
}

/// Two triangles of a quadrilateral, cut from its first corner to its third.
fn cut_ac(corners: [usize; 4]) -> [[u32; 3]; 2] {
    let [a, b, c, d] = corners.map(|i| i as u32);
    [[a, b, c], [a, c, d]]
}

/// A triangle's area over the sum of its squared sides, up to a factor: 0 for a sliver.
fn fatness([a, b, c]: [Vector3<f64>; 3]) -> f64 {
    let sides = (b - a).norm_squared() + (c - b).norm_squared() + (a - c).norm_squared();
    (b - a).cross(&(c - a)).norm() / sides
}

/// The chart of whatever family a shape is of.
macro_rules! of_any_family {
    ($shape:expr, $chart:ident => $value:expr) => {
        match $shape {
            Shape::Superellipsoid($chart) => $value,
            Shape::SuperhyperboloidOneSheet($chart) => $value,
            Shape::SuperhyperboloidTwoSheets($chart) => $value,
            Shape::Supertoroid($chart) => $value,
            Shape::ThreeExponent($chart) => $value,
        }
    };
}

impl Chart for Shape {
    fn size(&self) -> [f64; 3] {
        of_any_family!(self, chart => Chart::size(chart))
    }

    fn unit_point(&self, place: &Vector3<f64>) -> Vector3<f64> {
        of_any_family!(self, chart => chart.unit_point(place))
    }

    fn is_on_cap(&self, place: &Vector3<f64>) -> bool {
        of_any_family!(self, chart => chart.is_on_cap(place))
    }

    fn lattice(&self, n: usize, grading: Grading) -> Lattice {
        of_any_family!(self, chart => chart.lattice(n, grading))
    }
}

#[cfg(test)]
mod tests;
