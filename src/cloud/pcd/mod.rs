//! The Point Cloud Library's PCD, versions .5 to .7: ASCII, binary and compressed.

mod compressed;
mod header;
#[cfg(test)]
mod tests;

use self::header::{Encoding, Field, Header};
use super::error::{Place, Problem};
use super::input::{CAPACITY, Input};
use super::points::Points;
use super::records::Records;
use super::scalar::{ByteOrder, Scalar};
use super::text_rows::{TextRows, Value};

/// Reads the fields x, y and z of each point.
///
/// # Errors
/// The input cannot be read, the header is malformed or has no fields x, y and z, or the data are
/// not what it declares: too short, too long or not numbers.
pub(super) fn read<P: Points>(input: &mut Input<'_>) -> Result<P, Problem> {
    let header = header::read(input)?;
    if header.points == 0 {
        return Err(Problem::NoPoints("the header declares 0 points"));
    }
    let stride = header.fields.iter().fold(0_u64, |sum, field| sum.saturating_add(field.size()));
    if stride > CAPACITY as u64 {
        return Err(Problem::malformed(
            Place::Line(input.line_number()),
            format!("points of at most {CAPACITY} bytes"),
            format!("points of {stride} bytes"),
        ));
    }
    let points = match header.encoding {
        Encoding::Ascii => read_text(input, &header)?,
        Encoding::Binary => {
            input.end_of_lines(header.points.checked_mul(stride))?;
            read_binary(input, &header, stride)?
        }
        Encoding::Compressed => {
            input.end_of_lines(None)?;
            compressed::read(input, &header, stride)?
        }
    };
    input.expect_padding()?;
    Ok(points)
}

fn read_text<P: Points>(input: &mut Input<'_>, header: &Header) -> Result<P, Problem> {
    let values = |field: &Field| {
        let value = field.axis.map_or(Value::Other, Value::Coordinate);
        std::iter::repeat_n(value, field.count as usize)
    };
    let values: Vec<_> = header.fields.iter().flat_map(values).collect();
    let row_bytes = 2 * values.len() as u64;
    let mut points = P::with_capacity(input.room_for(header.points, row_bytes));
    let rows = TextRows { element: "point", values };
    rows.read(input, header.points, Some(&mut points))?;
    Ok(points)
}

fn read_binary<P: Points>(
    input: &mut Input<'_>,
    header: &Header,
    stride: u64,
) -> Result<P, Problem> {
    let mut offsets = [0; 3];
    let mut scalars = [Scalar::F32; 3];
    let mut offset = 0;
    for field in &header.fields {
        if let Some(axis) = field.axis {
            offsets[axis] = offset;
            scalars[axis] = field.scalar;
        }
        offset += field.size();
    }
    let order = ByteOrder::Little;
    let records = Records { element: "point", stride, offsets, scalars, order };
    let mut points = P::with_capacity(input.room_for(header.points, stride));
    records.read(input, header.points, &mut points)?;
    Ok(points)
}
