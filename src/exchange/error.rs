//! What can go wrong between other programs and us.

use thiserror::Error;

use crate::error::ModelError;

/// A shape that a program cannot express.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ExportError {
    /// A family that the program does not know.
    #[error("{program} cannot express a shape of the family {family}")]
    Family {
        /// The program's name.
        program: &'static str,
        /// The family's name in documents.
        family: &'static str,
    },
    /// An exponent outside the program's range.
    #[error(
        "{program} takes exponents from {least} to {greatest}, found exponents[{index}] = {value}"
    )]
    Exponent {
        /// The program's name.
        program: &'static str,
        /// The least that it takes.
        least: f64,
        /// The greatest that it takes.
        greatest: f64,
        /// Index of the exponent.
        index: usize,
        /// The value found.
        value: f64,
    },
    /// A supertoroid whose tube is too thin for the program.
    #[error("{program} takes rings up to {greatest}, found ring = {value}")]
    Ring {
        /// The program's name.
        program: &'static str,
        /// The greatest that it takes.
        greatest: f64,
        /// The value found.
        value: f64,
    },
}

/// A text that does not hold what its format promises.
#[derive(Debug, Error)]
pub enum ImportError {
    /// The format is not followed.
    #[error("line {line}: expected {expected}, found {found:?}")]
    Malformed {
        /// Number of the line, from 1.
        line: usize,
        /// What should stand there.
        expected: String,
        /// What stands there, shortened.
        found: String,
    },
    /// Parameters outside their domain.
    #[error("{place}: {source}")]
    Parameters {
        /// The line or the element.
        place: String,
        /// What is wrong with them.
        source: ModelError,
    },
    /// Not the JSON that was expected.
    #[error("expected {expected}: {source}")]
    Json {
        /// What should stand there.
        expected: &'static str,
        /// What stands there.
        source: serde_json::Error,
    },
    /// Nothing of the kind in the whole text.
    #[error("holds no superquadric: expected {0}")]
    None(&'static str),
}
