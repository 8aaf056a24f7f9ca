//! Outputs: a file that is written whole or not at all, or stdout.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use super::error::CliError;
use super::input::is_stream;
use crate::cloud::{self, PointCloud};
use crate::model::Model;
use crate::output::write_whole;
use crate::report::{PointTable, PointTableFormat};
use crate::shape::Shape;
use crate::surface::Mesh;
use crate::surface::format::MeshFormat;

/// Writes text to a file, or to stdout where `-` was typed.
pub(super) fn write_text(path: &Path, text: &str) -> Result<(), CliError> {
    if is_stream(path) {
        return print(text);
    }
    Ok(write_whole(path, |writer| writer.write_all(text.as_bytes()))?)
}

/// Prints text to stdout.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()).map_err(CliError::Stdout)
}

/// The format in which points are written to a file: CSV to stdout.
pub(super) fn point_table_format(path: &Path) -> Result<PointTableFormat, CliError> {
    match is_stream(path) {
        true => Ok(PointTableFormat::Csv),
        false => Ok(PointTableFormat::from_extension(path)?),
    }
}

/// Writes points to a file, or to stdout where `-` was typed.
pub(super) fn write_point_table(
    path: &Path,
    format: PointTableFormat,
    table: &PointTable,
) -> Result<(), CliError> {
    if is_stream(path) {
        let mut stdout = BufWriter::new(io::stdout().lock());
        let written = table.write(format, &mut stdout).and_then(|()| stdout.flush());
        return written.map_err(CliError::Stdout);
    }
    Ok(write_whole(path, |writer| table.write(format, writer))?)
}

/// Writes the points as PLY, each with whether it is of the surface.
pub(super) fn write_inliers(
    path: &Path,
    cloud: &PointCloud,
    is_inlier: &[bool],
) -> Result<(), CliError> {
    Ok(write_whole(path, |writer| cloud::write_inliers(cloud, is_inlier, writer))?)
}

/// Writes a mesh in the format of the file's extension, and with it the plain model whose surface
/// it is, if there is one.
pub(super) fn write_mesh(
    path: &Path,
    mesh: &Mesh,
    model: Option<&Model<Shape>>,
) -> Result<(), CliError> {
    let format = MeshFormat::from_extension(path)?;
    Ok(write_whole(path, |writer| format.write(mesh, model, writer))?)
}
