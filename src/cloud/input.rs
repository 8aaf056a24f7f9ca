//! A buffered source of bytes that knows where it is, and never grows.

use std::io::{self, Read};

use super::error::{Place, Problem, excerpt};

/// Size of the buffer: the longest line and the longest fixed-size row that can be read.
pub(super) const CAPACITY: usize = 1 << 20;

/// Trailing bytes looked at, at most, to tell padding from data.
const PADDING_LIMIT: u64 = 1 << 24;

/// A stream read through one buffer of [`CAPACITY`] bytes.
pub(super) struct Input<'r> {
    reader: Box<dyn Read + 'r>,
    buffer: Box<[u8]>,
    start: usize,
    end: usize,
    ended: bool,
    offset: u64,
    size: Option<u64>,
    line_number: u64,
    after_cr: bool,
    has_line_feeds: bool,
}

impl<'r> Input<'r> {
    /// The bytes of a reader, whose total `size` is given if it is known.
    pub fn new(reader: impl Read + 'r, size: Option<u64>) -> Self {
        Self {
            reader: Box::new(reader),
            buffer: vec![0; CAPACITY].into_boxed_slice(),
            start: 0,
            end: 0,
            ended: false,
            offset: 0,
            size,
            line_number: 0,
            after_cr: false,
            has_line_feeds: false,
        }
    }

    /// Reads on until `wanted` bytes, at most [`CAPACITY`], are at hand or the input ends, and
    /// gives all that are at hand.
    pub fn fill(&mut self, wanted: usize) -> io::Result<&[u8]> {
        let wanted = wanted.min(CAPACITY);
        if self.end - self.start < wanted && self.start > 0 {
            self.buffer.copy_within(self.start..self.end, 0);
            self.end -= self.start;
            self.start = 0;
        }
        while self.end - self.start < wanted && !self.ended {
            match self.reader.read(&mut self.buffer[self.end..]) {
                Ok(0) => self.ended = true,
                Ok(count) => self.end += count,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(self.at_hand())
    }

    /// The bytes read ahead and not yet consumed.
    pub fn at_hand(&self) -> &[u8] {
        &self.buffer[self.start..self.end]
    }

    /// Moves past `count` bytes, which must be at hand.
    pub fn consume(&mut self, count: usize) {
        self.start = self.end.min(self.start + count);
        self.offset += count as u64;
    }

    /// Moves past up to `count` bytes and tells how many there were.
    pub fn skip(&mut self, count: u64) -> io::Result<u64> {
        let mut left = count;
        while left > 0 {
            let found = self.fill(1)?.len();
            if found == 0 {
                break;
            }
            let step = left.min(found as u64);
            self.consume(step as usize);
            left -= step;
        }
        Ok(count - left)
    }

    /// The offset of the next byte.
    pub fn offset(&self) -> u64 {
        self.offset
    }

    /// How many bytes are left, if the size of the input is known.
    pub fn remaining(&self) -> Option<u64> {
        self.size.map(|size| size.saturating_sub(self.offset))
    }

    /// The number, counted from 1, of the line given last.
    pub fn line_number(&self) -> u64 {
        self.line_number
    }

    /// How many of `count` rows of at least `row_bytes` bytes to make room for: never more than
    /// the input can hold, and few if its size is not known.
    pub fn room_for(&self, count: u64, row_bytes: u64) -> usize {
        const UNKNOWN_SIZE: u64 = 1 << 14;
        const KNOWN_SIZE: u64 = 1 << 26;
        let held = match self.remaining() {
            Some(remaining) => (remaining / row_bytes.max(1)).min(KNOWN_SIZE),
            None => UNKNOWN_SIZE,
        };
        count.min(held) as usize
    }

    /// The next line without its end, which is LF, CR or CRLF; `None` at the end of the input.
    ///
    /// # Errors
    /// The input cannot be read, or the line does not fit into [`CAPACITY`] bytes.
    pub fn line(&mut self) -> Result<Option<&[u8]>, Problem> {
        if self.after_cr {
            self.after_cr = false;
            if self.fill(1)?.first() == Some(&b'\n') {
                self.consume(1);
                self.has_line_feeds = true;
            }
        }
        let mut searched = 0;
        let (length, end) = loop {
            let bytes = self.at_hand();
            if let Some(found) = bytes[searched..].iter().position(is_line_end) {
                break (searched + found, 1);
            }
            searched = bytes.len();
            if searched == CAPACITY {
                return Err(Problem::malformed(
                    Place::Line(self.line_number + 1),
                    format!("a line of fewer than {CAPACITY} bytes"),
                    "a longer one",
                ));
            }
            if self.fill(searched + 1)?.len() == searched {
                break (searched, 0);
            }
        };
        if length + end == 0 {
            return Ok(None);
        }
        let first = self.start;
        self.consume(length + end);
        self.line_number += 1;
        match self.buffer[first..first + length + end].last() {
            Some(b'\r') => self.after_cr = true,
            Some(b'\n') => self.has_line_feeds = true,
            _ => {}
        }
        Ok(Some(&self.buffer[first..first + length]))
    }

    /// Ends reading by lines: decides whether an LF after the CR that ended the last line is the
    /// other half of a CRLF or the first byte of what follows.
    ///
    /// The number of bytes expected to follow decides where it is known and fits one of the two;
    /// else the LF belongs to the line end, unless all lines before ended in bare CRs.
    pub fn end_of_lines(&mut self, expected: Option<u64>) -> io::Result<()> {
        let undecided = self.after_cr && self.fill(1)?.first() == Some(&b'\n');
        self.after_cr = false;
        let is_line_end = match (self.remaining(), expected) {
            (Some(remaining), Some(expected)) if remaining == expected => false,
            (Some(remaining), Some(expected)) if remaining == expected.saturating_add(1) => true,
            _ => self.has_line_feeds,
        };
        if undecided && is_line_end {
            self.consume(1);
        }
        Ok(())
    }

    /// Checks that nothing but blanks, line ends and NUL padding follows.
    ///
    /// # Errors
    /// The input cannot be read, or something else follows.
    pub fn expect_padding(&mut self) -> Result<(), Problem> {
        let is_padding = |byte: &u8| *byte == 0 || byte.is_ascii_whitespace();
        let end = self.offset.saturating_add(PADDING_LIMIT);
        while self.offset < end {
            let bytes = self.fill(1)?;
            let found = bytes.len();
            if let Some(index) = bytes.iter().position(|byte| !is_padding(byte)) {
                let rest = excerpt(&bytes[index..]);
                return Err(Problem::malformed(
                    Place::Byte(self.offset + index as u64),
                    "the end of the data, since all rows that the header declares are read",
                    rest,
                ));
            }
            if found == 0 {
                break;
            }
            self.consume(found);
        }
        Ok(())
    }
}

fn is_line_end(byte: &u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives one byte a call, as a slow pipe would.
    struct Trickle<'a>(&'a [u8]);

    impl Read for Trickle<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let count = self.0.len().min(1);
            self.0.read(&mut buffer[..count])
        }
    }

    fn lines(reader: impl Read) -> Vec<Vec<u8>> {
        let mut input = Input::new(reader, None);
        let mut lines = Vec::new();
        while let Some(line) = input.line().unwrap() {
            lines.push(line.to_vec());
        }
        lines
    }

    #[test]
    fn lines_end_in_any_way() {
        let text = b"a\nb\rc\r\n\r\n\n\rd";
        let expected: [&[u8]; 7] = [b"a", b"b", b"c", b"", b"", b"", b"d"];
        assert_eq!(lines(&text[..]), expected);
        assert_eq!(lines(Trickle(text)), expected);
    }

    #[test]
    fn an_endless_line_is_an_error() {
        let mut input = Input::new(io::repeat(b'a'), None);
        assert!(matches!(input.line(), Err(Problem::Malformed { .. })));
    }

    #[test]
    fn a_line_feed_after_a_carriage_return_is_told_from_data() {
        let rest = |text: &[u8], lines: usize, size, expected| {
            let mut input = Input::new(text, size);
            for _ in 0..lines {
                input.line().unwrap();
            }
            input.end_of_lines(expected).unwrap();
            input.fill(9).unwrap().to_vec()
        };
        assert_eq!(rest(b"a\r\nb\r\n\nx", 2, None, None), b"\nx");
        assert_eq!(rest(b"a\nb\r\nx", 2, None, None), b"x");
        assert_eq!(rest(b"a\rb\r\nx", 2, None, None), b"\nx");
        assert_eq!(rest(b"a\rb\r\nx", 2, Some(6), Some(2)), b"\nx");
        assert_eq!(rest(b"a\rb\r\nx", 2, Some(6), Some(1)), b"x");
        assert_eq!(rest(b"a\r\nb\r\nx", 2, Some(7), Some(2)), b"\nx");
    }

    #[test]
    fn bytes_are_filled_skipped_and_counted() {
        let mut input = Input::new(Trickle(b"abcdef"), Some(6));
        assert_eq!(input.fill(2).unwrap(), b"ab");
        input.consume(1);
        assert_eq!(input.skip(2).unwrap(), 2);
        assert_eq!((input.offset(), input.remaining()), (3, Some(3)));
        assert_eq!(input.fill(9).unwrap(), b"def");
        assert_eq!(input.skip(9).unwrap(), 3);
    }

    #[test]
    fn room_is_bounded_by_what_the_input_can_hold() {
        let known = Input::new(io::empty(), Some(1200));
        assert_eq!(known.room_for(u64::MAX, 12), 100);
        assert_eq!(known.room_for(7, 12), 7);
        let unknown = Input::new(io::empty(), None);
        assert!(unknown.room_for(u64::MAX, 12) <= 1 << 14);
    }

    #[test]
    fn padding_may_follow_but_data_may_not() {
        assert!(Input::new(&b"\0\0 \n"[..], None).expect_padding().is_ok());
        let error = Input::new(&b"\n\0x"[..], None).expect_padding();
        assert!(error.unwrap_err().to_string().starts_with("byte 2: "));
        assert!(Input::new(io::repeat(0), None).expect_padding().is_ok());
    }
}
