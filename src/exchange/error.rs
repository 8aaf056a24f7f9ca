//! What can go wrong between other programs and us.

use thiserror::Error;

use crate::error::ModelError;
use crate::model::Model;

/// A shape that a program cannot express.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ExportError {
    /// An exponent outside the program's range.
    #[error("{program} takes exponents {range}, found exponents[{index}] = {value}")]
    Exponent {
        /// The program's name.
        program: &'static str,
        /// What it takes.
        range: &'static str,
        /// Index of the exponent.
        index: usize,
        /// The value found.
        value: f64,
    },
}

/// Makes sure that a program takes both exponents.
pub(super) fn require_exponents(
    model: &Model,
    program: &'static str,
    range: &'static str,
    is_taken: impl Fn(f64) -> bool,
) -> Result<(), ExportError> {
    let exponents = model.shape.exponents();
    match exponents.iter().position(|&e| !is_taken(e)) {
        Some(index) => {
            Err(ExportError::Exponent { program, range, index, value: exponents[index] })
        }
        None => Ok(()),
    }
}

/// Makes sure that the solid is one of those that contact solvers take.
pub(super) fn require_exponents_up_to_one(
    model: &Model,
    program: &'static str,
) -> Result<(), ExportError> {
    require_exponents(model, program, "up to 1", |e| e <= 1.0)
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
