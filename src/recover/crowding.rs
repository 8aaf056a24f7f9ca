//! Where points crowd: those of a surface have nearer neighbours than those strewn in space.

use crate::cloud::PointColumns;

/// The neighbour whose distance tells how crowded a place is: near enough to stay on the
/// surface, far enough not to be chance.
const NEIGHBOUR: usize = 6;

/// Indices of the points, the most crowded first: by the distance of the sixth neighbour.
///
/// All pairs are tried, so the points must be few.
pub(crate) fn by_crowding(points: PointColumns) -> Vec<usize> {
    let count = points[0].len();
    let reach: Vec<f64> = (0..count).map(|i| neighbour_distance(points, i)).collect();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&i, &j| reach[i].total_cmp(&reach[j]));
    order
}

/// The squared distance of a point's sixth neighbour; infinite where there are fewer.
fn neighbour_distance(points: PointColumns, index: usize) -> f64 {
    let [xs, ys, zs] = points;
    let [x, y, z] = points.map(|column| column[index]);
    // Ascending; the first is the point itself.
    let mut nearest = [f64::INFINITY; NEIGHBOUR + 1];
    for ((px, py), pz) in xs.iter().zip(ys).zip(zs) {
        let square = (px - x).powi(2) + (py - y).powi(2) + (pz - z).powi(2);
        if square < nearest[NEIGHBOUR] {
            let place = nearest.partition_point(|&other| other <= square);
            nearest[place..].rotate_right(1);
            nearest[place] = square;
        }
    }
    nearest[NEIGHBOUR]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cluster_comes_before_the_points_around_it() {
        let column = |k: usize| -> Vec<f64> {
            let strewn = (0..20).map(|i| f64::from((i * (7 + 4 * k as i32)) % 20));
            strewn.chain((0..20).map(|i| 5.0 + 1e-3 * f64::from(i))).collect()
        };
        let columns = [column(0), column(1), column(2)];
        let order = by_crowding([&columns[0], &columns[1], &columns[2]]);
        assert_eq!(order.len(), 40);
        assert!(order[..20].iter().all(|&i| i >= 20));
    }

    #[test]
    fn the_sixth_neighbour_counts_and_too_few_points_have_none() {
        let x: Vec<f64> = (0..7).map(f64::from).collect();
        let zero = [0.0; 7];
        assert_eq!(neighbour_distance([&x, &zero, &zero], 0), 36.0);
        assert_eq!(neighbour_distance([&x, &zero, &zero], 3), 9.0);
        assert_eq!(neighbour_distance([&x[..3], &zero[..3], &zero[..3]], 0), f64::INFINITY);
    }
}
