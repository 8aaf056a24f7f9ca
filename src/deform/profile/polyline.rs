//! A piecewise linear profile.

use super::knots::Knots;
use crate::deform::error::DeformError;
use crate::math::{Interval, Univariate};

/// Straight pieces between knots, constant beyond the first and the last.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyline {
    knots: Knots,
}

impl Polyline {
    /// The profile through pairs `[z, value]`.
    ///
    /// # Errors
    /// If there are none, one is not finite, or the positions do not ascend.
    pub fn new(knots: Vec<[f64; 2]>) -> Result<Self, DeformError> {
        Ok(Self { knots: Knots::new(knots)? })
    }

    /// The pairs `[z, value]`.
    pub fn knots(&self) -> &[[f64; 2]] {
        self.knots.pairs()
    }
}

impl Univariate for Polyline {
    fn value(&self, z: f64) -> f64 {
        self.knots.value(z, |index| {
            let piece = self.knots.piece(index);
            piece.from + piece.share(z) * (piece.to - piece.from)
        })
    }

    fn slope(&self, z: f64) -> f64 {
        self.knots.slope(z, |index| self.knots.piece(index).chord())
    }

    fn value_range(&self, z: Interval) -> Interval {
        self.knots.value_range(z, |z| self.value(z))
    }

    fn slope_range(&self, z: Interval) -> Interval {
        self.knots.slope_range(z, |index| Interval::point(self.knots.piece(index).chord()))
    }
}
