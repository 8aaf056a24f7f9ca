//! Reflections of a superellipse's and a superellipsoid's smallest part (FB81): eightfold and
//! 48-fold symmetry.

use super::vertex_array::VertexArray;
use crate::machine::Products;
use crate::machine::vectorized::{self, Kernel};
use crate::math::elementary::power;

/// Images of a point under the symmetries of a superellipsoid of equal exponents.
const IMAGES: usize = 48;

/// The orders of three coordinates.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// The eight points of the unit superellipse that are the images of one, counter-clockwise for a
/// point `0 <= y <= x` from its own octant on.
pub fn octant_reflections([x, y]: [f64; 2]) -> [[f64; 2]; 8] {
    [[x, y], [y, x], [-y, x], [-x, y], [-x, -y], [-y, -x], [y, -x], [x, -y]]
}

/// Writes the surface of equal exponents `e` and semi-axes `size` as points `step` apart (in
/// semi-axes) along two axes: those of the part `0 <= x <= y <= z` by the explicit equation, and
/// their 47 reflections.
///
/// Vertices in the planes `|x| = |y|` of the unit shape, a step's width, come twice. Domain: e
/// above 0, and `step` from 1e-4 to 1, beyond which it is set to the next.
pub fn write_reflections(vertices: &mut VertexArray, size: [f64; 3], e: f64, step: f64) {
    let part = SmallestPart::new(e, step.clamp(1e-4, 1.0));
    let count = part.counts.iter().sum();
    let mut columns = [(); 3].map(|()| vec![0.0_f32; count]);
    let mut start = 0;
    for (j, &count) in part.counts.iter().enumerate() {
        let row = columns.each_mut().map(|column| &mut column[start..start + count]);
        vectorized::run(PartRow { part: &part, j, columns: row });
        start += count;
    }
    vertices.resize(IMAGES * count);
    vectorized::run(Images { vertices, columns: &columns, size });
}

/// The part `0 <= x <= y <= z`, a row of x for every y.
struct SmallestPart {
    /// Middles of the steps of x and y.
    coordinates: Vec<f64>,
    /// Their `2/e`-th powers.
    powers: Vec<f64>,
    /// Points in each row.
    counts: Vec<usize>,
    exponent: f64,
}

impl SmallestPart {
    fn new(e: f64, step: f64) -> Self {
        // y <= z as long as 2 y^n <= 1.
        let greatest = 0.5_f64.powf(0.5 * e);
        let steps = (greatest / step).ceil() as usize;
        let coordinates: Vec<f64> = (0..steps).map(|i| step * (i as f64 + 0.5)).collect();
        let powers: Vec<f64> = coordinates.iter().map(|x| x.powf(2.0 / e)).collect();
        let rest = |j: usize| 1.0 - 2.0 * powers[j];
        let counts = (0..steps).map(|j| powers[..=j].partition_point(|x| *x <= rest(j)));
        Self { counts: counts.collect(), coordinates, powers, exponent: e }
    }
}

/// The points of one row of the smallest part.
struct PartRow<'a> {
    part: &'a SmallestPart,
    j: usize,
    columns: [&'a mut [f32]; 3],
}

impl Kernel for PartRow<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) {
        let SmallestPart { coordinates, powers, exponent, .. } = self.part;
        let [xs, ys, zs] = self.columns;
        ys.fill(coordinates[self.j] as f32);
        for (to, &x) in xs.iter_mut().zip(coordinates) {
            *to = x as f32;
        }
        let row_power = powers[self.j];
        for (z, &x_power) in zs.iter_mut().zip(powers) {
            *z = power::<FMA>(1.0 - (x_power + row_power), 0.5 * exponent) as f32;
        }
    }
}

/// The images of the smallest part, each in its own stretch of the array.
struct Images<'a> {
    vertices: &'a mut VertexArray,
    columns: &'a [Vec<f32>; 3],
    size: [f64; 3],
}

impl Kernel for Images<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) {
        let count = self.columns[0].len();
        for image in 0..IMAGES {
            let (order, octant) = (ORDERS[image / 8], image % 8);
            for (axis, &from) in order.iter().enumerate() {
                let sign = if octant >> axis & 1 == 0 { 1.0 } else { -1.0 };
                let factor = (sign * self.size[axis]) as f32;
                let to = &mut self.vertices.column_mut(axis)[image * count..(image + 1) * count];
                for (to, &coordinate) in to.iter_mut().zip(&self.columns[from]) {
                    *to = factor * coordinate;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{Superellipse, Superellipsoid};

    const EXPONENTS: [f64; 6] = [0.05, 0.1, 0.5, 1.0, 1.5, 2.0];

    #[test]
    fn reflections_of_an_octant_go_once_around() {
        let figure = Superellipse::new([1.0, 1.0], 0.4).unwrap();
        let images = octant_reflections(figure.position(0.3).into());
        let angles: Vec<f64> = images.iter().map(|[x, y]| y.atan2(*x)).collect();
        assert!(images.iter().all(|&x| (figure.gauge(&x.into()) - 1.0).abs() < 1e-14));
        let turns = |i: usize| (angles[(i + 1) % 8] - angles[i]).rem_euclid(std::f64::consts::TAU);
        assert!((0..8).all(|i| turns(i) > 0.0));
        let sum: f64 = (0..8).map(turns).sum();
        assert!((sum - std::f64::consts::TAU).abs() < 1e-12);
    }

    #[test]
    fn all_reflections_are_on_the_surface() {
        for e in EXPONENTS {
            let size = [2.0, 1.0, 0.5];
            let shape = Superellipsoid::new(size, [e, e]).unwrap();
            let mut vertices = VertexArray::default();
            write_reflections(&mut vertices, size, e, 0.02);
            assert!(vertices.len() > 1000 && vertices.len().is_multiple_of(IMAGES));
            for x in vertices.points() {
                let point = x.map(f64::from).into();
                // Coordinates of 24 bits.
                assert!(shape.radial_distance(&point).abs() < 3e-7, "{e} {x:?}");
            }
        }
    }

    #[test]
    fn no_place_of_the_surface_is_further_off_than_a_step() {
        for e in EXPONENTS {
            let step = 0.05;
            let mut vertices = VertexArray::default();
            write_reflections(&mut vertices, [1.0; 3], e, step);
            let shape = Superellipsoid::new([1.0; 3], [e, e]).unwrap();
            for x in crate::surface::sample_surface(&shape, 300, 1) {
                let distance = vertices
                    .points()
                    .map(|vertex| (nalgebra::Vector3::from(vertex.map(f64::from)) - x).norm())
                    .fold(f64::INFINITY, f64::min);
                // Half a step along either axis and at most both of them along z; at the edge of
                // the part, where a row ends within a step, another half.
                assert!(distance < 1.5 * step, "{e} {x} {distance}");
            }
        }
    }
}
