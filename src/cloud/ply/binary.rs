//! The data of a binary PLY file.

use super::layout::{Element, Property};
use crate::cloud::error::{Place, Problem};
use crate::cloud::input::Input;
use crate::cloud::points::Points;
use crate::cloud::records::{Records, cut_short, expect_rows};
use crate::cloud::scalar::{ByteOrder, Scalar};

/// Reads the rows of an element; those of the vertices are handed on.
///
/// # Errors
/// The input cannot be read or ends too early, or a list has a negative length.
pub(super) fn read(
    input: &mut Input<'_>,
    element: &Element,
    order: ByteOrder,
    points: &mut impl Points,
) -> Result<(), Problem> {
    match element.stride() {
        Some(stride) if element.is_vertex => {
            records(element, stride, order).read(input, element.count, points)
        }
        Some(stride) => skip(input, element, stride),
        None => (Walk { input, element, order }).read(points),
    }
}

/// Where the coordinates of vertices without lists are.
fn records(element: &Element, stride: u64, order: ByteOrder) -> Records<'_> {
    let mut offsets = [0; 3];
    let mut scalars = [Scalar::F32; 3];
    let mut offset = 0;
    for property in &element.properties {
        if let Property::Scalar { scalar, axis } = *property {
            if let Some(axis) = axis {
                offsets[axis] = offset;
                scalars[axis] = scalar;
            }
            offset += scalar.size() as u64;
        }
    }
    Records { element: &element.name, stride, offsets, scalars, order }
}

/// Moves past rows of fixed size.
fn skip(input: &mut Input<'_>, element: &Element, stride: u64) -> Result<(), Problem> {
    expect_rows(input, &element.name, element.count, stride)?;
    let bytes = element.count.saturating_mul(stride);
    let skipped = input.skip(bytes)?;
    if skipped < bytes {
        let row = skipped / stride;
        return Err(cut_short(&element.name, row, input.offset(), element.count, stride));
    }
    Ok(())
}

/// Reads rows whose size varies, value by value.
struct Walk<'w, 'r> {
    input: &'w mut Input<'r>,
    element: &'w Element,
    order: ByteOrder,
}

impl Walk<'_, '_> {
    fn read(&mut self, points: &mut impl Points) -> Result<(), Problem> {
        let Element { name, count, .. } = self.element;
        expect_rows(self.input, name, *count, self.element.least_stride())?;
        for row in 0..*count {
            let point = self.read_row(row)?;
            if self.element.is_vertex {
                points.push(point);
            }
        }
        Ok(())
    }

    fn read_row(&mut self, row: u64) -> Result<[f64; 3], Problem> {
        let mut point = [0.0; 3];
        for property in &self.element.properties {
            match *property {
                Property::Scalar { scalar, axis } => {
                    let value = self.read_value(scalar, row)?;
                    if let Some(axis) = axis {
                        point[axis] = value;
                    }
                }
                Property::List { length, item } => self.skip_list(length, item, row)?,
            }
        }
        Ok(point)
    }

    fn read_value(&mut self, scalar: Scalar, row: u64) -> Result<f64, Problem> {
        let size = scalar.size();
        let found = self.input.fill(size)?.len();
        if found < size {
            let end = self.input.offset() + found as u64;
            return Err(self.malformed(row, end, "a value", "the end of the data"));
        }
        let value = scalar.decode(self.input.at_hand(), self.order);
        self.input.consume(size);
        Ok(value)
    }

    fn skip_list(&mut self, length: Scalar, item: Scalar, row: u64) -> Result<(), Problem> {
        let start = self.input.offset();
        let length = self.read_value(length, row)?;
        if length < 0.0 {
            let found = format!("{length}");
            return Err(self.malformed(row, start, "the length of a list", &found));
        }
        let bytes = length as u64 * item.size() as u64;
        let fits = self.input.remaining().is_none_or(|remaining| bytes <= remaining);
        if !fits || self.input.skip(bytes)? < bytes {
            let expected = format!("a list of {length} values");
            return Err(self.malformed(row, start, &expected, "the end of the data"));
        }
        Ok(())
    }

    fn malformed(&self, row: u64, byte: u64, expected: &str, found: &str) -> Problem {
        let place = Place::BinaryRow { element: self.element.name.clone(), row, byte };
        Problem::malformed(place, expected, found)
    }
}
