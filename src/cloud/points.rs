//! What a reader gathers the points of a file in.

use super::PointColumns;

/// Finite points, gathered row by row or block by block; rows that are not finite are skipped.
pub(super) trait Points: Sized {
    /// None yet, with room for `capacity` points.
    fn with_capacity(capacity: usize) -> Self;

    /// The number of rows so far: points kept and rows skipped.
    fn rows(&self) -> usize;

    /// Keeps a finite point.
    fn keep(&mut self, point: [f64; 3]);

    /// Keeps the finite points of three columns of one length.
    fn keep_all(&mut self, columns: PointColumns<'_>);

    /// Notes that the next row is skipped.
    fn skip(&mut self);

    /// Takes the next row.
    #[inline]
    fn push(&mut self, row: [f64; 3]) {
        if row.iter().all(|coordinate| coordinate.is_finite()) {
            self.keep(row);
        } else {
            self.skip();
        }
    }

    /// Takes the next rows, as three columns of one length.
    fn append(&mut self, columns: PointColumns<'_>) {
        if columns.iter().all(|column| all_finite(column)) {
            self.keep_all(columns);
        } else {
            rows_of(columns).for_each(|row| self.push(row));
        }
    }

    /// Takes the rows of three columns of one length.
    fn from_columns(columns: [Vec<f64>; 3]) -> Self {
        let mut points = Self::with_capacity(columns[0].len());
        points.append(columns.each_ref().map(Vec::as_slice));
        points
    }
}

/// The rows of three columns of one length.
pub(super) fn rows_of([x, y, z]: PointColumns<'_>) -> impl ExactSizeIterator<Item = [f64; 3]> {
    x.iter().zip(y).zip(z).map(|((x, y), z)| [*x, *y, *z])
}

/// Whether all numbers are finite. It looks at all of them, which is faster than to stop at the
/// first that is not.
pub(super) fn all_finite(numbers: &[f64]) -> bool {
    numbers.iter().fold(true, |all, number| all & number.is_finite())
}
