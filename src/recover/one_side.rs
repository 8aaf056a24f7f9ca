//! Mixtures of strays and a surface of which one side was seen.

use super::alternation::{MixtureFit, Schedule, alternate};
use super::descent::PointSet;
use super::evidence::Side;
use super::subset::Subset;
use crate::model::Model;

/// A fit, and the side that its surface was seen from, if the points face one.
pub(crate) struct Sided {
    pub fit: MixtureFit,
    pub side: Option<Side>,
}

impl Sided {
    /// A fit whose side does not matter.
    pub fn unknown(fit: MixtureFit) -> Self {
        Self { fit, side: None }
    }

    /// Settles a fit anew from a model, as one of what was seen from the side that its surface faces
    /// around that model. `odds` are what neighbours say of each point.
    pub fn settled(
        points: &PointSet,
        odds: &[f64],
        fit: &MixtureFit,
        start: &Model,
        schedule: Schedule,
    ) -> Option<Self> {
        let surface = Subset::of(points.points, &fit.surface());
        let surface = PointSet { points: surface.columns(), ..*points };
        let Some(side) = Side::of(&surface, start) else {
            return Some(Self::unknown(fit.clone()));
        };
        let deviation = fit.mixture.variance.sqrt();
        let both = multiplied(side.odds(points, start, deviation), odds);
        let fit = alternate(points, Some(&both), start, fit.mixture, schedule)?;
        Some(Self { fit, side: Some(side) })
    }

    /// Settles the same mixture anew from another model, the odds being those around this one's. None
    /// where no side is known.
    pub fn resettled(
        &self,
        points: &PointSet,
        odds: &[f64],
        start: &Model,
        schedule: Schedule,
    ) -> Option<Self> {
        let both = multiplied(self.odds(points)?, odds);
        let fit = alternate(points, Some(&both), start, self.fit.mixture, schedule)?;
        Some(Self { fit, ..*self })
    }

    /// The fit that makes the points more likely.
    pub fn more_likely(self, other: Self) -> Self {
        if other.fit.log_likelihood > self.fit.log_likelihood { other } else { self }
    }

    /// What the side says of each point; none where it is not known.
    pub fn odds(&self, points: &PointSet) -> Option<Vec<f64>> {
        let MixtureFit { descent, mixture, .. } = &self.fit;
        self.side.map(|side| side.odds(points, &descent.model, mixture.variance.sqrt()))
    }
}

fn multiplied(mut odds: Vec<f64>, others: &[f64]) -> Vec<f64> {
    odds.iter_mut().zip(others).for_each(|(odds, other)| *odds *= other);
    odds
}
