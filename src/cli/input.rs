//! Inputs: a file, or stdin where `-` was typed.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::error::CliError;
use crate::cloud::{self, PointCloud};
use crate::model::Model;
use crate::ray::Scene;
use crate::report::{
    DocumentError, any_model_from_json, curve_from_json, scene_from_json, scene_from_toml,
};
use crate::shape::{ClippedCurve, Shape};
use crate::solid::{Primitive, Tree};
use crate::surface::format::MeshFormat;

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

/// The model of any family in a JSON file or on stdin.
pub(super) fn read_any_model(path: &Path) -> Result<Model<Shape>, CliError> {
    read_document(path, any_model_from_json)
}

/// The one model, deformed or not, in a JSON or TOML file, or in JSON on stdin.
pub(super) fn read_primitive(path: &Path) -> Result<Primitive<Shape>, CliError> {
    match read_scene(path)?.solid() {
        Tree::Leaf(primitive) => Ok(primitive),
        _ => Err(CliError::Several(name(path))),
    }
}

/// The scene, or solid alone, in a JSON or TOML file, or in JSON on stdin.
pub(super) fn read_scene(path: &Path) -> Result<Scene, CliError> {
    let is_toml = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
    read_document(path, if is_toml { scene_from_toml } else { scene_from_json })
}

/// The plane curve in a JSON file or on stdin.
pub(super) fn read_curve(path: &Path) -> Result<ClippedCurve, CliError> {
    read_document(path, curve_from_json)
}

fn read_document<T>(
    path: &Path,
    parse: impl Fn(&str) -> Result<T, DocumentError>,
) -> Result<T, CliError> {
    let text = read_text(path, MODEL_BYTES)?;
    parse(&text).map_err(|source| CliError::Document { name: name(path), source })
}

/// The model that a mesh file keeps, in the format of its extension.
pub(super) fn read_mesh_model(path: &Path) -> Result<Model<Shape>, CliError> {
    let format = MeshFormat::from_extension(path)?;
    let mut file = File::open(path).map_err(|source| unreadable(path, source))?;
    format
        .read_model(&mut file)
        .map_err(|source| CliError::Inscription { name: name(path), source })
}

/// The text in a file or on stdin, of no more than so many bytes.
pub(super) fn read_text(path: &Path, most_bytes: u64) -> Result<String, CliError> {
    let read = || {
        let mut text = String::new();
        let reader: &mut dyn Read =
            if is_stream(path) { &mut io::stdin().lock() } else { &mut File::open(path)? };
        let bytes = reader.take(most_bytes + 1).read_to_string(&mut text)?;
        if bytes as u64 > most_bytes {
            let message = format!("longer than {} MiB", most_bytes >> 20);
            return Err(io::Error::new(io::ErrorKind::InvalidData, message));
        }
        Ok(text)
    };
    read().map_err(|source| unreadable(path, source))
}

fn unreadable(path: &Path, source: io::Error) -> CliError {
    CliError::Input { name: name(path), source }
}
