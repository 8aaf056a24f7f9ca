//! The JSON form of plane curves.

use nalgebra::Vector2;
use serde::{Deserialize, Serialize};

use super::document::to_json;
use super::model_document::DocumentError;
use crate::error::ModelError;
use crate::shape::{ClippedCurve, LameCurve, PlaneCurve, Polyline, Superellipse, Superhyperbola};

/// A curve, `{"curve": .., ..}`; a clip that is not given is
/// [`ClippedCurve::new`]'s own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "curve", rename_all = "snake_case", deny_unknown_fields)]
enum CurveDocument {
    Superellipse {
        size: [f64; 2],
        exponent: f64,
    },
    Superhyperbola {
        size: [f64; 2],
        exponent: f64,
        clip: Option<f64>,
    },
    Lame {
        size: [f64; 2],
        /// Of the exponent.
        numerator: i32,
        /// Of the exponent.
        denominator: u32,
        clip: Option<f64>,
    },
    Polyline {
        points: Vec<[f64; 2]>,
        #[serde(default)]
        closed: bool,
    },
}

impl From<&ClippedCurve> for CurveDocument {
    fn from(clipped: &ClippedCurve) -> Self {
        let clip = Some(clipped.clip());
        match clipped.curve() {
            PlaneCurve::Superellipse(c) => {
                Self::Superellipse { size: c.size(), exponent: c.exponent() }
            }
            PlaneCurve::Superhyperbola(c) => {
                Self::Superhyperbola { size: c.size(), exponent: c.exponent(), clip }
            }
            PlaneCurve::Lame(c) => {
                let (numerator, denominator) = (c.numerator(), c.denominator());
                Self::Lame { size: c.size(), numerator, denominator, clip }
            }
            PlaneCurve::Polyline(line) => Self::Polyline {
                points: line.points().iter().map(|&x| x.into()).collect(),
                closed: line.is_closed(),
            },
        }
    }
}

impl TryFrom<CurveDocument> for ClippedCurve {
    type Error = ModelError;

    fn try_from(document: CurveDocument) -> Result<Self, ModelError> {
        match document {
            CurveDocument::Superellipse { size, exponent } => {
                Self::new(PlaneCurve::Superellipse(Superellipse::new(size, exponent)?), None)
            }
            CurveDocument::Superhyperbola { size, exponent, clip } => {
                Self::new(PlaneCurve::Superhyperbola(Superhyperbola::new(size, exponent)?), clip)
            }
            CurveDocument::Lame { size, numerator, denominator, clip } => {
                Self::new(PlaneCurve::Lame(LameCurve::new(size, numerator, denominator)?), clip)
            }
            CurveDocument::Polyline { points, closed } => {
                let points = points.into_iter().map(Vector2::from).collect();
                Self::new(PlaneCurve::Polyline(Polyline::new(points, closed)?), None)
            }
        }
    }
}

/// The curve in a JSON text: `{"curve": "superellipse", "size": [a, b], "exponent": e}`,
/// `{"curve": "superhyperbola", ..}` with the same and perhaps a `clip`, or `{"curve": "lame",
/// "size": [a, b], "numerator": p, "denominator": q}`, also perhaps with a `clip`: see
/// [`ClippedCurve`]. Any other curve is a `{"curve": "polyline", "points": [[x, y], ..]}`, perhaps
/// `"closed": true`: see [`Polyline`].
///
/// # Errors
/// If the text is not JSON, lacks a key or has one too many, or has parameters outside their
/// domain.
pub fn curve_from_json(text: &str) -> Result<ClippedCurve, DocumentError> {
    let document: CurveDocument = serde_json::from_str(text).map_err(DocumentError::Curve)?;
    Ok(document.try_into()?)
}

/// Indented JSON of a curve with a final newline; [`curve_from_json`] reads it back.
pub fn curve_to_json(curve: &ClippedCurve) -> String {
    to_json(&CurveDocument::from(curve))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_come_back_from_their_documents() {
        let texts = [
            r#"{"curve": "superellipse", "size": [2, 0.3], "exponent": 0.1}"#,
            r#"{"curve": "superhyperbola", "size": [2, 0.3], "exponent": 1.7}"#,
            r#"{"curve": "superhyperbola", "size": [2, 0.3], "exponent": 1.7, "clip": 3.5}"#,
            r#"{"curve": "lame", "size": [2, 0.3], "numerator": -2, "denominator": 6}"#,
            r#"{"curve": "lame", "size": [2, 0.3], "numerator": 3, "denominator": 1, "clip": 5}"#,
            r#"{"curve": "polyline", "points": [[0, 1], [0.1, -3e7]]}"#,
            r#"{"curve": "polyline", "points": [[0, 1], [2, 3], [4, 5]], "closed": true}"#,
        ];
        for text in texts {
            let curve = curve_from_json(text).unwrap();
            assert_eq!(curve_from_json(&curve_to_json(&curve)).unwrap(), curve);
        }
        let reduced = curve_from_json(texts[3]).unwrap();
        let PlaneCurve::Lame(curve) = reduced.curve() else {
            panic!("a Lame curve");
        };
        assert_eq!((curve.numerator(), curve.denominator()), (-1, 3));
    }

    #[test]
    fn what_is_wrong_is_named() {
        let cases = [
            ("{", "line 1"),
            (r#"{"size": [1, 1], "exponent": 1}"#, "`curve`"),
            (r#"{"curve": "cone", "size": [1, 1], "exponent": 1}"#, "`superhyperbola`"),
            (r#"{"curve": "superellipse", "size": [1, 1]}"#, "`exponent`"),
            (r#"{"curve": "superellipse", "size": [1, 1], "exponent": 1, "clip": 2}"#, "`clip`"),
            (r#"{"curve": "superellipse", "size": [1, 1, 1], "exponent": 1}"#, "length 3"),
            (r#"{"curve": "superellipse", "size": [1, -1], "exponent": 1}"#, "size[1]"),
            (r#"{"curve": "superhyperbola", "size": [1, 1], "exponent": 1, "clip": 1}"#, "above 1"),
            (r#"{"curve": "lame", "size": [1, 1], "numerator": 1, "denominator": 0}"#, "1/0"),
            (r#"{"curve": "polyline"}"#, "`points`"),
            (r#"{"curve": "polyline", "points": [[0, 1]]}"#, "found 1"),
            (r#"{"curve": "polyline", "points": [[0, 1], [0, 1]]}"#, "points[0]"),
            (r#"{"curve": "polyline", "points": [[0, 1], [1e999, 1]]}"#, "out of range"),
            (r#"{"curve": "polyline", "points": [[0, 1], [1, null]]}"#, "null"),
            (r#"{"curve": "polyline", "points": [[0, 1], [1, 1, 1]]}"#, "length 3"),
        ];
        for (text, expected) in cases {
            let message = curve_from_json(text).unwrap_err().to_string();
            assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        }
    }
}
