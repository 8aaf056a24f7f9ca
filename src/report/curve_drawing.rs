//! Points along plane curves as a table and as a drawing.

use std::fmt::Write;
use std::path::Path;

use thiserror::Error;

use crate::shape::Polyline;

/// Longer side of a drawing in pixels, without its margins.
const LONGER_SIDE: f64 = 400.0;
/// Margin around a drawing in pixels.
const MARGIN: f64 = 10.0;

/// A file format for plane curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurveFormat {
    /// Columns `branch`, `x` and `y`, in the unit of the curve's size; text that reads back as the
    /// same doubles.
    Csv,
    /// A path, y upwards.
    Svg,
}

/// A file name that does not say which format is meant.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{path}: the extension of a curve's file must be csv or svg")]
pub struct UnknownCurveFormat {
    /// The file name.
    pub path: String,
}

impl CurveFormat {
    /// The format of a file, from its extension in upper or lower case.
    ///
    /// # Errors
    /// If the extension is neither `csv` nor `svg`.
    pub fn from_extension(path: impl AsRef<Path>) -> Result<Self, UnknownCurveFormat> {
        let path = path.as_ref();
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("csv") => Ok(Self::Csv),
            Some("svg") => Ok(Self::Svg),
            _ => Err(UnknownCurveFormat { path: path.display().to_string() }),
        }
    }

    /// The text of a curve's branches.
    pub fn text(self, branches: &[Polyline]) -> String {
        match self {
            Self::Csv => csv(branches),
            Self::Svg => svg(branches),
        }
    }
}

fn csv(branches: &[Polyline]) -> String {
    let mut text = String::from("branch,x,y\n");
    for (branch, line) in branches.iter().enumerate() {
        for x in line.points() {
            // Writing to a string does not fail.
            let _ = writeln!(text, "{branch},{},{}", x.x, x.y);
        }
    }
    text
}

/// The branches, to a thousandth of a pixel, scaled to the drawing.
fn svg(branches: &[Polyline]) -> String {
    let points = || branches.iter().flat_map(Polyline::points);
    let extent = |f: fn(f64, f64) -> f64, axis: usize| points().map(|x| x[axis]).reduce(f);
    let [left, right] = [f64::min, f64::max].map(|f| extent(f, 0).unwrap_or(0.0));
    let [bottom, top] = [f64::min, f64::max].map(|f| extent(f, 1).unwrap_or(0.0));
    let scale = LONGER_SIDE / (right - left).max(top - bottom).max(f64::MIN_POSITIVE);
    let mut path = String::new();
    for line in branches {
        for (i, x) in line.points().iter().enumerate() {
            let command = if i == 0 { 'M' } else { 'L' };
            let [column, row] = [x.x - left, top - x.y].map(|length| length * scale + MARGIN);
            // Writing to a string does not fail.
            let _ = write!(path, "{command}{column:.3} {row:.3}");
        }
        if line.is_closed() {
            path.push('Z');
        }
    }
    let [width, height] = [right - left, top - bottom].map(|length| length * scale + 2.0 * MARGIN);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}\" height=\"{height:.3}\">\n\
         <path d=\"{path}\" fill=\"none\" stroke=\"#000\" stroke-width=\"1\" \
         stroke-linejoin=\"round\"/>\n\
         </svg>\n"
    )
}
