//! Distances of neighbours among few points.

use crate::cloud::PointColumns;

/// The neighbour whose distance counts: near enough to stay on a surface, far enough not to be
/// chance.
pub(crate) const NEIGHBOUR: usize = 8;

/// Of each point the distance of its eighth neighbour; infinite where there are fewer.
///
/// Points are taken in the order of their widest coordinate, and each looks both ways until
/// that coordinate alone is farther off.
pub(crate) fn neighbour_distances(points: PointColumns) -> Vec<f64> {
    let widest = widest_column(points);
    let mut order: Vec<usize> = (0..points[0].len()).collect();
    order.sort_by(|&i, &j| points[widest][i].total_cmp(&points[widest][j]));
    let sorted: Vec<[f64; 3]> =
        order.iter().map(|&i| [0, 1, 2].map(|k| points[(widest + k) % 3][i])).collect();

    let mut distances = vec![0.0; sorted.len()];
    for (place, index) in order.into_iter().enumerate() {
        distances[index] = neighbour_square(&sorted, place).sqrt();
    }
    distances
}

fn widest_column(points: PointColumns) -> usize {
    let width = |column: &[f64]| {
        let low = column.iter().copied().fold(f64::INFINITY, f64::min);
        column.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low
    };
    let widths = points.map(width);
    (0..3).fold(0, |widest, k| if widths[k] > widths[widest] { k } else { widest })
}

/// The squared distance of the eighth neighbour among points that are sorted by their first
/// coordinate.
fn neighbour_square(sorted: &[[f64; 3]], place: usize) -> f64 {
    let here = sorted[place];
    // Ascending.
    let mut nearest = [f64::INFINITY; NEIGHBOUR];
    let mut is_within_reach = |other: &[f64; 3]| {
        let [dx, dy, dz] = [0, 1, 2].map(|k| other[k] - here[k]);
        let square = dx * dx + dy * dy + dz * dz;
        if square < nearest[NEIGHBOUR - 1] {
            let rank = nearest.partition_point(|&nearer| nearer <= square);
            nearest[rank..].rotate_right(1);
            nearest[rank] = square;
        }
        dx * dx < nearest[NEIGHBOUR - 1]
    };
    let (mut below, mut above) = (sorted[..place].iter().rev(), sorted[place + 1..].iter());
    let (mut look_below, mut look_above) = (true, true);
    while look_below || look_above {
        look_below = look_below && below.next().is_some_and(&mut is_within_reach);
        look_above = look_above && above.next().is_some_and(&mut is_within_reach);
    }
    nearest[NEIGHBOUR - 1]
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
        for (i, distance) in neighbour_distances(points).into_iter().enumerate() {
            let mut all = squares(i);
            all.sort_by(f64::total_cmp);
            // The first is the point itself.
            assert!((distance - all[NEIGHBOUR].sqrt()).abs() < 1e-14);
        }
    }

    #[test]
    fn too_few_points_have_no_eighth_neighbour_and_twins_are_at_no_distance() {
        let zero = [0.0; 9];
        assert_eq!(neighbour_distances([&zero; 3].map(|c| &c[..])), [0.0; 9]);
        assert_eq!(neighbour_distances([&zero[..8]; 3]), [f64::INFINITY; 8]);
        assert_eq!(neighbour_distances([&[]; 3]), Vec::<f64>::new());
    }
}
