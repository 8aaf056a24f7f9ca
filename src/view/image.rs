//! Images of one number a pixel, from PNG.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use png::{BitDepth, ColorType, Decoder, Limits, Transformations};

use super::error::ImageProblem;

/// Most pixels that are read: 64 million are more than any depth camera has.
const PIXELS: u64 = 1 << 26;

/// Most bytes that one byte of deflated data can stand for (zlib's documentation).
const DEFLATE_RATIO: u64 = 1032;

/// Bytes that the decoder may use besides the pixels.
const DECODER_BYTES: usize = 1 << 26;

/// The bytes of a file of at most that many.
pub(super) fn read_bytes(path: &Path, most: u64) -> Result<Vec<u8>, ImageProblem> {
    let mut bytes = Vec::new();
    File::open(path)?.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(ImageProblem::TooLong(most)) } else { Ok(bytes) }
}

/// A decoded image.
pub(crate) struct Pixels {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Rows one after the other, channels next to each other, high bytes first.
    pub bytes: Vec<u8>,
    pub color: ColorType,
    pub depth: BitDepth,
}

/// The pixels of a PNG file, transformed.
pub(crate) fn read_png(path: &Path, change: Transformations) -> Result<Pixels, ImageProblem> {
    let limits = Limits { bytes: DECODER_BYTES };
    let file = File::open(path)?;
    let file_bytes = file.metadata()?.len();
    let mut decoder = Decoder::new_with_limits(BufReader::new(file), limits);
    decoder.set_transformations(change);
    let header = decoder.read_header_info()?;
    let found = u64::from(header.width) * u64::from(header.height);
    if found > PIXELS {
        return Err(ImageProblem::TooLarge { found, most: PIXELS });
    }
    // A header that promises more than the file can hold takes no memory for it.
    if header.raw_bytes() as u64 > DEFLATE_RATIO.saturating_mul(file_bytes) {
        return Err(ImageProblem::CutShort { size: [header.width, header.height], file_bytes });
    }
    let mut reader = decoder.read_info()?;
    let length = reader.output_buffer_size().unwrap_or(usize::MAX);
    let most = 8 * PIXELS as usize;
    if length > most {
        return Err(ImageProblem::TooLarge { found, most: PIXELS });
    }
    let mut bytes = vec![0; length];
    let frame = reader.next_frame(&mut bytes)?;
    bytes.truncate(frame.buffer_size());
    Ok(Pixels {
        size: [frame.width, frame.height],
        bytes,
        color: frame.color_type,
        depth: frame.bit_depth,
    })
}
