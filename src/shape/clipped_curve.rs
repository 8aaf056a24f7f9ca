//! Plane curves, whole or as far as a clip.

use super::{LameCurve, Polyline, Superellipse, Superhyperbola};
use crate::error::ModelError;

/// A plane curve that has a name, or any other as a polyline.
#[derive(Debug, Clone, PartialEq)]
pub enum PlaneCurve {
    /// `|x/a|^(2/e) + |y/b|^(2/e) = 1`.
    Superellipse(Superellipse),
    /// `|x/a|^(2/e) - |y/b|^(2/e) = 1`.
    Superhyperbola(Superhyperbola),
    /// `(x/a)^m + (y/b)^m = 1`.
    Lame(LameCurve),
    /// Straight edges from point to point.
    Polyline(Polyline),
}

impl PlaneCurve {
    /// The clip, a ratio, below which nothing is left of a branch: 1, or where `(x/a)^m = (y/b)^m`
    /// on a Lame curve of negative m.
    fn least_clip(&self) -> f64 {
        match self {
            Self::Lame(curve) if curve.exponent() < 0.0 => (-curve.exponent().recip()).exp2(),
            _ => 1.0,
        }
    }
}

/// The part `|x/a| <= clip`, `|y/b| <= clip` of a plane curve, which is all of a bounded one.
#[derive(Debug, Clone, PartialEq)]
pub struct ClippedCurve {
    curve: PlaneCurve,
    clip: f64,
}

impl ClippedCurve {
    /// A curve, and the clip of its unbounded branches, a ratio to the semi-axes. Without one it
    /// is twice the least that leaves something of every branch: 2, or `2^(1 - 1/m)` for a Lame
    /// curve of negative m.
    ///
    /// # Errors
    /// If the clip is not above the least, or not finite.
    pub fn new(curve: PlaneCurve, clip: Option<f64>) -> Result<Self, ModelError> {
        let least = curve.least_clip();
        let clip = clip.unwrap_or(2.0 * least);
        if clip.is_finite() && clip > least {
            return Ok(Self { curve, clip });
        }
        Err(ModelError::Clip { least, value: clip })
    }

    /// The curve.
    pub fn curve(&self) -> &PlaneCurve {
        &self.curve
    }

    /// The clip, a ratio.
    pub fn clip(&self) -> f64 {
        self.clip
    }
}
