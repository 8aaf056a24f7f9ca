//! The model's parameters, inscribed in the file of its mesh.
//!
//! What is inscribed is the model's JSON document, on one line, whose numbers read back as the
//! same doubles. The 80 bytes of STL's header do not hold eleven doubles; see `stl_header.rs`.

use std::io::{self, Read};

use thiserror::Error;

use crate::error::ModelError;
use crate::model::Model;
use crate::report::{DocumentError, ModelDocument, any_model_from_json};
use crate::shape::Shape;

/// What the line, or the key, of an inscribed model is called.
pub(super) const KEYWORD: &str = "superquadric";

/// Most bytes of a text header that are looked through.
const HEADER_BYTES: u64 = 1 << 16;

/// A mesh file without a model's parameters, or with broken ones.
#[derive(Debug, Error)]
pub enum InscriptionError {
    /// The file ends early, or cannot be read.
    #[error("cannot read the mesh file: {0}")]
    Io(#[from] io::Error),
    /// No parameters where they would stand.
    #[error("no model is inscribed: expected {0}")]
    Missing(&'static str),
    /// Parameters that are not the JSON of a model.
    #[error("the inscribed model: {0}")]
    Document(#[from] DocumentError),
    /// Parameters outside their domain.
    #[error("the inscribed model: {0}")]
    Parameters(#[from] ModelError),
}

/// The line of text that a model is inscribed as.
pub(super) fn line(model: &Model<Shape>) -> io::Result<String> {
    let json = serde_json::to_string(&ModelDocument::from(model)).map_err(io::Error::other)?;
    Ok(format!("{KEYWORD} {json}"))
}

/// The model on the first line that begins with `comment` and the keyword.
pub(super) fn read(
    reader: &mut (impl Read + ?Sized),
    comment: &str,
    expected: &'static str,
) -> Result<Model<Shape>, InscriptionError> {
    let mut header = Vec::new();
    reader.take(HEADER_BYTES).read_to_end(&mut header)?;
    let text = String::from_utf8_lossy(&header);
    let json = text.lines().find_map(|line| {
        line.strip_prefix(comment)?.trim_start().strip_prefix(KEYWORD)?.strip_prefix(' ')
    });
    Ok(any_model_from_json(json.ok_or(InscriptionError::Missing(expected))?)?)
}
