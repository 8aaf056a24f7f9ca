//! The NPY header: a Python dictionary of the type, the order and the shape of the array.

use crate::cloud::error::{Mismatch, excerpt};
use crate::cloud::scalar::{ByteOrder, Scalar};

/// What the header tells about an array of N rows of three numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Header {
    pub scalar: Scalar,
    pub order: ByteOrder,
    pub is_fortran_order: bool,
    pub rows: u64,
}

/// Parses the dictionary.
///
/// # Errors
/// A key is missing or unknown, or the array is not N x 3 numbers of a plain type.
pub(super) fn parse(text: &[u8]) -> Result<Header, Mismatch> {
    let mut parser = Parser { rest: text };
    let (mut kind, mut is_fortran_order, mut shape) = (None, None, None);
    parser.expect(b'{')?;
    while !parser.accept(b'}') {
        let key = parser.string("a key in quotes")?;
        parser.expect(b':')?;
        match key {
            b"descr" => kind = Some(parser.string("one plain number type such as '<f4'")?),
            b"fortran_order" => is_fortran_order = Some(parser.boolean()?),
            b"shape" => shape = Some(parser.rows_of_three()?),
            _ => return Err(Mismatch::new("descr, fortran_order or shape", excerpt(key))),
        }
        if !parser.accept(b',') {
            parser.expect(b'}')?;
            break;
        }
    }
    let (Some(kind), Some(is_fortran_order), Some(rows)) = (kind, is_fortran_order, shape) else {
        return Err(Mismatch::new("the keys descr, fortran_order and shape", excerpt(text)));
    };
    let (scalar, order) = number_type(kind).ok_or_else(|| {
        let expected = "a number type of f4, f8, i1 to i8 or u1 to u8 with its byte order";
        Mismatch::new(expected, excerpt(kind))
    })?;
    Ok(Header { scalar, order, is_fortran_order, rows })
}

/// The number type that a code such as `<f4` stands for.
fn number_type(code: &[u8]) -> Option<(Scalar, ByteOrder)> {
    let (order, kind) = code.split_first()?;
    let scalar = match kind {
        b"i1" => Scalar::I8,
        b"u1" => Scalar::U8,
        b"i2" => Scalar::I16,
        b"u2" => Scalar::U16,
        b"i4" => Scalar::I32,
        b"u4" => Scalar::U32,
        b"i8" => Scalar::I64,
        b"u8" => Scalar::U64,
        b"f4" => Scalar::F32,
        b"f8" => Scalar::F64,
        _ => return None,
    };
    match order {
        b'<' => Some((scalar, ByteOrder::Little)),
        b'>' => Some((scalar, ByteOrder::Big)),
        b'|' if scalar.size() == 1 => Some((scalar, ByteOrder::Little)),
        _ => None,
    }
}

/// Reads the few Python literals that the header is made of.
struct Parser<'t> {
    rest: &'t [u8],
}

impl<'t> Parser<'t> {
    fn accept(&mut self, byte: u8) -> bool {
        let rest = self.rest.trim_ascii_start();
        let found = rest.first() == Some(&byte);
        self.rest = if found { &rest[1..] } else { rest };
        found
    }

    fn expect(&mut self, byte: u8) -> Result<(), Mismatch> {
        match self.accept(byte) {
            true => Ok(()),
            false => Err(self.mismatch(&excerpt(&[byte]))),
        }
    }

    fn mismatch(&self, expected: &str) -> Mismatch {
        Mismatch::new(expected, excerpt(self.rest))
    }

    fn string(&mut self, expected: &str) -> Result<&'t [u8], Mismatch> {
        let is_single = self.accept(b'\'');
        if !is_single && !self.accept(b'"') {
            return Err(self.mismatch(expected));
        }
        let quote = if is_single { b'\'' } else { b'"' };
        let end = self.rest.iter().position(|byte| *byte == quote);
        let end = end.ok_or_else(|| self.mismatch("a closing quote"))?;
        let (string, rest) = self.rest.split_at(end);
        self.rest = &rest[1..];
        Ok(string)
    }

    fn boolean(&mut self) -> Result<bool, Mismatch> {
        let rest = self.rest.trim_ascii_start();
        for (word, value) in [(&b"True"[..], true), (b"False", false)] {
            if let Some(rest) = rest.strip_prefix(word) {
                self.rest = rest;
                return Ok(value);
            }
        }
        Err(self.mismatch("True or False"))
    }

    /// A shape of two dimensions, the second of which is 3; gives the first.
    fn rows_of_three(&mut self) -> Result<u64, Mismatch> {
        let shape = self.rest.trim_ascii();
        let wrong = || Mismatch::new("the shape (N, 3)", excerpt(shape));
        self.expect(b'(')?;
        let rows = self.integer().ok_or_else(wrong)?;
        let columns = if self.accept(b',') { self.integer() } else { None };
        self.accept(b',');
        match columns {
            Some(3) if self.accept(b')') => Ok(rows),
            _ => Err(wrong()),
        }
    }

    /// A whole number, maybe with the `L` that Python 2 put behind it.
    fn integer(&mut self) -> Option<u64> {
        let rest = self.rest.trim_ascii_start();
        let end = rest.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(rest.len());
        let (digits, rest) = rest.split_at(end);
        self.rest = rest.strip_prefix(b"L").unwrap_or(rest);
        std::str::from_utf8(digits).ok()?.parse().ok()
    }
}
