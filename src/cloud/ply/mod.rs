//! Stanford PLY: ASCII and binary, with whatever else than vertices the file may hold.

mod binary;
mod header;
mod layout;
#[cfg(test)]
mod tests;

use ply_rs_bw::ply::Encoding;

use self::layout::{Element, Property};
use super::error::{Place, Problem};
use super::input::Input;
use super::points::Points;
use super::scalar::ByteOrder;
use super::text_rows::{TextRows, Value};

/// Reads the vertices of a PLY file; all other elements are checked for length and left out.
///
/// # Errors
/// The input cannot be read, the header is malformed or declares no vertices with x, y and z, or
/// the data are not what it declares: too short, too long or not numbers.
pub(super) fn read<P: Points>(input: &mut Input<'_>) -> Result<P, Problem> {
    let header = header::read(input)?;
    let elements = layout::elements(&header, &Place::Line(input.line_number()))?;
    let order = match header.encoding {
        Encoding::Ascii => None,
        Encoding::BinaryLittleEndian => Some(ByteOrder::Little),
        Encoding::BinaryBigEndian => Some(ByteOrder::Big),
    };
    if order.is_some() {
        input.end_of_lines(layout::data_bytes(&elements))?;
    }
    let mut points = P::with_capacity(0);
    for element in &elements {
        if element.is_vertex {
            let row_bytes = match order {
                Some(_) => element.least_stride(),
                None => 2 * element.properties.len() as u64,
            };
            points = P::with_capacity(input.room_for(element.count, row_bytes));
        }
        match order {
            Some(order) => binary::read(input, element, order, &mut points)?,
            None => read_text(input, element, &mut points)?,
        }
    }
    input.expect_padding()?;
    Ok(points)
}

fn read_text(
    input: &mut Input<'_>,
    element: &Element,
    points: &mut impl Points,
) -> Result<(), Problem> {
    let value = |property: &Property| match property {
        Property::Scalar { axis: Some(axis), .. } => Value::Coordinate(*axis),
        Property::Scalar { axis: None, .. } => Value::Other,
        Property::List { .. } => Value::List,
    };
    let values = element.properties.iter().map(value).collect();
    let rows = TextRows { element: &element.name, values };
    rows.read(input, element.count, element.is_vertex.then_some(points))
}
