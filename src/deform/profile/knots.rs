//! Knots: the pairs of position and value that a profile passes through.

use crate::deform::error::DeformError;
use crate::math::Interval;

/// Rounding of an interpolated value, relative to the greatest at the knots.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Pairs `[z, value]`, z ascending.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Knots {
    pairs: Vec<[f64; 2]>,
    /// What to widen enclosures of values by.
    slack: f64,
}

impl Knots {
    /// Knots that are finite and ascend.
    pub fn new(pairs: Vec<[f64; 2]>) -> Result<Self, DeformError> {
        let is_finite = pairs.iter().flatten().all(|number| number.is_finite());
        let ascends = pairs.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        if pairs.is_empty() || !is_finite || !ascends {
            return Err(DeformError::Knots);
        }
        let greatest = pairs.iter().fold(0.0, |most: f64, [_, value]| most.max(value.abs()));
        Ok(Self { pairs, slack: ROUNDING * greatest })
    }

    /// All pairs.
    pub fn pairs(&self) -> &[[f64; 2]] {
        &self.pairs
    }

    /// The number of knots at or below z: 0 below the first, all of them above the last.
    pub fn count_up_to(&self, z: f64) -> usize {
        self.pairs.partition_point(|[knot, _]| *knot <= z)
    }

    /// The value beyond the ends, or `inside` of the piece that begins at a knot.
    pub fn value(&self, z: f64, inside: impl FnOnce(usize) -> f64) -> f64 {
        match self.count_up_to(z) {
            0 => self.pairs[0][1],
            count if count == self.pairs.len() => self.pairs[count - 1][1],
            count => inside(count - 1),
        }
    }

    /// The slope 0 beyond the ends, or `inside` of the piece that begins at a knot.
    pub fn slope(&self, z: f64, inside: impl FnOnce(usize) -> f64) -> f64 {
        match self.count_up_to(z) {
            0 => 0.0,
            count if count == self.pairs.len() => 0.0,
            count => inside(count - 1),
        }
    }

    /// The values over a range of a function that is monotone between knots.
    pub fn value_range(&self, z: Interval, value: impl Fn(f64) -> f64) -> Interval {
        let ends = [value(z.lo()), value(z.hi())].into_iter();
        let within = self.pairs.iter().filter(|[knot, _]| z.contains(*knot));
        Interval::hull_of(ends.chain(within.map(|[_, value]| *value))).widened(self.slack)
    }

    /// The slopes over a range: those of the pieces it touches, and 0 where it goes beyond.
    pub fn slope_range(&self, z: Interval, of_piece: impl Fn(usize) -> Interval) -> Interval {
        let last = self.pairs.len() - 1;
        let first = self.count_up_to(z.lo().next_down());
        let pieces = first.saturating_sub(1)..self.count_up_to(z.hi()).min(last);
        let is_beyond = z.lo() <= self.pairs[0][0] || z.hi() >= self.pairs[last][0];
        let beyond = is_beyond.then_some(Interval::ZERO);
        pieces.map(of_piece).chain(beyond).reduce(Interval::hull).unwrap_or(Interval::ZERO)
    }

    /// Where a piece begins, how long it is, and its two values.
    pub fn piece(&self, index: usize) -> Piece {
        let [[start, from], [end, to]] = [self.pairs[index], self.pairs[index + 1]];
        Piece { start, length: end - start, from, to }
    }
}

/// The stretch between two knots.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub start: f64,
    pub length: f64,
    pub from: f64,
    pub to: f64,
}

impl Piece {
    /// The mean slope.
    pub fn chord(&self) -> f64 {
        (self.to - self.from) / self.length
    }

    /// How far along the piece z is, from 0 to 1.
    pub fn share(&self, z: f64) -> f64 {
        (z - self.start) / self.length
    }
}
