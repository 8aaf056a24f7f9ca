//! The PCD header: the fields of a point, the number of points and the encoding of the data.

use std::collections::HashMap;

use crate::cloud::error::{Mismatch, Place, Problem, excerpt};
use crate::cloud::input::Input;
use crate::cloud::number::{parse_count, tokens};
use crate::cloud::scalar::Scalar;
use crate::cloud::text_rows::AXES;

/// Bytes of a header line, at most.
const LINE_LIMIT: usize = 1 << 16;

/// Lines of the header, at most.
const LINES_LIMIT: u64 = 1 << 10;

/// How the data are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    Binary,
    Compressed,
}

/// A field of a point: `count` numbers of one type.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Field {
    pub scalar: Scalar,
    pub count: u64,
    /// The axis, 0, 1 or 2, if the field is a coordinate.
    pub axis: Option<usize>,
}

impl Field {
    /// The bytes of the field in a binary point.
    pub fn size(&self) -> u64 {
        self.count.saturating_mul(self.scalar.size() as u64)
    }
}

/// What the header tells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Header {
    pub fields: Vec<Field>,
    pub points: u64,
    pub encoding: Encoding,
}

/// The header lines, each at most once; `COLUMNS` is an old name of `FIELDS`.
const KEYWORDS: [&str; 10] = [
    "VERSION",
    "FIELDS",
    "SIZE",
    "TYPE",
    "COUNT",
    "WIDTH",
    "HEIGHT",
    "VIEWPOINT",
    "POINTS",
    "DATA",
];

/// Reads the header up to and including the text of its `DATA` line, the end of which the caller
/// finds.
///
/// # Errors
/// The input cannot be read, or the header is malformed, not ended or contradicts itself.
pub(super) fn read(input: &mut Input<'_>) -> Result<Header, Problem> {
    let mut lines = Lines::default();
    while !lines.0.contains_key("DATA") {
        let number = input.line_number() + 1;
        let place = Place::Line(number);
        let Some(line) = input.line()? else {
            return Err(Problem::malformed(place, "the header line `DATA`", "the end of the file"));
        };
        if line.len() > LINE_LIMIT || number > LINES_LIMIT {
            let expected = format!("{LINES_LIMIT} header lines of {LINE_LIMIT} bytes at most");
            return Err(Problem::malformed(place, expected, excerpt(line)));
        }
        lines.push(line).map_err(|error| error.at(place))?;
    }
    lines.header().map_err(|error| error.at(Place::Line(input.line_number())))
}

/// The words of each header line, by the line's keyword.
#[derive(Default)]
struct Lines(HashMap<&'static str, Vec<Vec<u8>>>);

impl Lines {
    fn push(&mut self, line: &[u8]) -> Result<(), Mismatch> {
        let mut words = tokens(line);
        let keyword = match words.next() {
            None => return Ok(()),
            Some(word) if word.starts_with(b"#") => return Ok(()),
            Some(b"COLUMNS") => b"FIELDS",
            Some(word) => word,
        };
        let keyword = KEYWORDS.into_iter().find(|known| known.as_bytes() == keyword);
        let keyword = keyword.ok_or_else(|| Mismatch::new("a PCD header line", excerpt(line)))?;
        let words = words.map(<[u8]>::to_vec).collect();
        match self.0.insert(keyword, words) {
            None => Ok(()),
            Some(_) => Err(Mismatch::new(format!("one line `{keyword}`"), excerpt(line))),
        }
    }

    fn header(&self) -> Result<Header, Mismatch> {
        if let Some(words) = self.0.get("VERSION") {
            let is_known = |word: &[u8]| {
                matches!(word.strip_prefix(b"0").unwrap_or(word), b".5" | b".6" | b".7")
            };
            if !matches!(&words[..], [version] if is_known(version)) {
                return Err(Mismatch::new("VERSION .5, .6 or .7", shown(words)));
            }
        }
        let encoding = match &self.words("DATA")?[..] {
            [word] if word.eq_ignore_ascii_case(b"ascii") => Encoding::Ascii,
            [word] if word.eq_ignore_ascii_case(b"binary") => Encoding::Binary,
            [word] if word.eq_ignore_ascii_case(b"binary_compressed") => Encoding::Compressed,
            words => {
                let expected = "DATA ascii, binary or binary_compressed";
                return Err(Mismatch::new(expected, shown(words)));
            }
        };
        Ok(Header { fields: self.fields()?, points: self.points()?, encoding })
    }

    fn words(&self, keyword: &str) -> Result<&Vec<Vec<u8>>, Mismatch> {
        let missing = || Mismatch::new(format!("a line `{keyword}`"), "a header without it");
        self.0.get(keyword).ok_or_else(missing)
    }

    fn fields(&self) -> Result<Vec<Field>, Mismatch> {
        let names = self.words("FIELDS")?;
        let sizes = self.words("SIZE")?;
        let types = self.words("TYPE")?;
        let ones = vec![b"1".to_vec(); names.len()];
        let counts = self.0.get("COUNT").unwrap_or(&ones);
        for (keyword, words) in [("SIZE", sizes), ("TYPE", types), ("COUNT", counts)] {
            if words.len() != names.len() {
                let expected = format!("{} values in {keyword}, one a field", names.len());
                return Err(Mismatch::new(expected, format!("{}", words.len())));
            }
        }
        let axes = axis_indices(names)?;
        let mut fields = Vec::with_capacity(names.len());
        for (index, size) in sizes.iter().enumerate() {
            let (kind, count) = (&types[index], &counts[index]);
            let scalar = number_type(kind, size).ok_or_else(|| {
                let expected = "TYPE and SIZE of I or U 1, 2, 4 or 8, or F 4 or 8";
                Mismatch::new(expected, format!("{} and {}", excerpt(kind), excerpt(size)))
            })?;
            let count = parse_count(count).ok_or_else(|| {
                Mismatch::new("a whole number in COUNT for each field", excerpt(count))
            })?;
            let axis = axes.iter().position(|axis| *axis == index);
            if axis.is_some() && count != 1 {
                let expected = format!("COUNT 1 for {}", excerpt(&names[index]));
                return Err(Mismatch::new(expected, format!("`{count}`")));
            }
            fields.push(Field { scalar, count, axis });
        }
        Ok(fields)
    }

    /// The number of points, on which POINTS and WIDTH times HEIGHT must agree.
    fn points(&self) -> Result<u64, Mismatch> {
        let [width, height, points] =
            [self.count("WIDTH")?, self.count("HEIGHT")?, self.count("POINTS")?];
        let area = width.map(|width| width.saturating_mul(height.unwrap_or(1)));
        match (area, points) {
            (Some(area), Some(points)) if area != points => {
                let expected = format!("POINTS {area}, as WIDTH times HEIGHT");
                Err(Mismatch::new(expected, format!("`{points}`")))
            }
            (None, None) => Err(Mismatch::new("a line `POINTS`", "a header without it")),
            (_, Some(count)) | (Some(count), None) => Ok(count),
        }
    }

    fn count(&self, keyword: &str) -> Result<Option<u64>, Mismatch> {
        let Some(words) = self.0.get(keyword) else {
            return Ok(None);
        };
        let count = match &words[..] {
            [word] => parse_count(word),
            _ => None,
        };
        let expected = || format!("one whole number below 2^64 in {keyword}");
        count.map(Some).ok_or_else(|| Mismatch::new(expected(), shown(words)))
    }
}

/// The words of a line as an excerpt.
fn shown(words: &[Vec<u8>]) -> String {
    excerpt(&words.join(&b' '))
}

/// The indices of the fields x, y and z, or X, Y and Z.
fn axis_indices(names: &[Vec<u8>]) -> Result<[usize; 3], Mismatch> {
    let mut indices = [0; 3];
    for (found, axis) in indices.iter_mut().zip(AXES) {
        let upper = axis.to_ascii_uppercase();
        let positions = |name: &str| {
            let is_named =
                |(index, word): (usize, &Vec<u8>)| (word == name.as_bytes()).then_some(index);
            names.iter().enumerate().filter_map(is_named).collect::<Vec<_>>()
        };
        let lower = positions(axis);
        let positions = if lower.is_empty() { positions(&upper) } else { lower };
        match positions[..] {
            [index] => *found = index,
            _ => return Err(Mismatch::new(format!("one field {axis}"), shown(names))),
        }
    }
    Ok(indices)
}

/// The number type that a letter and a size stand for.
fn number_type(kind: &[u8], size: &[u8]) -> Option<Scalar> {
    match (kind.to_ascii_uppercase().as_slice(), size) {
        (b"I", b"1") => Some(Scalar::I8),
        (b"U", b"1") => Some(Scalar::U8),
        (b"I", b"2") => Some(Scalar::I16),
        (b"U", b"2") => Some(Scalar::U16),
        (b"I", b"4") => Some(Scalar::I32),
        (b"U", b"4") => Some(Scalar::U32),
        (b"I", b"8") => Some(Scalar::I64),
        (b"U", b"8") => Some(Scalar::U64),
        (b"F", b"4") => Some(Scalar::F32),
        (b"F", b"8") => Some(Scalar::F64),
        _ => None,
    }
}
