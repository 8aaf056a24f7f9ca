//! Reading a point cloud in whatever format its content is.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::error::{Place, Problem, ReadError, excerpt};
use super::input::Input;
use super::points::Points;
use super::{PointCloud, PointRows, npy, pcd, ply, text};

/// The UTF-8 byte order mark, which some editors put first.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Bytes at the beginning that decide the format, at most.
const SNIFFED: usize = 1 << 12;

/// Reads a point cloud from a file in PLY, PCD, NPY or text format, which its content tells.
///
/// Rows with a coordinate that is not finite are skipped and counted in the cloud, which is empty
/// if no row is finite.
///
/// # Errors
/// The file cannot be read, is empty or a directory, is of no known format or not of the one its
/// extension names, does not follow its format, or declares no points.
pub fn read(path: &Path) -> Result<PointCloud, ReadError> {
    read_file(path)
}

/// Reads a point cloud as [`read`] does, but for rows instead of columns, which saves a copy where
/// rows are wanted.
///
/// # Errors
/// Those of [`read`].
pub fn read_rows(path: &Path) -> Result<PointRows, ReadError> {
    read_file(path)
}

fn read_file<P: Points>(path: &Path) -> Result<P, ReadError> {
    let name = path.as_os_str().as_encoded_bytes();
    let open = || {
        if path.is_dir() {
            return Err(Problem::Directory);
        }
        let file = File::open(path)?;
        let metadata = file.metadata()?;
        // Special files tell no size, or zero.
        let size = Some(metadata.len()).filter(|size| metadata.is_file() && *size > 0);
        read_input(name, Input::new(file, size))
    };
    open().map_err(|problem| ReadError::new(name, problem))
}

/// Reads a point cloud from a stream, such as the standard input, as [`read`] does from a file.
///
/// `name` stands for the file in errors, and its extension is held against the content. Memory is
/// taken only as data arrive.
///
/// # Errors
/// Those of [`read`].
pub fn read_stream(name: &str, reader: impl Read) -> Result<PointCloud, ReadError> {
    let name = name.as_bytes();
    read_input(name, Input::new(reader, None)).map_err(|problem| ReadError::new(name, problem))
}

/// A format that is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Ply,
    Pcd,
    Npy,
    Text,
}

fn read_input<P: Points>(name: &[u8], mut input: Input<'_>) -> Result<P, Problem> {
    if input.fill(BYTE_ORDER_MARK.len())?.starts_with(BYTE_ORDER_MARK) {
        input.consume(BYTE_ORDER_MARK.len());
    }
    let start = input.fill(SNIFFED)?;
    let start = &start[..start.len().min(SNIFFED)];
    let format = sniff(start)?;
    check_extension(name, format, start)?;
    match format {
        Format::Ply => ply::read(&mut input),
        Format::Pcd => pcd::read(&mut input),
        Format::Npy => npy::read(&mut input),
        Format::Text => text::read(&mut input),
    }
}

/// The format that the first bytes of a file tell.
fn sniff(start: &[u8]) -> Result<Format, Problem> {
    if start.is_empty() {
        return Err(Problem::Empty);
    }
    if let Some((_, found, advice)) = UNSUPPORTED.iter().find(|kind| start.starts_with(kind.0)) {
        return Err(Problem::Unsupported { found, advice });
    }
    let ends_word = |byte: &u8| byte.is_ascii_whitespace();
    if start.starts_with(b"\x93NUMPY") {
        Ok(Format::Npy)
    } else if start.starts_with(b"ply") && start.get(3).is_none_or(ends_word) {
        Ok(Format::Ply)
    } else if is_pcd(start) {
        Ok(Format::Pcd)
    } else if let Some(nul) = start.iter().position(|byte| *byte == 0) {
        Err(Problem::malformed(
            Place::Byte(nul as u64),
            "PLY, PCD, NPY or text",
            format!("binary data that begin {}", excerpt(start)),
        ))
    } else {
        Ok(Format::Text)
    }
}

/// Whether the first line is a PCD version comment, or the first that is no comment begins as
/// PCD headers do.
fn is_pcd(start: &[u8]) -> bool {
    let is_line_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
    let mut lines = start.split(is_line_end).map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(b"#"));
    let keyword = first.and_then(|line| line.split(u8::is_ascii_whitespace).next());
    start.starts_with(b"# .PCD") || matches!(keyword, Some(b"VERSION" | b"FIELDS"))
}

/// Holds the format that the extension of the name promises against that of the content.
fn check_extension(name: &[u8], format: Format, start: &[u8]) -> Result<(), Problem> {
    let extensions = [
        (&b".ply"[..], Format::Ply, "`ply`, as the extension says"),
        (b".pcd", Format::Pcd, "a PCD header, as the extension says"),
        (b".npy", Format::Npy, "the NPY magic, as the extension says"),
    ];
    let name = name.to_ascii_lowercase();
    match extensions.iter().find(|(extension, ..)| name.ends_with(extension)) {
        Some((_, promised, expected)) if *promised != format => {
            Err(Problem::malformed(Place::Line(1), *expected, excerpt(start)))
        }
        _ => Ok(()),
    }
}

/// Content that is told by its first bytes but not read: the bytes, what it is, what to do.
const UNSUPPORTED: [(&[u8], &str, &str); 11] = [
    (b"\x1f\x8b", "compressed with gzip", "decompress it first"),
    (b"\x28\xb5\x2f\xfd", "compressed with zstd", "decompress it first"),
    (b"\xfd7zXZ\0", "compressed with xz", "decompress it first"),
    (b"BZh", "compressed with bzip2", "decompress it first"),
    (b"PK\x03\x04", "a zip archive", "unpack it first"),
    (b"\xff\xfe", "UTF-16 text", "save it as UTF-8"),
    (b"\xfe\xff", "UTF-16 text", "save it as UTF-8"),
    (b"LASF", "a LAS or LAZ file", "convert it first"),
    (b"ASTM-E57", "an E57 file", "convert it first"),
    (b"\x89PNG", "a PNG image", "depth maps are read another way"),
    (b"\x89HDF", "an HDF5 file", "convert it first"),
];

#[cfg(test)]
mod tests {
    use super::*;

    fn message(name: &str, bytes: &[u8]) -> String {
        read_stream(name, bytes).unwrap_err().to_string()
    }

    #[test]
    fn the_content_decides_the_format() {
        for (bytes, format) in [
            (&b"ply\nformat"[..], Format::Ply),
            (b"ply \r\n", Format::Ply),
            (b"ply", Format::Ply),
            (b"\x93NUMPY\x01\0", Format::Npy),
            (b"# .PCD v0.7\n", Format::Pcd),
            (b"VERSION .5\n", Format::Pcd),
            (b"# made by hand\n\nFIELDS x y z\n", Format::Pcd),
            (b"# x y z\n1 2 3\n", Format::Text),
            (b"plywood", Format::Text),
        ] {
            assert_eq!(sniff(bytes).unwrap(), format, "{}", bytes.escape_ascii());
        }
    }

    #[test]
    fn content_that_is_not_read_is_named() {
        assert!(message("a.ply", b"\x1f\x8b\x08\0").contains("gzip"));
        assert!(message("-", b"\xff\xfe1\0 \0").contains("UTF-16"));
        assert!(message("-", b"\x7fELF\x02\0").contains("binary data"));
        assert!(message("a.ply", b"").contains("is empty"));
        assert!(message("a.ply", BYTE_ORDER_MARK).contains("is empty"));
    }

    #[test]
    fn content_is_held_against_the_extension() {
        let text = b"1 2 3\n";
        assert!(message("A.PLY", text).starts_with("A.PLY: line 1: expected `ply`"));
        assert!(message("a.pcd", text).contains("PCD"));
        assert!(message("a.npy", b"ply\n").contains("NPY"));
        assert_eq!(read_stream("a.xyz", &text[..]).unwrap().len(), 1);
    }

    #[test]
    fn a_directory_and_a_missing_file_are_named() {
        let directory = tempfile::tempdir().unwrap();
        let error = read(directory.path()).unwrap_err();
        assert!(matches!(error.problem(), Problem::Directory), "{error}");
        let error = read(&directory.path().join("none.ply")).unwrap_err();
        assert!(matches!(error.problem(), Problem::Io(_)), "{error}");
        assert!(error.file().ends_with("none.ply"));
    }
}
