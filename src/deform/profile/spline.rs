//! A smooth profile through knots.

use super::knots::{Knots, Piece};
use crate::deform::error::DeformError;
use crate::math::{Interval, Univariate};

/// Cubic pieces between knots with a continuous slope, monotone wherever the knots are, and
/// constant beyond the first and the last (Fritsch and Carlson 1980; slopes by Fritsch and
/// Butland's harmonic mean, 0 at the ends).
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    knots: Knots,
    slopes: Vec<f64>,
}

impl Spline {
    /// The profile through pairs `[z, value]`.
    ///
    /// # Errors
    /// If there are none, one is not finite, or the positions do not ascend.
    pub fn new(knots: Vec<[f64; 2]>) -> Result<Self, DeformError> {
        let knots = Knots::new(knots)?;
        let last = knots.pairs().len() - 1;
        let slope = |i: usize| {
            let is_end = i == 0 || i == last;
            if is_end { 0.0 } else { harmonic_slope(knots.piece(i - 1), knots.piece(i)) }
        };
        let slopes = (0..=last).map(slope).collect();
        Ok(Self { knots, slopes })
    }

    /// The pairs `[z, value]`.
    pub fn knots(&self) -> &[[f64; 2]] {
        self.knots.pairs()
    }

    /// The slope at a share of a piece: a parabola.
    fn slope_at(&self, index: usize, share: f64) -> f64 {
        let chord = self.knots.piece(index).chord();
        let [from, to] = [self.slopes[index], self.slopes[index + 1]];
        let rest = 1.0 - share;
        from * rest * rest + to * share * share + 2.0 * (3.0 * chord - from - to) * share * rest
    }

    /// The slopes of a whole piece: at its ends and at the parabola's apex.
    fn slopes_of(&self, index: usize) -> Interval {
        let chord = self.knots.piece(index).chord();
        let [from, to] = [self.slopes[index], self.slopes[index + 1]];
        let apex = (3.0 * chord - 2.0 * from - to) / (6.0 * chord - 3.0 * (from + to));
        let at_apex = if (0.0..=1.0).contains(&apex) { self.slope_at(index, apex) } else { from };
        Interval::hull_of([from, to, at_apex]).widened(8.0 * f64::EPSILON * chord.abs())
    }
}

/// The slope at a knot: the weighted harmonic mean of the chords of both sides, 0 at a turn.
fn harmonic_slope(before: Piece, after: Piece) -> f64 {
    let [below, above] = [before.chord(), after.chord()];
    if below * above <= 0.0 {
        return 0.0;
    }
    let weight = (before.length + 2.0 * after.length) / (3.0 * (before.length + after.length));
    below * above / (weight * above + (1.0 - weight) * below)
}

impl Univariate for Spline {
    fn value(&self, z: f64) -> f64 {
        self.knots.value(z, |index| {
            let piece = self.knots.piece(index);
            let t = piece.share(z);
            let rest = 1.0 - t;
            let [from, to] = [self.slopes[index], self.slopes[index + 1]];
            let blend = t * t * (3.0 - 2.0 * t);
            piece.from
                + blend * (piece.to - piece.from)
                + piece.length * t * rest * (rest * from - t * to)
        })
    }

    fn slope(&self, z: f64) -> f64 {
        self.knots.slope(z, |index| self.slope_at(index, self.knots.piece(index).share(z)))
    }

    fn value_range(&self, z: Interval) -> Interval {
        self.knots.value_range(z, |z| self.value(z))
    }

    fn slope_range(&self, z: Interval) -> Interval {
        self.knots.slope_range(z, |index| self.slopes_of(index))
    }
}
