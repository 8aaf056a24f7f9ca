//! Contours for machines and for browsers: JSON and SVG.

use std::fmt::Write;
use std::path::Path;

use serde::Serialize;
use thiserror::Error;

use super::rim_curve::RimCurve;
use super::silhouette::Outline;

/// Name and version of the document of a contour.
const CONTOUR_SCHEMA: &str = "superquadric.contour/1";

/// A file format for contours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContourFormat {
    /// `superquadric.contour/1`.
    Json,
    /// A path, to be laid over the image.
    Svg,
}

/// A file name that does not say which format is meant.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{path}: the extension of a contour's file must be json or svg")]
pub struct UnknownContourFormat {
    /// The file name.
    pub path: String,
}

impl ContourFormat {
    /// The format of a file, from its extension in upper or lower case.
    ///
    /// # Errors
    /// If the extension is neither `json` nor `svg`.
    pub fn from_extension(path: impl AsRef<Path>) -> Result<Self, UnknownContourFormat> {
        let path = path.as_ref();
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("json") => Ok(Self::Json),
            Some("svg") => Ok(Self::Svg),
            _ => Err(UnknownContourFormat { path: path.display().to_string() }),
        }
    }

    /// The text of a contour in an image of so many columns and rows.
    pub fn text(self, outline: &Outline, size: [u32; 2]) -> String {
        match self {
            Self::Json => ContourDocument::new(outline, size).to_json(),
            Self::Svg => svg(outline, size),
        }
    }
}

/// A contour as JSON; polygons and rims are closed: the last point is next to the first.
#[derive(Serialize)]
struct ContourDocument {
    schema: &'static str,
    image: ImageDocument,
    contour: Vec<Vec<[f64; 2]>>,
    rim: Vec<RimDocument>,
    area: f64,
    bounding_box: [[f64; 2]; 2],
}

#[derive(Serialize)]
struct ImageDocument {
    width: u32,
    height: u32,
}

/// Points in the camera's frame, and whether the solid itself hides each.
#[derive(Serialize)]
struct RimDocument {
    points: Vec<[f64; 3]>,
    hidden: Vec<bool>,
}

impl ContourDocument {
    fn new(outline: &Outline, [width, height]: [u32; 2]) -> Self {
        Self {
            schema: CONTOUR_SCHEMA,
            image: ImageDocument { width, height },
            contour: outline.polygons().to_vec(),
            rim: outline.rim_camera().iter().map(RimDocument::from).collect(),
            area: outline.area(),
            bounding_box: outline.bounding_box(),
        }
    }

    fn to_json(&self) -> String {
        // Keys are strings and numbers are numbers: that always has a JSON form.
        serde_json::to_string(self).expect("the document is representable in JSON") + "\n"
    }
}

impl From<&RimCurve> for RimDocument {
    fn from(curve: &RimCurve) -> Self {
        let points = curve.points.iter().map(|x| (*x).into()).collect();
        Self { points, hidden: curve.is_hidden.clone() }
    }
}

/// The outline over an image whose first pixel's centre is (0, 0), to a thousandth of a pixel.
fn svg(outline: &Outline, [width, height]: [u32; 2]) -> String {
    let mut path = String::new();
    for polygon in outline.polygons() {
        for (i, [column, row]) in polygon.iter().enumerate() {
            let command = if i == 0 { 'M' } else { 'L' };
            // Writing to a string does not fail.
            let _ = write!(path, "{command}{column:.3} {row:.3}");
        }
        path.push('Z');
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"-0.5 -0.5 {width} {height}\">\n\
         <path d=\"{path}\" fill=\"none\" stroke=\"#e6007e\" stroke-width=\"1\" \
         stroke-linejoin=\"round\"/>\n\
         </svg>\n"
    )
}
