//! Coordinates in binary rows of one fixed size, or in columns.

use super::error::{Place, Problem};
use super::input::{CAPACITY, Input};
use super::points::Points;
use super::scalar::{ByteOrder, Scalar};
use crate::machine::room;

/// The rows decoded at a time, so few that they and their columns stay in the first-level cache.
const BLOCK: usize = 512;

/// Where in a binary row of fixed size the three coordinates are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Records<'n> {
    /// What the rows are called in messages.
    pub element: &'n str,
    /// The bytes of a row.
    pub stride: u64,
    /// The first byte, within a row, of x, y and z.
    pub offsets: [u64; 3],
    /// The types of x, y and z.
    pub scalars: [Scalar; 3],
    /// The order of the bytes of each number.
    pub order: ByteOrder,
}

impl Records<'_> {
    /// Reads `count` rows and hands their coordinates on.
    ///
    /// # Errors
    /// The input cannot be read or ends too early, or a row is longer than [`CAPACITY`].
    pub fn read(
        &self,
        input: &mut Input<'_>,
        count: u64,
        points: &mut impl Points,
    ) -> Result<(), Problem> {
        if self.stride == 0 || self.stride > CAPACITY as u64 {
            return Err(Problem::malformed(
                Place::Byte(input.offset()),
                format!("rows of 1 to {CAPACITY} bytes"),
                format!("rows of {} bytes", self.stride),
            ));
        }
        let stride = self.stride as usize;
        let mut columns = [const { Vec::new() }; 3];
        for_each_block(input, self.element, count, stride, |rows| {
            columns.iter_mut().for_each(Vec::clear);
            self.decode(rows, &mut columns);
            points.append(columns.each_ref().map(Vec::as_slice));
        })
    }

    /// Appends the coordinates of whole rows to the columns.
    fn decode(&self, rows: &[u8], columns: &mut [Vec<f64>; 3]) {
        for (axis, column) in columns.iter_mut().enumerate() {
            let offset = self.offsets[axis] as usize;
            let rows = rows.chunks_exact(self.stride as usize);
            self.scalars[axis].append(rows.map(|row| &row[offset..]), self.order, column);
        }
    }
}

/// Reads `count` rows of `stride` bytes, and hands them on some whole rows at a time.
///
/// # Errors
/// The input cannot be read or ends too early.
fn for_each_block(
    input: &mut Input<'_>,
    element: &str,
    count: u64,
    stride: usize,
    mut action: impl FnMut(&[u8]),
) -> Result<(), Problem> {
    expect_rows(input, element, count, stride as u64)?;
    let mut left = count;
    while left > 0 {
        let found = input.fill(stride)?.len();
        let rows = left.min((found / stride) as u64);
        if rows == 0 {
            let end = input.offset() + found as u64;
            return Err(cut_short(element, count - left, end, count, stride as u64));
        }
        let length = rows as usize * stride;
        input.at_hand()[..length].chunks(BLOCK * stride).for_each(&mut action);
        input.consume(length);
        left -= rows;
    }
    Ok(())
}

/// Checks `count` rows of `stride` bytes against what is left of an input of known size.
///
/// # Errors
/// The rest is too short.
pub(super) fn expect_rows(
    input: &Input<'_>,
    element: &str,
    count: u64,
    stride: u64,
) -> Result<(), Problem> {
    match input.remaining() {
        Some(remaining) if stride > 0 && count > remaining / stride => {
            let end = input.offset() + remaining;
            Err(cut_short(element, remaining / stride, end, count, stride))
        }
        _ => Ok(()),
    }
}

/// The error for data that end at byte `end`, within or before the given row.
pub(super) fn cut_short(element: &str, row: u64, end: u64, count: u64, stride: u64) -> Problem {
    let place = Place::BinaryRow { element: element.into(), row, byte: end };
    let expected = format!("{count} rows of {stride} bytes");
    Problem::malformed(place, expected, "the end of the data")
}

/// Reads a column of `count` numbers.
///
/// # Errors
/// The input cannot be read or ends too early.
pub(super) fn read_column(
    input: &mut Input<'_>,
    scalar: Scalar,
    order: ByteOrder,
    count: u64,
) -> Result<Vec<f64>, Problem> {
    let size = scalar.size();
    let mut column = room::with_capacity(input.room_for(count, size as u64));
    for_each_block(input, "point", count, size, |numbers| {
        scalar.append(numbers.chunks_exact(size), order, &mut column);
    })?;
    Ok(column)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::PointCloud;

    fn records(stride: u64, offsets: [u64; 3], scalars: [Scalar; 3]) -> Records<'static> {
        Records { element: "point", stride, offsets, scalars, order: ByteOrder::Big }
    }

    #[test]
    fn rows_are_decoded_by_offset_and_type() {
        let mut bytes = Vec::new();
        for row in 0..3u8 {
            bytes.push(row);
            bytes.extend(f64::from(row).to_be_bytes());
            bytes.extend((-i16::from(row)).to_be_bytes());
        }
        let records = records(11, [9, 0, 1], [Scalar::I16, Scalar::U8, Scalar::F64]);
        let mut cloud = PointCloud::new();
        let mut input = Input::new(&bytes[..], None);
        records.read(&mut input, 3, &mut cloud).unwrap();
        assert_eq!(cloud.columns()[0], [0.0, -1.0, -2.0]);
        assert_eq!(cloud.columns()[1..], [&[0.0, 1.0, 2.0]; 2]);
    }

    /// Rows of the coordinates as doubles, floats or whole numbers, and a byte; some
    /// coordinates are not finite, in the blocks of both ends and on either side of a bound.
    fn many_rows(scalars: [Scalar; 3], order: ByteOrder) -> Vec<u8> {
        let encode = |row: usize, axis: usize| -> Vec<u8> {
            let value = row as f64 * 0.25 - axis as f64;
            let is_odd = [1, BLOCK - 1, BLOCK, 4 * BLOCK].contains(&(row + axis));
            let value = if is_odd { f64::NAN } else { value };
            let mut bytes = match scalars[axis] {
                Scalar::F64 => value.to_le_bytes().to_vec(),
                Scalar::F32 => (value as f32).to_le_bytes().to_vec(),
                _ => (value as i16).to_le_bytes().to_vec(),
            };
            if order == ByteOrder::Big {
                bytes.reverse();
            }
            bytes
        };
        let encode_row = |row| [encode(row, 0), encode(row, 1), encode(row, 2), vec![7]].concat();
        (0..4 * BLOCK + 7).flat_map(encode_row).collect()
    }

    #[test]
    fn blocks_of_rows_are_decoded_as_rows_one_by_one_are() {
        const KINDS: [Scalar; 3] = [Scalar::F64, Scalar::F32, Scalar::I16];
        for kinds in 0..27 {
            let scalars = [kinds % 3, kinds / 3 % 3, kinds / 9].map(|kind| KINDS[kind]);
            let [x, y, z] = scalars.map(Scalar::size);
            let offsets = [0, x, x + y];
            let stride = x + y + z + 1;
            for order in [ByteOrder::Little, ByteOrder::Big] {
                let bytes = many_rows(scalars, order);
                let one_by_one = bytes.chunks_exact(stride).map(|row| {
                    [0, 1, 2].map(|axis| scalars[axis].decode(&row[offsets[axis]..], order))
                });
                let expected = PointCloud::from_rows(one_by_one);
                let offsets = offsets.map(|offset| offset as u64);
                let records = Records { order, ..records(stride as u64, offsets, scalars) };
                let mut cloud = PointCloud::new();
                let count = expected.rows() as u64;
                records.read(&mut Input::new(&bytes[..], None), count, &mut cloud).unwrap();
                assert_eq!(cloud, expected, "{records:?}");
            }
        }
    }

    #[test]
    fn an_early_end_names_the_row_and_the_byte_whether_or_not_the_size_is_known() {
        let records = records(12, [0, 4, 8], [Scalar::F32; 3]);
        for size in [None, Some(30)] {
            let mut input = Input::new(&[0; 30][..], size);
            let error = records.read(&mut input, 1 << 40, &mut PointCloud::new());
            assert_eq!(
                error.unwrap_err().to_string(),
                "point row 2 (byte 30): expected 1099511627776 rows of 12 bytes, \
                 found the end of the data"
            );
        }
    }

    #[test]
    fn rows_that_exceed_the_buffer_are_refused() {
        let records = records(u64::MAX, [0, 4, 8], [Scalar::F32; 3]);
        let mut input = Input::new(std::io::repeat(0), None);
        let error = records.read(&mut input, 1, &mut PointCloud::new());
        assert!(matches!(error, Err(Problem::Malformed { .. })));
    }

    #[test]
    fn columns_are_read_whole_or_not_at_all() {
        let column = |count| {
            let mut input = Input::new(&[0, 1, 0, 2, 9][..], None);
            read_column(&mut input, Scalar::U16, ByteOrder::Big, count)
        };
        assert_eq!(column(2).unwrap(), [1.0, 2.0]);
        assert!(column(3).is_err());
    }
}
