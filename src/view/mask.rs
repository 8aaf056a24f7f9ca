//! Which pixels are of the object, and how far the others are from it.

use std::path::Path;

use png::Transformations;

use super::error::{ImageError, ImageProblem};
use super::image::read_png;

/// Pixels of an object.
#[derive(Debug, Clone, PartialEq)]
pub struct Mask {
    /// Columns and rows.
    size: [u32; 2],
    is_object: Vec<bool>,
}

impl Mask {
    /// Reads a PNG image of any kind: a pixel is of the object where a channel other than that of
    /// opacity is not 0.
    ///
    /// # Errors
    /// If the file is not a PNG image, is damaged, or has more than 64 million pixels.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ImageError> {
        let path = path.as_ref();
        // To whole bytes: a palette to its colours, 16 bits kept.
        let pixels = read_png(path, Transformations::EXPAND)
            .map_err(|problem| ImageError::new(path, problem))?;
        let channel_bytes = pixels.depth as usize / 8;
        let channels = pixels.color.samples();
        let opaque = channels - usize::from(matches!(channels, 2 | 4));
        let of_pixel = |pixel: &[u8]| pixel[..opaque * channel_bytes].iter().any(|byte| *byte != 0);
        let is_object = pixels.bytes.chunks_exact(channels * channel_bytes).map(of_pixel).collect();
        Ok(Self { size: pixels.size, is_object })
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Whether each pixel is of the object, row by row.
    pub fn is_object(&self) -> &[bool] {
        &self.is_object
    }

    /// Refuses a size other than an image's.
    pub(super) fn require_size(&self, expected: [u32; 2]) -> Result<(), ImageProblem> {
        if self.size == expected {
            return Ok(());
        }
        Err(ImageProblem::Size { expected, found: self.size, of: "the depth map" })
    }

    /// The object without its rim: the pixels more than so many steps from what is not of it.
    pub(super) fn without_rim(&self, steps: u32) -> Self {
        let others = Self { is_object: self.is_object.iter().map(|is| !is).collect(), ..*self };
        let is_inner = others.distances().into_iter().map(|distance| distance > steps);
        Self { is_object: is_inner.collect(), ..*self }
    }

    /// Steps of a king in chess from each pixel to the object; all the same great number where
    /// there is none. Two passes, each taking the least of its neighbours before.
    pub(super) fn distances(&self) -> Vec<u32> {
        let [width, height] = self.size.map(|side| side as usize);
        let far = u32::MAX - 1;
        let mut distances: Vec<u32> =
            self.is_object.iter().map(|is_object| if *is_object { 0 } else { far }).collect();
        let relax = |distances: &mut Vec<u32>, column: usize, row: usize, turn: isize| {
            let here = row * width + column;
            for (dx, dy) in [(-1, 0), (-1, -1), (0, -1), (1, -1)] {
                let x = column.checked_add_signed(turn * dx).filter(|x| *x < width);
                let y = row.checked_add_signed(turn * dy).filter(|y| *y < height);
                if let (Some(x), Some(y)) = (x, y) {
                    distances[here] = distances[here].min((distances[y * width + x] + 1).min(far));
                }
            }
        };
        for row in 0..height {
            (0..width).for_each(|column| relax(&mut distances, column, row, 1));
        }
        for row in (0..height).rev() {
            (0..width).rev().for_each(|column| relax(&mut distances, column, row, -1));
        }
        distances
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rim_of_two_pixels_is_taken_off() {
        let is_object = |i: i64| (1..8).contains(&(i % 9)) && (1..8).contains(&(i / 9));
        let mask = Mask { size: [9, 9], is_object: (0..81).map(is_object).collect() };
        let inner = mask.without_rim(2);
        let expected = |i: i64| (3..6).contains(&(i % 9)) && (3..6).contains(&(i / 9));
        assert_eq!(inner.is_object, (0..81).map(expected).collect::<Vec<_>>());
    }

    #[test]
    fn distances_are_those_of_a_king() {
        let size = [13, 9];
        let objects = [[3_i64, 4_i64], [10, 0]];
        let is_object =
            (0..9).flat_map(|row| (0..13).map(move |column| objects.contains(&[column, row])));
        let mask = Mask { size, is_object: is_object.collect() };
        for (index, distance) in mask.distances().into_iter().enumerate() {
            let (column, row) = ((index % 13) as i64, (index / 13) as i64);
            let to = |[x, y]: &[i64; 2]| (column - x).abs().max((row - y).abs());
            assert_eq!(i64::from(distance), objects.iter().map(to).min().unwrap());
        }
        let nothing = Mask { size, is_object: vec![false; 13 * 9] };
        assert!(nothing.distances().iter().all(|distance| *distance > 1_000_000));
    }
}
