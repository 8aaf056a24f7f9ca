//! A z-buffer: for every pixel, how far away the nearest surface is.

use thiserror::Error;

/// Depths by pixel, row by row; infinite where nothing is.
#[derive(Debug, Clone, PartialEq)]
pub struct ZBuffer {
    size: [usize; 2],
    depths: Vec<f32>,
}

/// A size that no [`ZBuffer`] has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("a z-buffer must have 1 to {most} columns and rows, found {columns} x {rows}", most = ZBuffer::MAX)]
pub struct ZBufferError {
    /// Columns asked for.
    pub columns: usize,
    /// Rows asked for.
    pub rows: usize,
}

impl ZBuffer {
    /// Most columns, and most rows: 1 GB in all.
    pub const MAX: usize = 1 << 14;

    /// A z-buffer in which nothing is yet.
    ///
    /// # Errors
    /// If there is not at least one column and row, or more than [`MAX`](Self::MAX) of them.
    pub fn new(columns: usize, rows: usize) -> Result<Self, ZBufferError> {
        if ![columns, rows].iter().all(|side| (1..=Self::MAX).contains(side)) {
            return Err(ZBufferError { columns, rows });
        }
        Ok(Self { size: [columns, rows], depths: vec![f32::INFINITY; columns * rows] })
    }

    /// Columns and rows.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The depths, row by row, in the unit in which they were written.
    pub fn depths(&self) -> &[f32] {
        &self.depths
    }

    /// Takes away what is in it.
    pub fn clear(&mut self) {
        self.depths.fill(f32::INFINITY);
    }

    /// Puts a point of a surface in a pixel, and says whether it is nearer than what was there.
    /// A pixel beside the buffer takes nothing.
    pub fn put(&mut self, [column, row]: [isize; 2], depth: f32) -> bool {
        let Some(index) = self.index([column, row]) else { return false };
        let is_nearer = depth < self.depths[index];
        if is_nearer {
            self.depths[index] = depth;
        }
        is_nearer
    }

    /// The place of a pixel in [`depths`](Self::depths), if it is in the buffer.
    pub fn index(&self, [column, row]: [isize; 2]) -> Option<usize> {
        let [columns, rows] = self.size;
        let is_inside =
            (0..columns as isize).contains(&column) && (0..rows as isize).contains(&row);
        is_inside.then(|| row as usize * columns + column as usize)
    }

    /// The depths of a row; none beside the buffer.
    pub(super) fn row_mut(&mut self, row: isize) -> Option<&mut [f32]> {
        let start = self.index([0, row])?;
        Some(&mut self.depths[start..start + self.size[0]])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_point_stays_and_points_beside_are_left_out() {
        let mut buffer = ZBuffer::new(3, 2).unwrap();
        assert!(buffer.put([2, 1], 5.0) && buffer.put([2, 1], 4.0) && !buffer.put([2, 1], 4.5));
        assert!(![[3, 0], [-1, 0], [0, 2], [0, -1]].iter().any(|&pixel| buffer.put(pixel, 0.0)));
        assert_eq!(buffer.depths()[5], 4.0);
        assert!(buffer.depths()[..5].iter().all(|depth| depth.is_infinite()));
        buffer.clear();
        assert_eq!(buffer, ZBuffer::new(3, 2).unwrap());
    }

    #[test]
    fn sizes_of_nothing_and_beyond_memory_are_refused() {
        for (columns, rows) in [(0, 1), (1, 0), (ZBuffer::MAX + 1, 1)] {
            assert_eq!(ZBuffer::new(columns, rows), Err(ZBufferError { columns, rows }));
        }
    }
}
