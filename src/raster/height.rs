//! A superellipsoid seen along its z axis, written into a z-buffer.

use super::z_buffer::ZBuffer;
use crate::machine::Products;
use crate::machine::vectorized::{self, Kernel};
use crate::math::elementary32::{exp2, log2, mul_add, one_less_exp2, parts, parts32};
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
/// `f32` or by a little more. The powers of x and y are calculated once a column and row, and z for one quarter of
/// the pixels, in vector code. Domain: a positive, finite `pixel`; any exponents.
pub fn write_heights(buffer: &mut ZBuffer, shape: &Superellipsoid, placement: &Placement) {
    let [columns, rows] = [0, 1].map(|axis| Axis::new(buffer, shape, placement, axis));
    let [e1, e2] = shape.exponents();
    let mut scratch = [(); 3].map(|()| vec![0.0; columns.powers.len()]);
    for (step, &row_power) in rows.powers.iter().enumerate() {
        let count = columns.powers.partition_point(|power| power + row_power < 1.0);
        let [exponents, fractions, depths] = scratch.each_mut().map(|column| &mut column[..count]);
        vectorized::run(QuarterRow {
            powers: &columns.powers[..count],
            row_power,
            middle: (e2 / e1) as f32,
            outer: (0.5 * e1) as f32,
            size: shape.size()[2] as f32,
            centre_depth: placement.depth as f32,
            exponents,
            fractions,
            depths: &mut *depths,
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

/// The depths of a row from the centre to the outline.
struct QuarterRow<'a> {
    powers: &'a [f64],
    row_power: f64,
    middle: f32,
    outer: f32,
    size: f32,
    centre_depth: f32,
    /// What is raised to a power, in two parts.
    exponents: &'a mut [f32],
    fractions: &'a mut [f32],
    depths: &'a mut [f32],
}

impl Kernel for QuarterRow<'_> {
    type Output = ();

    /// Loops of `f64` and loops of `f32` apart, so that the latter take whole vectors.
    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) {
        let Self { powers, row_power, middle, outer, size, centre_depth, .. } = self;
        let (exponents, fractions) = (self.exponents, self.fractions);
        let is_equal = middle == 1.0;
        for ((k, f), power) in exponents.iter_mut().zip(fractions.iter_mut()).zip(powers) {
            let sum = power + row_power;
            let raised = if is_equal { 1.0 - sum } else { sum };
            [*k, *f] = parts(greater(raised, f64::MIN_POSITIVE));
        }
        if !is_equal {
            for (k, f) in exponents.iter_mut().zip(fractions.iter_mut()) {
                let rest = one_less_exp2::<FMA>(middle * log2::<FMA>([*k, *f]));
                [*k, *f] = parts32(if rest > f32::MIN_POSITIVE { rest } else { f32::MIN_POSITIVE });
            }
        }
        for ((depth, k), f) in self.depths.iter_mut().zip(exponents).zip(fractions) {
            let height = exp2::<FMA>(outer * log2::<FMA>([*k, *f]));
            *depth = mul_add::<FMA>(-size, height, centre_depth);
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
    fn run<const FMA: bool, P: Products>(self) {
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
        // Not as a comparison, which would be compiled to slow masked stores.
        *pixel = pixel.min(depth);
    }
}

#[cfg(test)]
mod tests;
