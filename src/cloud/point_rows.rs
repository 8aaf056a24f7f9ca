//! Finite points in rows.

use super::PointColumns;
use super::points::{Points, rows_of};
use crate::machine::room;

/// Finite points in world coordinates, one after another, as arrays of shape (n, 3) hold them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PointRows {
    /// The points kept.
    pub points: Vec<[f64; 3]>,
    /// Indices, ascending, of the input rows that were skipped because they were not finite.
    pub skipped_rows: Vec<usize>,
}

impl Points for PointRows {
    fn with_capacity(capacity: usize) -> Self {
        Self { points: room::with_capacity(capacity), skipped_rows: Vec::new() }
    }

    fn rows(&self) -> usize {
        self.points.len() + self.skipped_rows.len()
    }

    fn keep(&mut self, point: [f64; 3]) {
        self.points.push(point);
    }

    fn keep_all(&mut self, columns: PointColumns<'_>) {
        self.points.extend(rows_of(columns));
    }

    fn skip(&mut self) {
        self.skipped_rows.push(self.rows());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::PointCloud;

    #[test]
    fn rows_are_kept_and_skipped_as_in_a_cloud() {
        let columns =
            [vec![1.0, f64::NAN, 0.0, 4.0], vec![2.0, 0.0, f64::INFINITY, 5.0], vec![3.0; 4]];
        let mut rows = PointRows::from_columns(columns.clone());
        let mut cloud = PointCloud::from_columns(columns);
        for points in [[6.0; 3], [f64::NEG_INFINITY; 3], [7.0; 3]] {
            let column = |axis: usize| [points[axis], 8.0];
            rows.append([&column(0), &column(1), &column(2)]);
            cloud.append([&column(0), &column(1), &column(2)]);
        }
        assert!(rows.points.iter().copied().eq(cloud.points()));
        assert_eq!(rows.skipped_rows, [1, 2, 6]);
        assert_eq!(rows.skipped_rows, cloud.skipped_rows());
        assert_eq!(rows.rows(), 10);
    }
}
