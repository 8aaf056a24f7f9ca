//! NumPy's NPY: an array of N rows of three numbers.

mod header;

use super::error::{Place, Problem, excerpt};
use super::input::Input;
use super::points::Points;
use super::records::{Records, read_column};
use super::scalar::first;

/// Bytes of the header, at most.
const HEADER_LIMIT: u32 = 1 << 16;

/// Reads an array of shape (N, 3), in C or Fortran order, of floats or whole numbers.
///
/// # Errors
/// The input cannot be read, the header is malformed or tells of another kind of array, or the
/// data are not as long as it tells.
pub(super) fn read<P: Points>(input: &mut Input<'_>) -> Result<P, Problem> {
    let header_length = read_preamble(input)?;
    let place = Place::Byte(input.offset());
    let text = input.fill(header_length)?;
    if text.len() < header_length {
        let expected = format!("a header of {header_length} bytes");
        return Err(Problem::malformed(place, expected, "the end of the file"));
    }
    let header = header::parse(&text[..header_length]).map_err(|error| error.at(place))?;
    input.consume(header_length);
    if header.rows == 0 {
        return Err(Problem::NoPoints("the array has 0 rows"));
    }
    let size = header.scalar.size() as u64;
    let points = if header.is_fortran_order {
        let mut column = || read_column(input, header.scalar, header.order, header.rows);
        P::from_columns([column()?, column()?, column()?])
    } else {
        let records = Records {
            element: "point",
            stride: 3 * size,
            offsets: [0, size, 2 * size],
            scalars: [header.scalar; 3],
            order: header.order,
        };
        let mut points = P::with_capacity(input.room_for(header.rows, 3 * size));
        records.read(input, header.rows, &mut points)?;
        points
    };
    input.expect_padding()?;
    Ok(points)
}

/// Reads the magic, the version and the length of the header that follows, which it gives.
fn read_preamble(input: &mut Input<'_>) -> Result<usize, Problem> {
    let bytes = input.fill(12)?;
    let (length, consumed) = match bytes.get(6..) {
        Some([1, _, low, high, ..]) => (u32::from(u16::from_le_bytes([*low, *high])), 10),
        Some([2 | 3, _, length @ ..]) if length.len() >= 4 => {
            (u32::from_le_bytes(first(length)), 12)
        }
        _ => {
            let found = excerpt(&bytes[..bytes.len().min(12)]);
            return Err(Problem::malformed(Place::Byte(6), "version 1, 2 or 3 of NPY", found));
        }
    };
    if length > HEADER_LIMIT {
        let expected = format!("a header of at most {HEADER_LIMIT} bytes");
        let found = format!("one of {length} bytes");
        return Err(Problem::malformed(Place::Byte(8), expected, found));
    }
    input.consume(consumed);
    Ok(length as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::PointCloud;

    fn array(version: u8, header: &str, data: &[u8]) -> Vec<u8> {
        let length = header.len() as u32;
        let length = length.to_le_bytes();
        let length = if version == 1 { &length[..2] } else { &length[..] };
        [b"\x93NUMPY", &[version, 0][..], length, header.as_bytes(), data].concat()
    }

    fn read_bytes(bytes: &[u8]) -> Result<PointCloud, String> {
        let clouds = [Some(bytes.len() as u64), None]
            .map(|size| read(&mut Input::new(bytes, size)).map_err(|error| error.to_string()));
        let [known, unknown] = clouds;
        assert_eq!(known, unknown);
        known
    }

    fn dictionary(kind: &str, fortran: &str, shape: &str) -> String {
        format!("{{'descr': '{kind}', 'fortran_order': {fortran}, 'shape': {shape}, }}   \n")
    }

    #[test]
    fn every_type_order_and_version_reads_the_same() {
        let rows = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]];
        let expected = PointCloud::from_rows(rows);
        let c_order = rows.concat();
        let fortran_order = [1.0, 4.0, 2.0, 5.0, 3.0, 6.0];
        macro_rules! check {
            ($type:ty, $kind:literal) => {
                for (fortran, values) in [("False", &c_order[..]), ("True", &fortran_order)] {
                    let bytes = |order: &str| -> Vec<u8> {
                        let values = values.iter().map(|value| *value as $type);
                        match order {
                            ">" => values.flat_map(<$type>::to_be_bytes).collect(),
                            _ => values.flat_map(<$type>::to_le_bytes).collect(),
                        }
                    };
                    for (version, order) in [(1, "<"), (2, ">"), (3, "<")] {
                        let header = dictionary(&format!("{order}{}", $kind), fortran, "(2, 3)");
                        let cloud = read_bytes(&array(version, &header, &bytes(order)));
                        assert_eq!(cloud.as_ref(), Ok(&expected), "{header}");
                    }
                }
            };
        }
        check!(i8, "i1");
        check!(u8, "u1");
        check!(i16, "i2");
        check!(u16, "u2");
        check!(i32, "i4");
        check!(u32, "u4");
        check!(i64, "i8");
        check!(u64, "u8");
        check!(f32, "f4");
        check!(f64, "f8");
    }

    #[test]
    fn arrays_of_other_kinds_are_refused_by_what_was_expected() {
        for (header, message) in [
            (dictionary("<f4", "False", "(2, 4)"), "expected the shape (N, 3), found `(2, 4)"),
            (dictionary("<f4", "False", "(6,)"), "expected the shape (N, 3)"),
            (dictionary("<f4", "False", "(1, 2, 3)"), "expected the shape (N, 3)"),
            (dictionary("<f4", "False", "(-1, 3)"), "expected the shape (N, 3)"),
            (dictionary("<f4", "False", "(99999999999999999999, 3)"), "expected the shape (N, 3)"),
            (dictionary("<f4", "False", "(0, 3)"), "holds no points"),
            (dictionary("<f2", "False", "(2, 3)"), "expected a number type"),
            (dictionary("|O", "False", "(2, 3)"), "expected a number type"),
            (dictionary("<f4", "0", "(2, 3)"), "expected True or False"),
            ("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (2,)}".into(), "plain"),
            ("{'descr': '<f4', 'shape': (2, 3)}".into(), "expected the keys descr"),
            ("{'descr': '<f4".into(), "expected a closing quote"),
            ("{".into(), "expected a key"),
            (String::new(), "expected `{`"),
        ] {
            let error = read_bytes(&array(1, &header, &[0; 24])).unwrap_err();
            assert!(error.contains(message), "{header}: {error}");
        }
    }

    #[test]
    fn files_that_end_early_or_lie_about_lengths_are_refused() {
        let whole = array(1, &dictionary("<f4", "False", "(2, 3)"), &[0; 24]);
        for length in 6..whole.len() {
            assert!(read_bytes(&whole[..length]).is_err(), "{length}");
        }
        let huge = array(2, &dictionary("<f8", "True", "(18446744073709551615, 3)"), &[0; 24]);
        assert!(read_bytes(&huge).unwrap_err().starts_with("point row 3 (byte "));
        let error = read_bytes(b"\x93NUMPY\x02\0\xff\xff\xff\xff{}").unwrap_err();
        assert!(error.contains("a header of at most"), "{error}");
        assert!(read_bytes(b"\x93NUMPY\x04\0\0\0\0\0{}").is_err());
    }
}
