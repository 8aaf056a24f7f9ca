//! Lines of text in words, which know where they stand.

use super::error::ImportError;

/// Characters of a word that are quoted in a message, at most.
const EXCERPT_CHARS: usize = 40;

/// The words of one line.
#[derive(Debug, Clone)]
pub(super) struct Line<'a> {
    /// Number of the line in its text, from 1.
    pub number: usize,
    /// What stands between white space.
    pub words: Vec<&'a str>,
}

/// The lines of a text that are not empty, without what follows a comment sign.
pub(super) fn lines(text: &str, comment: char) -> impl Iterator<Item = Line<'_>> {
    text.lines().enumerate().filter_map(move |(index, line)| {
        let line = line.split(comment).next()?;
        let words: Vec<&str> = line.split_whitespace().collect();
        (!words.is_empty()).then_some(Line { number: index + 1, words })
    })
}

impl<'a> Line<'a> {
    /// The error of another word, or no word, than was expected at a place.
    pub fn unexpected(&self, index: usize, expected: &str) -> ImportError {
        let found = self.words.get(index).copied().unwrap_or("the end of the line");
        ImportError::Malformed {
            line: self.number,
            expected: expected.to_owned(),
            found: found.chars().take(EXCERPT_CHARS).collect(),
        }
    }

    /// The finite numbers from a word on.
    pub fn numbers<const N: usize>(
        &self,
        from: usize,
        what: &str,
    ) -> Result<[f64; N], ImportError> {
        let mut numbers = [0.0; N];
        for (i, number) in numbers.iter_mut().enumerate() {
            *number = self.number_at(from.saturating_add(i), what)?;
        }
        Ok(numbers)
    }

    /// The finite number at a word.
    pub fn number_at(&self, index: usize, what: &str) -> Result<f64, ImportError> {
        let number = self.words.get(index).and_then(|word| word.parse::<f64>().ok());
        number
            .filter(|number| number.is_finite())
            .ok_or_else(|| self.unexpected(index, &format!("a number ({what})")))
    }

    /// The finite numbers after the first word that is a keyword, if there is one.
    pub fn after<const N: usize>(&self, keyword: &str) -> Result<Option<[f64; N]>, ImportError> {
        match self.words.iter().position(|word| *word == keyword) {
            Some(at) => self.numbers(at + 1, keyword).map(Some),
            None => Ok(None),
        }
    }
}
