//! How far a taper or a twist goes along its axis.

mod knots;
mod line;
mod polyline;
mod spline;

use std::sync::Arc;

use crate::math::{Interval, Univariate};

pub use line::Line;
pub use polyline::Polyline;
pub use spline::Spline;

/// A function of the position z along an axis: a taper's factor, a twist's angle in radians.
#[derive(Debug, Clone)]
pub enum Profile {
    /// A straight line.
    Line(Line),
    /// Straight pieces.
    Polyline(Polyline),
    /// Smooth pieces.
    Spline(Spline),
    /// Any other function.
    Function(Arc<dyn Univariate>),
}

impl Profile {
    fn function(&self) -> &dyn Univariate {
        match self {
            Self::Line(line) => line,
            Self::Polyline(polyline) => polyline,
            Self::Spline(spline) => spline,
            Self::Function(function) => function.as_ref(),
        }
    }
}

impl Profile {
    /// The positions at which the function or one of its derivatives jumps, if its form is known.
    pub(super) fn creases(&self) -> Vec<f64> {
        let knots = match self {
            Self::Line(_) | Self::Function(_) => &[],
            Self::Polyline(polyline) => polyline.knots(),
            Self::Spline(spline) => spline.knots(),
        };
        knots.iter().map(|[z, _]| *z).collect()
    }
}

/// Functions of no known form are equal if they are the same object.
impl PartialEq for Profile {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Line(a), Self::Line(b)) => a == b,
            (Self::Polyline(a), Self::Polyline(b)) => a == b,
            (Self::Spline(a), Self::Spline(b)) => a == b,
            (Self::Function(a), Self::Function(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }
}

impl Univariate for Profile {
    fn value(&self, z: f64) -> f64 {
        self.function().value(z)
    }

    fn slope(&self, z: f64) -> f64 {
        self.function().slope(z)
    }

    fn value_range(&self, z: Interval) -> Interval {
        self.function().value_range(z)
    }

    fn slope_range(&self, z: Interval) -> Interval {
        self.function().slope_range(z)
    }
}

impl From<Line> for Profile {
    fn from(line: Line) -> Self {
        Self::Line(line)
    }
}

impl From<Polyline> for Profile {
    fn from(polyline: Polyline) -> Self {
        Self::Polyline(polyline)
    }
}

impl From<Spline> for Profile {
    fn from(spline: Spline) -> Self {
        Self::Spline(spline)
    }
}

#[cfg(test)]
mod tests;
