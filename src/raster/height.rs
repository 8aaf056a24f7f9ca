//! A superellipsoid seen along its z axis, written into a z-buffer.

use super::z_buffer::ZBuffer;
use crate::math::elementary::power;
use crate::math::vectorized::{self, Kernel};
use crate::shape::Superellipsoid;

/// Where a parallel view along its z axis sees a superellipsoid: its x axis along the rows, its
/// y axis along the columns of pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// The pixel of the centre, column and row, moved to the next half pixel: pixels are then
    /// symmetric about it.
    pub centre: [f64; 2],
    /// Depth of the centre, in the shape's unit.
    pub depth: f64,
    /// Side of a pixel, in the shape's unit.
    pub pixel: f64,
}

/// Centres are no further off than that, in half pixels.
const FARTHEST_CENTRE: f64 = 1e12;

/// Writes the surface into the z-buffer where it is nearer than what is there.
///
/// Each pixel whose middle is in the outline is given the depth of the surface there, `depth - z`
/// with z of the explicit equation (JLS Eq. 2.70, its outer exponent corrected), rounded to
/// `f32`. The powers of x and y are calculated once a column and row, and z for one quarter of
/// the pixels, in vector code. Domain: a positive, finite `pixel`; any exponents.
pub fn write_heights(buffer: &mut ZBuffer, shape: &Superellipsoid, placement: &Placement) {
    let [columns, rows] = [0, 1].map(|axis| Axis::new(buffer, shape, placement, axis));
    let [e1, e2] = shape.exponents();
    let mut scratch = Scratch::new(columns.powers.len());
    for (step, &row_power) in rows.powers.iter().enumerate() {
        let count = columns.powers.partition_point(|power| power + row_power < 1.0);
        let depths = &mut scratch.depths[..count];
        vectorized::run(QuarterRow {
            powers: &columns.powers[..count],
            row_power,
            middle: e2 / e1,
            outer: 0.5 * e1,
            size: shape.size()[2],
            centre_depth: placement.depth,
            shares: &mut scratch.shares[..count],
            depths,
        });
        let step = step as isize;
        for row in [rows.first_above + step, rows.first_below - step] {
            if let Some(pixels) = buffer.row_mut(row) {
                vectorized::run(Reflection { pixels, depths, axis: &columns });
            }
        }
    }
}

/// The pixels along one axis, from the one of the buffer next to the centre outwards.
struct Axis {
    /// The first pixel not below the centre, and the first not above it.
    first_above: isize,
    first_below: isize,
    /// `(|x|/a)^(2/e2)` at each, below 1.
    powers: Vec<f64>,
}

impl Axis {
    fn new(buffer: &ZBuffer, shape: &Superellipsoid, placement: &Placement, axis: usize) -> Self {
        let side = buffer.size()[axis] as isize;
        let half_pixels =
            (2.0 * placement.centre[axis]).round().clamp(-FARTHEST_CENTRE, FARTHEST_CENTRE);
        let [above, below] = [
            half_pixels.div_euclid(2.0) + half_pixels.rem_euclid(2.0),
            half_pixels.div_euclid(2.0),
        ]
        .map(|pixel| pixel as isize);
        // Steps from the centre to the buffer's nearest and furthest pixel.
        let nearest = (-above).max(below - (side - 1)).max(0);
        let furthest = (side - 1 - above).max(below);
        let ratio = |step: isize| {
            let pixels = (above + step) as f64 - 0.5 * half_pixels;
            pixels * placement.pixel / shape.size()[axis]
        };
        let exponent = 2.0 / shape.exponents()[1];
        let powers = (nearest..=furthest)
            .map(ratio)
            .take_while(|&ratio| ratio < 1.0)
            .map(|ratio| ratio.powf(exponent))
            .collect();
        Self { first_above: above + nearest, first_below: below - nearest, powers }
    }
}

/// What a row is calculated in, kept for the next.
struct Scratch {
    shares: Vec<f64>,
    depths: Vec<f32>,
}

impl Scratch {
    fn new(length: usize) -> Self {
        Self { shares: vec![0.0; length], depths: vec![0.0; length] }
    }
}

/// The depths of a row from the centre to the outline.
struct QuarterRow<'a> {
    powers: &'a [f64],
    row_power: f64,
    middle: f64,
    outer: f64,
    size: f64,
    centre_depth: f64,
    shares: &'a mut [f64],
    depths: &'a mut [f32],
}

impl Kernel for QuarterRow<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const FMA: bool>(self) {
        for (share, power) in self.shares.iter_mut().zip(self.powers) {
            *share = greater(power + self.row_power, f64::MIN_POSITIVE);
        }
        if self.middle != 1.0 {
            for share in self.shares.iter_mut() {
                *share = power::<FMA>(*share, self.middle);
            }
        }
        for (depth, share) in self.depths.iter_mut().zip(self.shares) {
            let rest = greater(1.0 - *share, f64::MIN_POSITIVE);
            *depth = (self.centre_depth - self.size * power::<FMA>(rest, self.outer)) as f32;
        }
    }
}

/// The greater of two numbers, as one vector instruction.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The depths of half a row, put on both sides of the centre.
struct Reflection<'a> {
    pixels: &'a mut [f32],
    depths: &'a [f32],
    axis: &'a Axis,
}

impl Kernel for Reflection<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const FMA: bool>(self) {
        let Axis { first_above, first_below, .. } = *self.axis;
        let (pixels, depths) = (self.pixels, self.depths);
        let (side, count) = (pixels.len() as isize, depths.len() as isize);
        // Steps from the centre whose pixels are in the buffer.
        let [start, end] = [(-first_above).clamp(0, count), (side - first_above).clamp(0, count)];
        if start < end {
            let right = &mut pixels[(first_above + start) as usize..];
            keep_nearer(right.iter_mut(), &depths[start as usize..end as usize]);
        }
        let [start, end] =
            [(first_below + 1 - side).clamp(0, count), (first_below + 1).clamp(0, count)];
        if start < end {
            let left = &mut pixels[..=(first_below - start) as usize];
            keep_nearer(left.iter_mut().rev(), &depths[start as usize..end as usize]);
        }
    }
}

#[inline(always)]
fn keep_nearer<'a>(pixels: impl Iterator<Item = &'a mut f32>, depths: &[f32]) {
    for (pixel, &depth) in pixels.zip(depths) {
        *pixel = if depth < *pixel { depth } else { *pixel };
    }
}

#[cfg(test)]
mod tests;
