//! The JSON form of shapes.

use serde::{Deserialize, Serialize};

use crate::error::ModelError;
use crate::shape::{
    Shape, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
    ThreeExponent,
};

/// A shape, `{"family": .., "size": [..], "exponents": [..], ..}`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "family", rename_all = "snake_case")]
pub(super) enum ShapeDocument {
    Superellipsoid {
        size: [f64; 3],
        exponents: [f64; 2],
    },
    SuperhyperboloidOneSheet {
        size: [f64; 3],
        exponents: [f64; 2],
        /// Half of the height; a3 if it is not given.
        clip: Option<f64>,
    },
    SuperhyperboloidTwoSheets {
        size: [f64; 3],
        exponents: [f64; 2],
        /// The greatest |x|; twice a1 if it is not given.
        clip: Option<f64>,
    },
    Supertoroid {
        size: [f64; 3],
        exponents: [f64; 2],
        ring: f64,
    },
    ThreeExponent {
        size: [f64; 3],
        exponents: [f64; 3],
    },
}

impl From<Shape> for ShapeDocument {
    fn from(shape: Shape) -> Self {
        match shape {
            Shape::Superellipsoid(s) => {
                Self::Superellipsoid { size: s.size(), exponents: s.exponents() }
            }
            Shape::SuperhyperboloidOneSheet(s) => Self::SuperhyperboloidOneSheet {
                size: s.size(),
                exponents: s.exponents(),
                clip: Some(s.clip()),
            },
            Shape::SuperhyperboloidTwoSheets(s) => Self::SuperhyperboloidTwoSheets {
                size: s.size(),
                exponents: s.exponents(),
                clip: Some(s.clip()),
            },
            Shape::Supertoroid(s) => {
                Self::Supertoroid { size: s.size(), exponents: s.exponents(), ring: s.ring() }
            }
            Shape::ThreeExponent(s) => {
                Self::ThreeExponent { size: s.size(), exponents: s.exponents() }
            }
        }
    }
}

impl TryFrom<&ShapeDocument> for Shape {
    type Error = ModelError;

    fn try_from(document: &ShapeDocument) -> Result<Self, ModelError> {
        Ok(match *document {
            ShapeDocument::Superellipsoid { size, exponents } => {
                Superellipsoid::new(size, exponents)?.into()
            }
            ShapeDocument::SuperhyperboloidOneSheet { size, exponents, clip } => {
                let clip = clip.unwrap_or(size[2]);
                SuperhyperboloidOneSheet::new(size, exponents, clip)?.into()
            }
            ShapeDocument::SuperhyperboloidTwoSheets { size, exponents, clip } => {
                let clip = clip.unwrap_or(2.0 * size[0]);
                SuperhyperboloidTwoSheets::new(size, exponents, clip)?.into()
            }
            ShapeDocument::Supertoroid { size, exponents, ring } => {
                Supertoroid::new(size, exponents, ring)?.into()
            }
            ShapeDocument::ThreeExponent { size, exponents } => {
                ThreeExponent::new(size, exponents)?.into()
            }
        })
    }
}
