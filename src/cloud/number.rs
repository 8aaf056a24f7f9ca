//! Numbers and rows of tokens as text formats write them.

/// The number a token spells, or `None`; every spelling of NaN and infinity is understood, also
/// those of the C runtimes: `nan(ind)`, `1.#QNAN`, `1.#INF`.
pub(super) fn parse(token: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(token).ok()?;
    text.parse().ok().or_else(|| parse_not_finite(text))
}

fn parse_not_finite(text: &str) -> Option<f64> {
    let text = text.to_ascii_lowercase();
    let text = text.strip_prefix(['-', '+']).unwrap_or(&text);
    if text.starts_with("nan(") && text.ends_with(')') {
        return Some(f64::NAN);
    }
    let kind = text.strip_prefix("1.#")?.trim_end_matches('0');
    match kind {
        "inf" => Some(f64::INFINITY),
        "nan" | "qnan" | "snan" | "ind" => Some(f64::NAN),
        _ => None,
    }
}

/// The tokens of a line, which blanks part.
pub(super) fn tokens(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|token| !token.is_empty())
}

/// The whole number a token spells in decimal digits alone, or `None`.
pub(super) fn parse_count(token: &[u8]) -> Option<u64> {
    let digits = token.iter().all(u8::is_ascii_digit);
    digits.then(|| std::str::from_utf8(token).ok()?.parse().ok())?
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_parsed_exactly() {
        for (token, value) in [
            ("1", 1.0),
            ("-0.1", -0.1),
            ("+.5", 0.5),
            ("2.", 2.0),
            ("1e-3", 1e-3),
            ("1E+3", 1e3),
            ("1234567890.12345", 1234567890.12345),
        ] {
            assert_eq!(parse(token.as_bytes()), Some(value), "{token}");
        }
    }

    #[test]
    fn every_spelling_of_not_finite_is_understood() {
        for token in [
            "nan",
            "NaN",
            "-nan",
            "inf",
            "-Infinity",
            "1e999",
            "nan(ind)",
            "-NaN(snan)",
            "1.#QNAN",
            "-1.#IND",
            "1.#INF",
            "1.#INF00",
            "1.#SNAN",
        ] {
            let value = parse(token.as_bytes());
            assert!(value.is_some_and(|value| !value.is_finite()), "{token}");
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for token in ["", "x", "1,5", "1.2.3", "0x10", "1d3", "1_000", "1.#", "nan(", "--1"] {
            assert_eq!(parse(token.as_bytes()), None, "{token}");
        }
        assert_eq!(parse(b"1\xff"), None);
    }

    #[test]
    fn counts_are_digits_alone() {
        assert_eq!(parse_count(b"007"), Some(7));
        for token in ["", "-1", "+1", "1.0", "99999999999999999999"] {
            assert_eq!(parse_count(token.as_bytes()), None, "{token}");
        }
    }
}
