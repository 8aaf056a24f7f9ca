//! Coordinates in binary rows of one fixed size, or in columns.

use super::PointCloud;
use super::error::{Place, Problem};
use super::input::{CAPACITY, Input};
use super::scalar::{ByteOrder, Scalar, first};

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
    /// Reads `count` rows and appends their coordinates to the cloud.
    ///
    /// # Errors
    /// The input cannot be read or ends too early, or a row is longer than [`CAPACITY`].
    pub fn read(
        &self,
        input: &mut Input<'_>,
        count: u64,
        cloud: &mut PointCloud,
    ) -> Result<(), Problem> {
        let [x, y, z] = self.offsets.map(|offset| offset as usize);
        macro_rules! same {
            ($type:ty) => {
                match self.order {
                    ByteOrder::Little => self.read_with(input, count, cloud, |row| {
                        [x, y, z].map(|at| <$type>::from_le_bytes(first(&row[at..])).into())
                    }),
                    ByteOrder::Big => self.read_with(input, count, cloud, |row| {
                        [x, y, z].map(|at| <$type>::from_be_bytes(first(&row[at..])).into())
                    }),
                }
            };
        }
        match self.scalars {
            [Scalar::F32, Scalar::F32, Scalar::F32] => same!(f32),
            [Scalar::F64, Scalar::F64, Scalar::F64] => same!(f64),
            [kind_x, kind_y, kind_z] => self.read_with(input, count, cloud, |row| {
                [(kind_x, x), (kind_y, y), (kind_z, z)]
                    .map(|(kind, at)| kind.decode(&row[at..], self.order))
            }),
        }
    }

    fn read_with(
        &self,
        input: &mut Input<'_>,
        count: u64,
        cloud: &mut PointCloud,
        decode: impl Fn(&[u8]) -> [f64; 3],
    ) -> Result<(), Problem> {
        expect_rows(input, self.element, count, self.stride)?;
        if self.stride == 0 || self.stride > CAPACITY as u64 {
            return Err(Problem::malformed(
                Place::Byte(input.offset()),
                format!("rows of 1 to {CAPACITY} bytes"),
                format!("rows of {} bytes", self.stride),
            ));
        }
        let stride = self.stride as usize;
        let mut left = count;
        while left > 0 {
            let found = input.fill(stride)?.len();
            let rows = left.min((found / stride) as u64);
            if rows == 0 {
                let end = input.offset() + found as u64;
                return Err(cut_short(self.element, count - left, end, count, self.stride));
            }
            let length = rows as usize * stride;
            for row in input.at_hand()[..length].chunks_exact(stride) {
                cloud.push(decode(row));
            }
            input.consume(length);
            left -= rows;
        }
        Ok(())
    }
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
    expect_rows(input, "point", count, size as u64)?;
    let mut column = Vec::with_capacity(input.room_for(count, size as u64));
    let mut left = count;
    while left > 0 {
        let found = input.fill(size)?.len();
        let rows = left.min((found / size) as u64);
        if rows == 0 {
            let end = input.offset() + found as u64;
            return Err(cut_short("point", count - left, end, count, size as u64));
        }
        let length = rows as usize * size;
        let numbers = input.at_hand()[..length].chunks_exact(size);
        column.extend(numbers.map(|number| scalar.decode(number, order)));
        input.consume(length);
        left -= rows;
    }
    Ok(column)
}

#[cfg(test)]
mod tests {
    use super::*;

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
