//! How the fields of a line are parted.

/// What stands between two fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Separator {
    /// This byte, so that a field may be empty.
    Byte(u8),
    /// Any run of blanks.
    Blanks,
}

impl Separator {
    /// The separator that a line seems to use: semicolon before tab, comma and blanks.
    pub fn of(line: &[u8]) -> Self {
        if line.contains(&b';') {
            Self::Byte(b';')
        } else if is_tabular(line) {
            Self::Byte(b'\t')
        } else if line.contains(&b',') {
            Self::Byte(b',')
        } else {
            Self::Blanks
        }
    }

    /// The fields of a line without the blanks and double quotes around them.
    pub fn fields(self, line: &[u8]) -> Fields<'_> {
        Fields { separator: self, rest: Some(line) }
    }
}

/// Whether tabs part a line into three or more fields, the first three of which hold no blanks.
fn is_tabular(line: &[u8]) -> bool {
    let mut fields = Separator::Byte(b'\t').fields(line);
    let is_plain = |field: &[u8]| !field.iter().any(u8::is_ascii_whitespace);
    (0..3).all(|_| fields.next().is_some_and(is_plain))
}

/// The fields of a line.
pub(super) struct Fields<'l> {
    separator: Separator,
    rest: Option<&'l [u8]>,
}

impl<'l> Iterator for Fields<'l> {
    type Item = &'l [u8];

    fn next(&mut self) -> Option<&'l [u8]> {
        let mut rest = self.rest?;
        if self.separator == Separator::Blanks {
            rest = rest.trim_ascii();
            if rest.is_empty() {
                return None;
            }
        }
        let mut is_quoted = false;
        let end = rest.iter().position(|&byte| {
            is_quoted ^= byte == b'"';
            !is_quoted
                && match self.separator {
                    Separator::Byte(separator) => byte == separator,
                    Separator::Blanks => byte.is_ascii_whitespace(),
                }
        });
        let field = &rest[..end.unwrap_or(rest.len())];
        self.rest = end.map(|end| &rest[end + 1..]);
        Some(unquoted(field.trim_ascii()))
    }
}

fn unquoted(field: &[u8]) -> &[u8] {
    let inner = field.strip_prefix(b"\"").and_then(|field| field.strip_suffix(b"\""));
    inner.map_or(field, <[u8]>::trim_ascii)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fields(line: &str) -> Vec<String> {
        let line = line.as_bytes();
        let fields = Separator::of(line).fields(line);
        fields.map(|field| String::from_utf8_lossy(field).into_owned()).collect()
    }

    #[test]
    fn fields_are_parted_as_the_line_suggests() {
        assert_eq!(fields("  1 2\t 3 "), ["1", "2", "3"]);
        assert_eq!(fields("1,2 , 3"), ["1", "2", "3"]);
        assert_eq!(fields("1;2,5;;3"), ["1", "2,5", "", "3"]);
        assert_eq!(fields("1\t\t3\ta b"), ["1", "", "3", "a b"]);
        assert_eq!(fields("1 2\t3"), ["1", "2", "3"]);
        assert_eq!(fields("1,"), ["1", ""]);
    }

    #[test]
    fn quotes_hold_a_field_together() {
        assert_eq!(fields("\"a,b\",\"2\", x"), ["a,b", "2", "x"]);
        assert_eq!(fields("\" x\" \"y z\""), ["x", "y z"]);
        assert_eq!(fields("\"a,b"), ["\"a,b"]);
    }
}
