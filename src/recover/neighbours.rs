//! Neighbours among few points.

use nalgebra::{Matrix3, Vector3};

use crate::cloud::PointColumns;

/// The neighbour whose distance counts: near enough to stay on a surface, far enough not to be
/// chance.
pub(crate) const NEIGHBOUR: usize = 8;

/// The nearest neighbours of a point, the nearest first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Neighbourhood {
    /// Squared distances; infinite where there are fewer.
    squares: [f64; NEIGHBOUR],
    indices: [usize; NEIGHBOUR],
}

impl Neighbourhood {
    /// The distance of the eighth neighbour.
    pub fn reach(&self) -> f64 {
        self.squares[NEIGHBOUR - 1].sqrt()
    }

    /// The least share of the scatter of the neighbours in one direction, `l3 / (l1 + l2 + l3)` of
    /// its eigenvalues: 0 where they lie in a plane, about 0.14 where they are strewn in space, 1/3
    /// at most. (Surface variation: M. Pauly, M. Gross and L. Kobbelt 2002.)
    pub fn variation(&self, points: PointColumns) -> f64 {
        let neighbours = self.indices.iter().zip(self.squares).filter(|(_, s)| s.is_finite());
        let neighbours: Vec<Vector3<f64>> =
            neighbours.map(|(&i, _)| Vector3::from(points.map(|column| column[i]))).collect();
        let centroid = neighbours.iter().sum::<Vector3<f64>>() / neighbours.len().max(1) as f64;
        let scatter: Matrix3<f64> =
            neighbours.iter().map(|x| (x - centroid) * (x - centroid).transpose()).sum();
        let least = scatter.symmetric_eigenvalues().min().max(0.0);
        if scatter.trace() > 0.0 { least / scatter.trace() } else { 0.0 }
    }

    fn none() -> Self {
        Self { squares: [f64::INFINITY; NEIGHBOUR], indices: [0; NEIGHBOUR] }
    }

    fn take(&mut self, square: f64, index: usize) {
        if square < self.squares[NEIGHBOUR - 1] {
            let rank = self.squares.partition_point(|&nearer| nearer <= square);
            self.squares[rank..].rotate_right(1);
            self.indices[rank..].rotate_right(1);
            (self.squares[rank], self.indices[rank]) = (square, index);
        }
    }
}

/// The eight nearest neighbours of each point.
///
/// Points are taken in the order of their widest coordinate, and each looks both ways until
/// that coordinate alone is farther off.
pub(crate) fn neighbourhoods(points: PointColumns) -> Vec<Neighbourhood> {
    let widest = widest_column(points);
    let mut order: Vec<usize> = (0..points[0].len()).collect();
    order.sort_by(|&i, &j| points[widest][i].total_cmp(&points[widest][j]));
    let sorted: Vec<[f64; 3]> =
        order.iter().map(|&i| [0, 1, 2].map(|k| points[(widest + k) % 3][i])).collect();

    let mut neighbourhoods = vec![Neighbourhood::none(); sorted.len()];
    for (place, &index) in order.iter().enumerate() {
        neighbourhoods[index] = neighbourhood(&sorted, &order, place);
    }
    neighbourhoods
}

fn widest_column(points: PointColumns) -> usize {
    let width = |column: &[f64]| {
        let low = column.iter().copied().fold(f64::INFINITY, f64::min);
        column.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low
    };
    let widths = points.map(width);
    (0..3).fold(0, |widest, k| if widths[k] > widths[widest] { k } else { widest })
}

/// The neighbours of a point among those that are sorted by their first coordinate.
fn neighbourhood(sorted: &[[f64; 3]], order: &[usize], place: usize) -> Neighbourhood {
    let here = sorted[place];
    let mut found = Neighbourhood::none();
    let mut is_within_reach = |other: usize| {
        let [dx, dy, dz] = [0, 1, 2].map(|k| sorted[other][k] - here[k]);
        found.take(dx * dx + dy * dy + dz * dz, order[other]);
        dx * dx < found.squares[NEIGHBOUR - 1]
    };
    let (mut below, mut above) = ((0..place).rev(), place + 1..sorted.len());
    let (mut look_below, mut look_above) = (true, true);
    while look_below || look_above {
        look_below = look_below && below.next().is_some_and(&mut is_within_reach);
        look_above = look_above && above.next().is_some_and(&mut is_within_reach);
    }
    found
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
            assert_eq!(found.indices[..], order[1..=NEIGHBOUR]);
            assert!((found.reach() - all[order[NEIGHBOUR]].sqrt()).abs() < 1e-14);
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
