//! Inputs: a file, or stdin where `-` was typed.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::error::CliError;
use crate::cloud::{self, PointCloud};
use crate::model::Model;
use crate::report::{DocumentError, model_from_json, primitive_from_json};
use crate::solid::Primitive;

/// Most bytes that a model's document may have: a fit has less than a thousand.
const MODEL_BYTES: u64 = 1 << 20;

/// Whether a path stands for stdin or stdout.
pub(super) fn is_stream(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// The name of an input in messages.
pub(super) fn name(path: &Path) -> String {
    if is_stream(path) { "stdin".to_owned() } else { path.display().to_string() }
}

/// The cloud in a file or on stdin.
pub(super) fn read_cloud(path: &Path) -> Result<PointCloud, CliError> {
    if is_stream(path) {
        Ok(cloud::read_stream(&name(path), io::stdin().lock())?)
    } else {
        Ok(cloud::read(path)?)
    }
}

/// The model in a JSON file or on stdin.
pub(super) fn read_model(path: &Path) -> Result<Model, CliError> {
    read_document(path, model_from_json)
}

/// The model in a JSON file or on stdin, with its deformations.
pub(super) fn read_primitive(path: &Path) -> Result<Primitive, CliError> {
    read_document(path, primitive_from_json)
}

fn read_document<T>(
    path: &Path,
    parse: impl Fn(&str) -> Result<T, DocumentError>,
) -> Result<T, CliError> {
    let text = read_text(path).map_err(|source| CliError::Input { name: name(path), source })?;
    parse(&text).map_err(|source| CliError::Document { name: name(path), source })
}

fn read_text(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    let reader: &mut dyn Read =
        if is_stream(path) { &mut io::stdin().lock() } else { &mut File::open(path)? };
    let bytes = reader.take(MODEL_BYTES + 1).read_to_string(&mut text)?;
    if bytes as u64 > MODEL_BYTES {
        return Err(io::Error::new(
            io::ErrorKind::InvalidData,
            "longer than 1 MiB: not the JSON of a model",
        ));
    }
    Ok(text)
}
