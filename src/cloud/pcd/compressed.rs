//! PCD data in one block compressed with LZF, all numbers of a field together.

use super::header::{Field, Header};
use crate::cloud::error::{Place, Problem};
use crate::cloud::input::Input;
use crate::cloud::points::Points;
use crate::cloud::records::expect_rows;
use crate::cloud::scalar::{ByteOrder, first};

/// LZF makes 264 bytes of three, at most.
const MOST_EXPANDED: u64 = 264 / 3;

/// The most bytes that can be decompressed: LZF's decoder counts them in 31 bits.
const MOST_BYTES: u64 = i32::MAX as u64;

/// Reads the block: the compressed and the full size as 32-bit numbers, then the compressed bytes.
///
/// # Errors
/// The input cannot be read or ends too early, the sizes contradict the header or each other, or
/// the bytes are not LZF.
pub(super) fn read<P: Points>(
    input: &mut Input<'_>,
    header: &Header,
    stride: u64,
) -> Result<P, Problem> {
    let place = Place::Byte(input.offset());
    let sizes = input.fill(8)?;
    if sizes.len() < 8 {
        return Err(Problem::malformed(place, "the two sizes of the data", "the end of the data"));
    }
    let compressed_size = u64::from(u32::from_le_bytes(first(sizes)));
    let size = u64::from(u32::from_le_bytes(first(&sizes[4..])));
    input.consume(8);
    let declared = u128::from(header.points) * u128::from(stride);
    if u128::from(size) != declared || size > MOST_BYTES {
        return Err(Problem::malformed(
            place,
            format!("{declared} bytes of data, as the header says, and below 2^31"),
            format!("{size}"),
        ));
    }
    if size > compressed_size.saturating_mul(MOST_EXPANDED) {
        return Err(Problem::malformed(
            place,
            format!("the size of what decompresses to {size} bytes"),
            format!("{compressed_size}"),
        ));
    }
    let compressed = read_block(input, compressed_size)?;
    let block = lzf::decompress(&compressed, size as usize);
    match block.map_err(|error| error.to_string()) {
        Ok(block) if block.len() as u64 == size => Ok(decode(&block, header)),
        Ok(block) => Err(Problem::malformed(
            place,
            format!("data that decompress to {size} bytes"),
            format!("data of {} bytes", block.len()),
        )),
        Err(error) => Err(Problem::malformed(place, "data compressed with LZF", error)),
    }
}

/// Reads `size` bytes, making room only as they arrive.
fn read_block(input: &mut Input<'_>, size: u64) -> Result<Vec<u8>, Problem> {
    expect_rows(input, "compressed", 1, size)?;
    let mut block = Vec::with_capacity(input.room_for(size, 1));
    while (block.len() as u64) < size {
        let bytes = input.fill(1)?;
        let length = (size - block.len() as u64).min(bytes.len() as u64) as usize;
        block.extend_from_slice(&bytes[..length]);
        input.consume(length);
        if length == 0 {
            return Err(Problem::malformed(
                Place::Byte(input.offset()),
                format!("{size} compressed bytes"),
                "the end of the data",
            ));
        }
    }
    Ok(block)
}

/// The coordinates in a block that holds all the numbers that the header declares.
fn decode<P: Points>(block: &[u8], header: &Header) -> P {
    let mut columns = [const { Vec::new() }; 3];
    let mut rest = block;
    for field in &header.fields {
        let (column, after) = rest.split_at(length(field, header));
        if let Some(axis) = field.axis {
            let numbers = column.chunks_exact(field.scalar.size());
            field.scalar.append(numbers, ByteOrder::Little, &mut columns[axis]);
        }
        rest = after;
    }
    P::from_columns(columns)
}

/// The bytes of a field in a block, which is shorter than 2^31 bytes.
fn length(field: &Field, header: &Header) -> usize {
    (field.size() * header.points) as usize
}
