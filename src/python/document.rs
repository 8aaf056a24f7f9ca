//! Documents as dictionaries, and from files.

use std::path::{Path, PathBuf};

use pyo3::prelude::*;

use super::errors::os_error;
use crate::output::write_whole;

/// The dictionary of a JSON text.
pub(super) fn to_python<'py>(py: Python<'py>, json: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (json,))
}

/// The JSON text of a dictionary.
pub(super) fn from_python(document: &Bound<'_, PyAny>) -> PyResult<String> {
    document.py().import("json")?.call_method1("dumps", (document,))?.extract()
}

/// Writes a document to a file, whole or not at all.
pub(super) fn save(path: PathBuf, json: &str) -> PyResult<()> {
    Ok(write_whole(path, |writer| writer.write_all(json.as_bytes()))?)
}

/// The text in a file.
pub(super) fn read_text(path: &Path) -> PyResult<String> {
    let bytes = std::fs::read(path).map_err(|error| {
        os_error(error.kind(), format!("cannot read {}: {error}", path.display()))
    })?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
