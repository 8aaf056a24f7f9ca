//! A cloud of finite points, stored as three coordinate columns.

use super::points::{Points, all_finite};
use crate::machine::room;

/// Columns x, y, z of equally many points.
pub type PointColumns<'a> = [&'a [f64]; 3];

/// Finite points in world coordinates, one column per coordinate.
///
/// Lengths are in the cloud's own unit, whatever that is. A row with a coordinate that is not
/// finite is never stored: [`push`](Self::push) counts it as skipped and remembers its index.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PointCloud {
    x: Vec<f64>,
    y: Vec<f64>,
    z: Vec<f64>,
    skipped_rows: Vec<usize>,
}

impl PointCloud {
    /// An empty cloud.
    pub fn new() -> Self {
        Self::default()
    }

    /// An empty cloud with room for `capacity` points.
    pub fn with_capacity(capacity: usize) -> Self {
        Self {
            x: room::with_capacity(capacity),
            y: room::with_capacity(capacity),
            z: room::with_capacity(capacity),
            skipped_rows: Vec::new(),
        }
    }

    /// A cloud of the given rows `[x, y, z]`; those that are not finite are skipped and counted.
    pub fn from_rows(rows: impl IntoIterator<Item = [f64; 3]>) -> Self {
        let rows = rows.into_iter();
        let mut cloud = Self::with_capacity(rows.size_hint().0);
        rows.for_each(|row| cloud.push(row));
        cloud
    }

    /// Appends the next input row, or counts it as skipped if a coordinate is not finite.
    #[inline]
    pub fn push(&mut self, row: [f64; 3]) {
        Points::push(self, row);
    }

    /// The number of points kept.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Whether no point was kept.
    pub fn is_empty(&self) -> bool {
        self.x.is_empty()
    }

    /// The number of input rows: points kept and rows skipped.
    pub fn rows(&self) -> usize {
        self.len() + self.skipped_rows.len()
    }

    /// Indices, ascending, of the input rows that were skipped because they were not finite.
    pub fn skipped_rows(&self) -> &[usize] {
        &self.skipped_rows
    }

    /// The point at `index`, counted among the points kept.
    ///
    /// # Panics
    /// If `index >= self.len()`.
    pub fn point(&self, index: usize) -> [f64; 3] {
        [self.x[index], self.y[index], self.z[index]]
    }

    /// The points kept, in order.
    pub fn points(&self) -> impl ExactSizeIterator<Item = [f64; 3]> + Clone + '_ {
        (0..self.len()).map(|index| self.point(index))
    }

    /// The x, y and z columns, each of length [`len`](Self::len).
    pub fn columns(&self) -> PointColumns<'_> {
        [&self.x, &self.y, &self.z]
    }
}

impl Points for PointCloud {
    fn with_capacity(capacity: usize) -> Self {
        Self::with_capacity(capacity)
    }

    fn rows(&self) -> usize {
        self.rows()
    }

    #[inline]
    fn keep(&mut self, [x, y, z]: [f64; 3]) {
        self.x.push(x);
        self.y.push(y);
        self.z.push(z);
    }

    fn keep_all(&mut self, [x, y, z]: PointColumns<'_>) {
        self.x.extend_from_slice(x);
        self.y.extend_from_slice(y);
        self.z.extend_from_slice(z);
    }

    fn skip(&mut self) {
        self.skipped_rows.push(self.rows());
    }

    /// The columns themselves, where all is finite.
    fn from_columns([x, y, z]: [Vec<f64>; 3]) -> Self {
        if [&x, &y, &z].into_iter().all(|column| all_finite(column)) {
            return Self { x, y, z, skipped_rows: Vec::new() };
        }
        let mut cloud = Self::with_capacity(x.len());
        cloud.append([&x, &y, &z]);
        cloud
    }
}

impl FromIterator<[f64; 3]> for PointCloud {
    fn from_iter<I: IntoIterator<Item = [f64; 3]>>(rows: I) -> Self {
        Self::from_rows(rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_are_not_finite_are_skipped_and_their_indices_kept() {
        let cloud = PointCloud::from_rows([
            [1.0, 2.0, 3.0],
            [f64::NAN, 0.0, 0.0],
            [0.0, f64::INFINITY, 0.0],
            [4.0, 5.0, 6.0],
        ]);
        assert_eq!(cloud.columns(), [&[1.0, 4.0], &[2.0, 5.0], &[3.0, 6.0]]);
        assert_eq!(cloud.skipped_rows(), [1, 2]);
        assert_eq!(cloud.rows(), 4);
        let [x, y, z] = cloud.columns().map(<[f64]>::to_vec);
        assert!(PointCloud::from_columns([x, y, z]).skipped_rows().is_empty());
        let columns = [vec![1.0, f64::NAN, 0.0, 4.0], vec![2.0, 0.0, f64::INFINITY, 5.0]];
        let [x, y] = columns;
        assert_eq!(PointCloud::from_columns([x, y, vec![3.0, 0.0, 0.0, 6.0]]), cloud);
    }
}
