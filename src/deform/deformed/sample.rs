//! Points of a deformed surface of any family, uniform by area.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::Deformed;
use crate::deform::map::Deform;
use crate::shape::{Patch, Patched};

/// Cells along each parameter of a patch.
const CELLS: usize = 24;

/// How much greater than at its corners and middles the area of elements is taken to be in a cell.
const MARGIN: f64 = 1.3;

/// Share of the greatest element that a cell's bound is raised by: where an edge ends inside.
const LEAST_SHARE: f64 = 1e-3;

impl<S: Patched> Deformed<S> {
    /// `count` independent points of the surface, the caps of a clip included, uniform by area,
    /// in the shape's frame; the same for the same seed.
    ///
    /// Points drawn evenly from a cell of the parameters are kept with a probability proportional
    /// to the area of their element; should one exceed the cell's bound on it, all are drawn anew
    /// under twice the bounds.
    pub fn sample_surface(&self, count: usize, seed: u64) -> Vec<Vector3<f64>> {
        let patches = self.shape.patches();
        let mut cells = self.cells(&patches);
        loop {
            if let Some(points) = self.kept(&patches, &cells, count, seed) {
                return points;
            }
            cells.iter_mut().for_each(|cell| cell.bound *= 2.0);
        }
    }

    /// The area of the deformed element, to a unit of both parameters, and where it is.
    fn deformed_element(&self, patch: &Patch, [s, t]: [f64; 2]) -> (f64, Vector3<f64>) {
        let element = patch.element(s, t);
        let area = self.chain.normal_transform(&element.position) * element.area;
        (area.norm(), element.position)
    }

    fn cells(&self, patches: &[Patch]) -> Vec<SampleCell> {
        let mut cells = Vec::new();
        for (number, patch) in patches.iter().enumerate() {
            for cell in 0..CELLS * CELLS {
                let place = [cell % CELLS, cell / CELLS];
                let ranges = [0, 1].map(|i| part(patch.ranges()[i], place[i]));
                let probes = (0..9).map(|probe| {
                    let share = [probe % 3, probe / 3].map(|i| 0.5 * f64::from(i));
                    self.deformed_element(patch, within(&ranges, share)).0
                });
                let bound = MARGIN * probes.fold(0.0, f64::max);
                cells.push(SampleCell { patch: number, ranges, bound });
            }
        }
        let greatest = cells.iter().map(|cell| cell.bound).fold(0.0, f64::max);
        cells.iter_mut().for_each(|cell| cell.bound += LEAST_SHARE * greatest);
        cells
    }

    /// Points under the cells' bounds; nothing, if one is exceeded.
    fn kept(
        &self,
        patches: &[Patch],
        cells: &[SampleCell],
        count: usize,
        seed: u64,
    ) -> Option<Vec<Vector3<f64>>> {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let sums: Vec<f64> = cells
            .iter()
            .scan(0.0, |sum, cell| {
                *sum += cell.weight();
                Some(*sum)
            })
            .collect();
        let whole = *sums.last()?;
        let mut points = Vec::with_capacity(count);
        while points.len() < count {
            let [drawn, s, t, share] = [(); 4].map(|()| rng.random::<f64>());
            let cell = &cells[sums.partition_point(|&sum| sum < drawn * whole).min(sums.len() - 1)];
            let (area, position) =
                self.deformed_element(&patches[cell.patch], within(&cell.ranges, [s, t]));
            if area > cell.bound {
                return None;
            }
            if share * cell.bound < area {
                points.push(self.chain.forward_of(position.into()).into());
            }
        }
        Some(points)
    }
}

/// A part of a patch's parameters, and a bound on the area of its elements.
#[derive(Debug, Clone, Copy)]
struct SampleCell {
    patch: usize,
    ranges: [[f64; 2]; 2],
    bound: f64,
}

impl SampleCell {
    fn weight(&self) -> f64 {
        self.ranges.iter().map(|[from, to]| to - from).product::<f64>() * self.bound
    }
}

/// One of the equal parts of a range.
fn part([from, to]: [f64; 2], number: usize) -> [f64; 2] {
    [number, number + 1].map(|end| from + (to - from) * (end as f64 / CELLS as f64))
}

/// The place at shares of two ranges.
fn within(ranges: &[[f64; 2]; 2], shares: [f64; 2]) -> [f64; 2] {
    std::array::from_fn(|i| ranges[i][0] + (ranges[i][1] - ranges[i][0]) * shares[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deform::{Bend, Chain, Deformation, Line, Twist};
    use crate::shape::{
        LevelSet, Shape, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets,
        Supertoroid, ThreeExponent,
    };
    use crate::surface::{Resolution, deformed_mesh, tessellate_shape};

    fn solids() -> Vec<Deformed<Shape>> {
        let (size, e) = ([0.8, 0.5, 0.6], [0.3, 1.2]);
        let shapes: [Shape; 5] = [
            Superellipsoid::new(size, [0.1, 0.1]).unwrap().into(),
            SuperhyperboloidOneSheet::new(size, e, 0.9).unwrap().into(),
            SuperhyperboloidTwoSheets::new(size, [1.0, 0.8], 1.5).unwrap().into(),
            Supertoroid::new([0.3, 0.2, 0.4], e, 1.8).unwrap().into(),
            ThreeExponent::new(size, [1.2, 3.0, 8.0]).unwrap().into(),
        ];
        let stages = [
            Deformation::new(Twist::new(Line::new(0.2, 1.2).unwrap())),
            Deformation::new(Bend::new(0.5, 0.0, [-0.6, 0.5]).unwrap()),
        ];
        shapes.map(|shape| Deformed::new(shape, Chain::new(stages.clone())).unwrap()).into()
    }

    #[test]
    fn points_of_every_family_are_on_the_surface_and_uniform_by_area() {
        let count = 20_000;
        for solid in solids() {
            let points = solid.sample_surface(count, 7);
            assert_eq!(points, solid.sample_surface(count, 7));
            assert_eq!(points.len(), count);
            let is_on_it = |x: &Vector3<f64>| (solid.level((*x).into()) - 1.0).abs() < 1e-9;
            assert!(points.iter().all(is_on_it), "{solid:?}");
            let undeformed = tessellate_shape(solid.shape(), Resolution::new(96).unwrap());
            let mesh = deformed_mesh(&solid, &undeformed);
            for (axis, level) in [(0, 0.2), (1, -0.3), (2, 0.1), (2, 0.4)] {
                let beyond: f64 = mesh
                    .corners()
                    .filter(|corners| corners.iter().map(|x| x[axis]).sum::<f64>() > 3.0 * level)
                    .map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm())
                    .sum();
                let share = points.iter().filter(|x| x[axis] > level).count() as f64 / count as f64;
                // Five standard errors, and triangles cut by the plane.
                let slack = 5.0 * 0.5 / (count as f64).sqrt() + 5e-3;
                let expected = beyond / mesh.area();
                assert!((share - expected).abs() < slack, "{solid:?} {axis} {share} {expected}");
            }
        }
    }
}
