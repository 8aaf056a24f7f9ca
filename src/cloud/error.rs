//! What can go wrong when a cloud is read, told so that the file can be mended.

use std::fmt;
use std::io;

/// Characters of the input that are quoted in a message, at most.
const EXCERPT_CHARS: usize = 40;

/// Why a point cloud could not be read: the file and its [`Problem`].
#[derive(Debug, thiserror::Error)]
#[error("{file}: {problem}")]
pub struct ReadError {
    file: String,
    problem: Box<Problem>,
}

impl ReadError {
    /// The error for the file of this name, which may be any bytes.
    pub(super) fn new(file: &[u8], problem: Problem) -> Self {
        Self { file: escape(file, usize::MAX), problem: Box::new(problem) }
    }

    /// The name of the file, characters that cannot be printed escaped.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// What is wrong with the file.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

/// What is wrong with a file that should hold a point cloud.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// The file cannot be opened or read.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The path leads to a directory.
    #[error("is a directory; expected a point cloud file")]
    Directory,
    /// There is not a single byte.
    #[error("is empty; expected a point cloud")]
    Empty,
    /// The content is of a kind that is not read.
    #[error("is {found}; expected PLY, PCD, NPY or text ({advice})")]
    Unsupported {
        /// The kind of content found.
        found: &'static str,
        /// What can be done about it.
        advice: &'static str,
    },
    /// The format is followed, but it declares or holds not a single row of coordinates.
    #[error("holds no points: {0}")]
    NoPoints(&'static str),
    /// The format is not followed.
    #[error("{place}: expected {expected}, found {found}")]
    Malformed {
        /// Where the reader stopped.
        place: Place,
        /// What the format asks for there.
        expected: String,
        /// What is there instead.
        found: String,
    },
}

impl Problem {
    /// The format is not followed at this place.
    pub(super) fn malformed(
        place: Place,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Self {
        Self::Malformed { place, expected: expected.into(), found: found.into() }
    }
}

/// What was expected and what was found, at a place the caller knows.
#[derive(Debug)]
pub(super) struct Mismatch {
    expected: String,
    found: String,
}

impl Mismatch {
    pub fn new(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Self { expected: expected.into(), found: found.into() }
    }

    /// The problem at this place.
    pub fn at(self, place: Place) -> Problem {
        Problem::malformed(place, self.expected, self.found)
    }
}

/// A place in a file. Lines are counted from 1; rows and bytes from 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// A line.
    Line(u64),
    /// A byte.
    Byte(u64),
    /// A row of an element in a text format.
    TextRow {
        /// What the row belongs to: `vertex`, `face`, `point`.
        element: String,
        /// The row within its element.
        row: u64,
        /// The line of the file.
        line: u64,
    },
    /// A row of an element in a binary format.
    BinaryRow {
        /// What the row belongs to: `vertex`, `face`, `point`.
        element: String,
        /// The row within its element.
        row: u64,
        /// The byte of the file at which the reader stopped.
        byte: u64,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::TextRow { element, row, line } => write!(f, "{element} row {row} (line {line})"),
            Self::BinaryRow { element, row, byte } => {
                write!(f, "{element} row {row} (byte {byte})")
            }
        }
    }
}

/// The bytes in backquotes, escaped where they cannot be printed and cut where they are long.
pub(super) fn excerpt(bytes: &[u8]) -> String {
    format!("`{}`", escape(bytes, EXCERPT_CHARS))
}

/// The excerpt of a token that should be a number, with a hint if it has a decimal comma.
pub(super) fn not_a_number(token: &[u8]) -> String {
    let hint = match token.contains(&b',') {
        true => " (a comma: numbers need a decimal point)",
        false => "",
    };
    format!("{}{hint}", excerpt(token))
}

/// At most `limit` characters of the bytes, those that cannot be printed escaped.
fn escape(bytes: &[u8], limit: usize) -> String {
    let mut text = String::new();
    let mut room = limit;
    for chunk in bytes.utf8_chunks() {
        for character in chunk.valid().chars() {
            if room == 0 {
                return text + "…";
            }
            room -= 1;
            match character {
                '\'' | '"' | '\\' => text.push(character),
                _ => text.extend(character.escape_debug()),
            }
        }
        for byte in chunk.invalid() {
            if room == 0 {
                return text + "…";
            }
            room -= 1;
            text.extend(byte.escape_ascii().map(char::from));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_name_the_file_the_place_and_both_sides() {
        let place = Place::TextRow { element: "vertex".into(), row: 2, line: 10 };
        let error =
            ReadError::new(b"scan.ply", Problem::malformed(place, "3 values", excerpt(b"1 2")));
        assert_eq!(
            error.to_string(),
            "scan.ply: vertex row 2 (line 10): expected 3 values, found `1 2`"
        );
    }

    #[test]
    fn control_characters_and_foreign_bytes_are_escaped() {
        assert_eq!(excerpt(b"a\x1b[31m\xff\n\0 \xc3\xa4'"), r"`a\u{1b}[31m\xff\n\0 ä'`");
        assert_eq!(ReadError::new(b"a\n\xffb", Problem::Empty).file(), r"a\n\xffb");
    }

    #[test]
    fn long_excerpts_are_cut() {
        assert_eq!(excerpt(&[b'a'; 1000]).chars().count(), EXCERPT_CHARS + 3);
        assert_eq!(excerpt(&[0xff; 1000]).chars().count(), 4 * EXCERPT_CHARS + 3);
    }
}
