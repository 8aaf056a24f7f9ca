//! Neighbours among few points.

mod nearest;
mod strips;

use std::ops::Range;

use nalgebra::{Matrix3, Vector3};

pub(crate) use nearest::nearest_others;
use strips::{Strips, Windows};

use crate::cloud::PointColumns;
use crate::machine::{Products, vectorized};
use crate::math::least_eigenvalue;

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

#[inline(always)]
fn key(square: f64, index: u64) -> Key {
    square.to_bits() & !INDEX | index
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
        let count = self.indices().count().max(1) as f64;
        let centroid = self.indices().map(point).sum::<Vector3<f64>>() / count;
        let offsets = self.indices().map(|index| point(index) - centroid);
        let scatter: Matrix3<f64> = offsets.map(|x| x * x.transpose()).sum();
        if scatter.trace() > 0.0 { least_eigenvalue(&scatter) / scatter.trace() } else { 0.0 }
    }

    /// No neighbours yet, of which none is to be farther off than this.
    fn within(reach: f64) -> Self {
        /// Beyond what the keys and the arithmetic round off.
        const MARGIN: f64 = 1.0 + 1e-9;
        Self([key(MARGIN * reach * reach, INDEX); NEIGHBOUR])
    }

    fn worst(&self) -> Key {
        self.0[NEIGHBOUR - 1]
    }

    /// Sorts a point in, nearer than the last: without branches, whose outcome nobody could foresee.
    #[inline(always)]
    fn take(&mut self, mut key: Key) {
        for place in &mut self.0 {
            (*place, key) = ((*place).min(key), (*place).max(key));
        }
    }
}

/// The eight nearest neighbours of each point, of [`MOST_POINTS`] at most.
pub(crate) fn neighbourhoods(points: PointColumns) -> Vec<Neighbourhood> {
    let mut all = vec![Neighbourhood::within(f64::INFINITY); points[0].len()];
    for (index, found) in vectorized::run(NeighboursOf { strips: &Strips::of(points), every: 1 }) {
        all[index as usize] = found;
    }
    all
}

/// The eight nearest neighbours, among all points, of one point in so many.
pub(crate) fn some_neighbourhoods(points: PointColumns, every: usize) -> Vec<Neighbourhood> {
    let found = vectorized::run(NeighboursOf { strips: &Strips::of(points), every });
    found.into_iter().map(|(_, neighbourhood)| neighbourhood).collect()
}

/// The search for the neighbours of one point in so many: strip by strip, and along each.
struct NeighboursOf<'a> {
    strips: &'a Strips,
    every: usize,
}

impl vectorized::Kernel for NeighboursOf<'_> {
    /// Indices of points, and what is found of each.
    type Output = Vec<(u64, Neighbourhood)>;

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) -> Self::Output {
        let Self { strips, every } = self;
        let mut all = Vec::with_capacity(strips.points().div_ceil(every) + strips.count());
        let mut search = Search { strips, keys: vec![0; strips.points()] };
        // The point before, and how far its neighbours reach.
        let mut before: Option<(usize, f64)> = None;
        for strip in 0..strips.count() {
            let mut windows = strips.windows();
            let mut first = None;
            for place in strips.places(strip).step_by(every) {
                // What is in reach of a point is not much farther from another.
                let most = before.map_or(f64::INFINITY, |(other, reach)| {
                    reach + strips.square_between(other, place).sqrt()
                });
                let found = search.neighbourhood(place, strip, most, &mut windows);
                all.push((strips.index(place), found));
                before = Some((place, found.reach()));
                first = first.or(before);
            }
            before = first;
        }
        all
    }
}

/// A search, and room for the keys of the points that it looks at.
struct Search<'a> {
    strips: &'a Strips,
    keys: Vec<Key>,
}

impl Search<'_> {
    /// The neighbours of the point at a place of a strip, none of which is farther off than `most`:
    /// it and the strips beside it are looked through until the first coordinate alone is farther
    /// off.
    #[inline(always)]
    fn neighbourhood(
        &mut self,
        place: usize,
        strip: usize,
        most: f64,
        windows: &mut Windows,
    ) -> Neighbourhood {
        let mut found = Neighbourhood::within(most);
        // Loops, as iterators would not be compiled for the instruction set.
        for other in (0..=strip).rev() {
            if !self.look_through(other, place, windows, &mut found) {
                break;
            }
        }
        for other in strip + 1..self.strips.count() {
            if !self.look_through(other, place, windows, &mut found) {
                break;
            }
        }
        found
    }

    /// Takes what is near of a strip, unless it is too far off.
    #[inline(always)]
    fn look_through(
        &mut self,
        strip: usize,
        place: usize,
        windows: &mut Windows,
        found: &mut Neighbourhood,
    ) -> bool {
        let reach = found.reach();
        let is_in_reach = self.strips.distance_to(place, strip) <= reach;
        if is_in_reach {
            self.look_at(windows.around(self.strips, strip, place, reach), place, found);
        }
        is_in_reach
    }

    /// Takes those of the points at some places that are nearer than those found.
    #[inline(always)]
    fn look_at(&mut self, others: Range<usize>, place: usize, found: &mut Neighbourhood) {
        let keys = &mut self.keys[..others.len()];
        self.strips.write_keys(place, others, keys);
        let here = self.strips.index(place);
        for key in keys {
            if *key < found.worst() && *key & INDEX != here {
                found.take(*key);
            }
        }
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
