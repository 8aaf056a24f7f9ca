//! Neighbours among few points.

use nalgebra::{Matrix3, Vector3};

use crate::cloud::PointColumns;

/// The neighbour whose distance counts: near enough to stay on a surface, far enough not to be
/// chance.
pub(crate) const NEIGHBOUR: usize = 8;

/// Most points that neighbours are looked for among: a place among them takes the lowest bits of
/// [`Key`].
pub(crate) const MOST_POINTS: usize = 1 << INDEX_BITS;
const INDEX_BITS: u32 = 16;
const INDEX: u64 = (1 << INDEX_BITS) - 1;

/// A squared distance, whose bits are in the order of the number, to eleven digits, and in its
/// lowest bits whose it is: two at once are compared and moved.
type Key = u64;

/// No neighbour at all.
const NONE: Key = f64::INFINITY.to_bits() | INDEX;

fn key(square: f64, index: usize) -> Key {
    square.to_bits() & !INDEX | index as u64
}

fn square(key: Key) -> f64 {
    f64::from_bits(key & !INDEX)
}

/// The nearest neighbours of a point, the nearest first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Neighbourhood([Key; NEIGHBOUR]);

impl Neighbourhood {
    /// The distance of the eighth neighbour; infinite where there is none.
    pub fn reach(&self) -> f64 {
        square(self.worst()).sqrt()
    }

    fn indices(&self) -> impl Iterator<Item = usize> {
        self.0.iter().filter(|key| **key < NONE).map(|key| (key & INDEX) as usize)
    }

    /// The least share of the scatter of the neighbours in one direction, `l3 / (l1 + l2 + l3)` of
    /// its eigenvalues: 0 where they lie in a plane, about 0.14 where they are strewn in space, 1/3
    /// at most. (Surface variation: M. Pauly, M. Gross and L. Kobbelt 2002.)
    pub fn variation(&self, points: PointColumns) -> f64 {
        let point = |index: usize| Vector3::from(points.map(|column| column[index]));
        let neighbours: Vec<Vector3<f64>> = self.indices().map(point).collect();
        let centroid = neighbours.iter().sum::<Vector3<f64>>() / neighbours.len().max(1) as f64;
        let scatter: Matrix3<f64> =
            neighbours.iter().map(|x| (x - centroid) * (x - centroid).transpose()).sum();
        let least = scatter.symmetric_eigenvalues().min().max(0.0);
        if scatter.trace() > 0.0 { least / scatter.trace() } else { 0.0 }
    }

    fn none() -> Self {
        Self([NONE; NEIGHBOUR])
    }

    fn worst(&self) -> Key {
        self.0[NEIGHBOUR - 1]
    }

    /// Sorts a point in, if it is nearer than the last: without branches, whose outcome nobody
    /// could foresee.
    fn take(&mut self, mut key: Key) {
        if key < self.worst() {
            for place in &mut self.0 {
                (*place, key) = ((*place).min(key), (*place).max(key));
            }
        }
    }
}

/// The eight nearest neighbours of each point, of [`MOST_POINTS`] at most.
pub(crate) fn neighbourhoods(points: PointColumns) -> Vec<Neighbourhood> {
    let strips = strips(points);
    let mut neighbourhoods = vec![Neighbourhood::none(); points[0].len()];
    for (place, strip) in strips.iter().enumerate() {
        for point in &strip.points {
            neighbourhoods[point.index] = neighbourhood(&strips, place, point);
        }
    }
    neighbourhoods
}

/// A point, its coordinates in the order of the strips.
#[derive(Debug, Clone, Copy)]
struct Placed {
    x: [f64; 3],
    index: usize,
}

/// Points that follow each other along the first coordinate, in the order of the second.
#[derive(Debug)]
struct Strip {
    /// Least and greatest first coordinate.
    range: [f64; 2],
    points: Vec<Placed>,
}

/// The points in strips across their widest coordinate, about as many as there are in each.
/// By rank, not by width: a few far points do not crowd the others together.
fn strips(points: PointColumns) -> Vec<Strip> {
    let widest = widest_column(points);
    let placed =
        |index: usize| Placed { x: [0, 1, 2].map(|k| points[(widest + k) % 3][index]), index };
    let mut all: Vec<Placed> = (0..points[0].len()).map(placed).collect();
    all.sort_by(|a, b| a.x[0].total_cmp(&b.x[0]));
    let strip = |points: &[Placed]| {
        let range = [points[0].x[0], points[points.len() - 1].x[0]];
        let mut points = points.to_vec();
        points.sort_by(|a, b| a.x[1].total_cmp(&b.x[1]));
        Strip { range, points }
    };
    all.chunks(all.len().isqrt().max(1)).map(strip).collect()
}

fn widest_column(points: PointColumns) -> usize {
    let width = |column: &[f64]| {
        let low = column.iter().copied().fold(f64::INFINITY, f64::min);
        column.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low
    };
    let widths = points.map(width);
    (0..3).fold(0, |widest, k| if widths[k] > widths[widest] { k } else { widest })
}

/// The neighbours of a point of a strip: it and those beside it are looked through until the first
/// coordinate alone is farther off.
fn neighbourhood(strips: &[Strip], place: usize, here: &Placed) -> Neighbourhood {
    let mut found = Neighbourhood::none();
    strips[place].look_through(here, &mut found);
    for strip in strips[..place].iter().rev() {
        if (here.x[0] - strip.range[1]).powi(2) >= square(found.worst()) {
            break;
        }
        strip.look_through(here, &mut found);
    }
    for strip in &strips[place + 1..] {
        if (strip.range[0] - here.x[0]).powi(2) >= square(found.worst()) {
            break;
        }
        strip.look_through(here, &mut found);
    }
    found
}

impl Strip {
    /// Takes the points that are nearer than those found, both ways until the second coordinate
    /// alone is farther off.
    fn look_through(&self, here: &Placed, found: &mut Neighbourhood) {
        let middle = self.points.partition_point(|point| point.x[1] < here.x[1]);
        let mut is_within_reach = |other: &Placed| {
            let [dx, dy, dz] = [0, 1, 2].map(|k| other.x[k] - here.x[k]);
            if other.index != here.index {
                found.take(key(dx * dx + dy * dy + dz * dz, other.index));
            }
            dy * dy < square(found.worst())
        };
        let (below, above) = self.points.split_at(middle);
        let _ = below.iter().rev().all(&mut is_within_reach);
        let _ = above.iter().all(&mut is_within_reach);
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    #[test]
    fn agrees_with_trying_all_pairs() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let column = |rng: &mut ChaCha8Rng, width: f64| -> Vec<f64> {
            (0..300).map(|_| width * rng.random::<f64>()).collect()
        };
        let columns = [column(&mut rng, 1.0), column(&mut rng, 4.0), column(&mut rng, 0.1)];
        let points = [&columns[0][..], &columns[1], &columns[2]];
        let squares = |i: usize| -> Vec<f64> {
            let difference = |j: usize, k: usize| (points[k][i] - points[k][j]).powi(2);
            (0..300).map(|j| (0..3).map(|k| difference(j, k)).sum()).collect()
        };
        for (i, found) in neighbourhoods(points).into_iter().enumerate() {
            let all = squares(i);
            let mut order: Vec<usize> = (0..300).collect();
            order.sort_by(|&j, &k| all[j].total_cmp(&all[k]));
            // The first is the point itself.
            assert!(found.indices().eq(order[1..=NEIGHBOUR].iter().copied()));
            assert!((found.reach() - all[order[NEIGHBOUR]].sqrt()).abs() < 1e-10);
        }
    }

    #[test]
    fn too_few_points_have_no_eighth_neighbour_and_twins_are_at_no_distance() {
        let zero = [0.0; 9];
        let reaches = |count: usize| -> Vec<f64> {
            neighbourhoods([&zero[..count]; 3]).iter().map(Neighbourhood::reach).collect()
        };
        assert_eq!(reaches(9), [0.0; 9]);
        assert_eq!(reaches(8), [f64::INFINITY; 8]);
        assert!(reaches(0).is_empty());
        assert_eq!(neighbourhoods([&zero; 3].map(|c| &c[..]))[0].variation([&zero; 3]), 0.0);
    }

    #[test]
    fn variation_tells_a_plane_from_space() {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let mut column =
            |width: f64| -> Vec<f64> { (0..500).map(|_| width * rng.random::<f64>()).collect() };
        for (depth, expected) in [(0.0, 0.0..1e-12), (1.0, 0.1..0.18)] {
            let columns = [column(1.0), column(1.0), column(depth)];
            let points = [&columns[0][..], &columns[1], &columns[2]];
            let all = neighbourhoods(points);
            let mean = all.iter().map(|one| one.variation(points)).sum::<f64>() / 500.0;
            assert!(expected.contains(&mean), "{mean}");
        }
    }
}
