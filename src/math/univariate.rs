//! Functions of one variable that can say what they do over an interval.

use std::fmt::Debug;

use super::Interval;

/// A function of one variable with its slope, and enclosures of both.
///
/// It is continuous; where its slope jumps, the enclosure of slopes over a range holds those of
/// both sides.
pub trait Univariate: Debug + Send + Sync {
    /// The function at `t`.
    fn value(&self, t: f64) -> f64;

    /// Its slope at `t`; at a jump, that of the side of greater `t`.
    fn slope(&self, t: f64) -> f64;

    /// An interval that holds the function's values over a range.
    fn value_range(&self, range: Interval) -> Interval;

    /// An interval that holds its slopes over a range.
    fn slope_range(&self, range: Interval) -> Interval;
}
