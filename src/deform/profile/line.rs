//! A straight profile.

use crate::deform::error::{DeformError, finite};
use crate::math::{Interval, Univariate};

/// `f(z) = at_zero + slope z`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    at_zero: f64,
    slope: f64,
}

impl Line {
    /// The line of a value at `z = 0` and a slope.
    ///
    /// # Errors
    /// If one of them is not finite.
    pub fn new(at_zero: f64, slope: f64) -> Result<Self, DeformError> {
        finite("a profile's value at zero", at_zero)?;
        finite("a profile's slope", slope)?;
        Ok(Self { at_zero, slope })
    }

    /// The value at `z = 0`.
    pub fn at_zero(&self) -> f64 {
        self.at_zero
    }
}

impl Univariate for Line {
    fn value(&self, z: f64) -> f64 {
        self.at_zero + self.slope * z
    }

    fn slope(&self, _: f64) -> f64 {
        self.slope
    }

    fn value_range(&self, z: Interval) -> Interval {
        z * self.slope + self.at_zero
    }

    fn slope_range(&self, _: Interval) -> Interval {
        Interval::point(self.slope)
    }
}
