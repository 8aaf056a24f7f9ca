//! The PLY header: bounded and cleaned here, then parsed by `ply-rs-bw`.

use std::collections::HashSet;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{DefaultElement, Header, Version};

use crate::cloud::error::{Place, Problem, excerpt};
use crate::cloud::input::Input;
use crate::cloud::number::tokens;

/// Bytes of a header line other than a comment, at most.
const LINE_LIMIT: usize = 1 << 16;

/// Bytes of the whole header, at most.
const HEADER_LIMIT: u64 = 1 << 21;

/// Lines of the whole header, at most.
const LINES_LIMIT: u64 = 1 << 13;

/// Reads the header up to and including the text `end_header`; the caller ends the last line,
/// since only the header tells where the data begin.
///
/// # Errors
/// The input cannot be read, or the header is malformed, too long or not ended.
pub(super) fn read(input: &mut Input<'_>) -> Result<Header, Problem> {
    let mut cleaner = Cleaner::default();
    let ended = cleaner.read_lines(input)?;
    // Where the header is not ended, a malformed line is the better thing to tell of.
    let header = parse(&cleaner.text).map_err(|error| malformed_line(&cleaner, &error));
    let line = Place::Line(input.line_number());
    match (ended, header) {
        (true, Ok(header)) if header.version == (Version { major: 1, minor: 0 }) => Ok(header),
        (true, Ok(header)) => Err(Problem::malformed(
            Place::Line(cleaner.format_line),
            "version 1.0",
            format!("version {}", header.version),
        )),
        (_, Err(Some(problem))) => Err(problem),
        (true, Err(None)) => Err(Problem::malformed(
            line,
            "a header with a line `format ENCODING 1.0`",
            "none that can be read",
        )),
        (false, _) => Err(Problem::malformed(line, "`end_header`", "the end of the file")),
    }
}

/// Parses a header that holds nothing but short, plain lines.
fn parse(text: &str) -> Result<Header, ParseError> {
    Parser::<DefaultElement>::new().read_header(&mut Reader::new(text.as_bytes()))
}

/// The problem of the header line the parser stopped at, if it stopped at one.
fn malformed_line(cleaner: &Cleaner, error: &ParseError) -> Option<Problem> {
    let number = error.line()?;
    let line = cleaner.text.lines().nth(number.checked_sub(1)?)?;
    let expected = match line.split_ascii_whitespace().next() {
        Some("format") => {
            "one `format ENCODING 1.0`, ENCODING one of ascii, binary_little_endian, \
             binary_big_endian"
        }
        Some("element") => "`element NAME COUNT`, COUNT a whole number below 2^64",
        Some("property") => {
            "`property TYPE NAME` or `property list TYPE TYPE NAME` of an element, TYPE one of \
             char, uchar, short, ushort, int, uint, float, double or int8 to float64"
        }
        _ => "a PLY header line",
    };
    Some(Problem::malformed(Place::Line(number as u64), expected, excerpt(line.as_bytes())))
}

/// Turns header lines of any kind found in the wild into the few kinds the parser takes.
///
/// Line ends become LF, blanks around a line go, comments and empty lines become bare comments so
/// that line numbers stay, and a name that is no plain identifier gives way to one made of its
/// line number.
#[derive(Default)]
struct Cleaner {
    text: String,
    format_line: u64,
    elements: HashSet<String>,
    properties: HashSet<String>,
}

impl Cleaner {
    /// Reads and cleans all lines; tells whether `end_header` was found before the end.
    fn read_lines(&mut self, input: &mut Input<'_>) -> Result<bool, Problem> {
        let start = input.offset();
        loop {
            let number = input.line_number() + 1;
            let Some(line) = input.line()? else {
                return Ok(false);
            };
            let line = line.trim_ascii();
            let is_last = line == b"end_header";
            self.push_line(line, number)?;
            if is_last {
                return Ok(true);
            }
            if input.offset() - start > HEADER_LIMIT || number > LINES_LIMIT {
                return Err(Problem::malformed(
                    Place::Line(number),
                    format!("a header of at most {HEADER_LIMIT} bytes in {LINES_LIMIT} lines"),
                    "a longer one",
                ));
            }
        }
    }

    /// Adds one line without blanks around it to the clean text.
    fn push_line(&mut self, line: &[u8], number: u64) -> Result<(), Problem> {
        let keyword = tokens(line).next().unwrap_or_default();
        if matches!(keyword, b"" | b"comment" | b"obj_info") {
            self.text += "comment\n";
            return Ok(());
        }
        let malformed =
            |expected: &str| Problem::malformed(Place::Line(number), expected, excerpt(line));
        if line.len() > LINE_LIMIT {
            return Err(malformed(&format!("a line of at most {LINE_LIMIT} bytes")));
        }
        if let Some(control) = line.iter().find(|&&byte| byte.is_ascii_control() && byte != b'\t') {
            let expected = format!("text without the control character 0x{control:02x}");
            return Err(malformed(&expected));
        }
        let known: [&[u8]; 5] = [b"ply", b"format", b"element", b"property", b"end_header"];
        if !known.contains(&keyword) || (keyword == b"end_header" && line != keyword) {
            return Err(malformed("a PLY header line"));
        }
        if keyword == b"format" {
            self.format_line = number;
        }
        let ascii =
            |word: &[u8]| String::from_utf8(word.to_vec()).ok().filter(|word| word.is_ascii());
        let mut words: Vec<Option<String>> = tokens(line).map(ascii).collect();
        let name = match (keyword, words.len()) {
            (b"element", 3) => Some(1),
            (b"property", 3..) => Some(words.len() - 1),
            _ => None,
        };
        if let Some(index) = name {
            let word = words[index].take().filter(|word| is_identifier(word));
            let word = word.unwrap_or_else(|| format!("_{number}"));
            if !self.is_new(keyword == b"element", &word) {
                return Err(malformed("a name not taken by a line before"));
            }
            words[index] = Some(word);
        }
        let words = words.into_iter().collect::<Option<Vec<_>>>();
        self.text += &words.ok_or_else(|| malformed("ASCII text"))?.join(" ");
        self.text.push('\n');
        Ok(())
    }

    /// Notes the name of an element or of a property of the last element; false if it is taken.
    fn is_new(&mut self, is_element: bool, name: &str) -> bool {
        if is_element {
            self.properties.clear();
            self.elements.insert(name.into())
        } else {
            self.properties.insert(name.into())
        }
    }
}

/// Whether the parser takes the name.
fn is_identifier(name: &str) -> bool {
    let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
    name.starts_with(is_letter)
        && name.chars().all(|c| is_letter(c) || c.is_ascii_digit() || c == '-')
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use super::*;

    fn header(text: &[u8]) -> Result<Header, String> {
        read(&mut Input::new(text, None)).map_err(|problem| problem.to_string())
    }

    const GOOD: &[u8] = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n";

    #[test]
    fn headers_of_any_dress_are_the_same_header() {
        let good = header(GOOD).unwrap();
        assert_eq!(good.elements["vertex"].count, 3);
        for text in [
            &b"ply\rformat ascii 1.0\relement vertex 3\rproperty float x\rend_header\r"[..],
            b"ply \r\nformat  ascii\t1.0\r\n\r\nelement vertex 3 \n property float x\nend_header",
            b"ply\nformat ascii 1.0\ncomment\nelement vertex 3\nproperty float32 x\nend_header \r\n",
            b"ply\nformat ascii 1.0\ncomment \xff\0\x01\nobj_info \xfe\nelement vertex 3\n\
              property float x\nend_header\n",
        ] {
            let other = header(text).unwrap();
            assert_eq!(other.elements, good.elements, "{}", text.escape_ascii());
        }
    }

    #[test]
    fn odd_property_names_are_no_obstacle() {
        let text = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n\
            property float scalar_distance[<0.5]\nproperty float \xc3\xa4\nproperty float 2nd\n\
            property float end_header\nend_header\n";
        assert_eq!(header(text).unwrap().elements["vertex"].properties.len(), 5);
    }

    #[test]
    fn what_is_wrong_is_named_by_its_line() {
        let with = |line: &str| {
            let text = String::from_utf8_lossy(GOOD).replace("property float x", line);
            header(text.as_bytes()).unwrap_err()
        };
        for line in [
            "property",
            "property float",
            "property floatt x",
            "property list uchar x",
            "property list uchar int x y",
            "element face",
            "element face -1",
            "element face +1",
            "element face 3.0",
            "element face 99999999999999999999",
            "element face 1 1",
            "element vertex 3",
            "format binary_little_endian 1.0",
            "format",
            "ply",
            "nonsense",
            "end_header now",
            "property float ver\0tex",
            "prop\u{e4}rty float x",
        ] {
            assert!(with(line).starts_with("line 4: "), "{}", with(line));
        }
        let error = with("property float x\nproperty float x");
        assert!(error.starts_with("line 5: expected a name not taken"), "{error}");
        let error = with(&format!("property float {}", "x".repeat(LINE_LIMIT)));
        assert!(error.len() < 200, "{error}");
    }

    #[test]
    fn headers_that_are_no_whole_are_refused() {
        for (text, message) in [
            (&b"ply\nformat\r\r\r"[..], "line 2: expected one `format"),
            (b"ply\nformat ascii 1.0\n", "line 2: expected `end_header`, found the end"),
            (b"ply\nend_header\n", "line 2: expected a header with a line `format"),
            (b"ply\nproperty float x\nend_header\n", "line 2: "),
            (b"ply\nformat ascii 2.0\nend_header\n", "line 2: expected version 1.0, found"),
            (b"ply\nformat ascii 99999.0\nend_header\n", "line 3: expected a header with"),
            (b"ply\nformat utf8 1.0\nend_header\n", "line 2: expected one `format"),
        ] {
            let error = header(text).unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
    }

    #[test]
    fn endless_headers_are_refused() {
        let endless = b"ply\n".chain(std::io::repeat(b'\n'));
        let error = read(&mut Input::new(endless, None)).unwrap_err();
        assert!(error.to_string().contains("a header of at most"), "{error}");
    }
}
