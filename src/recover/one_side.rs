//! Mixtures of strays and a surface of which one side was seen.

use super::alternation::{MixtureFit, Schedule, alternate};
use super::descent::PointSet;
use super::evidence::Side;
use super::subset::Subset;

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

    /// Settles a fit anew, as one of what was seen from the side that its own surface faces. `odds` are
    /// what neighbours say of each point.
    pub fn settled(
        points: &PointSet,
        odds: &[f64],
        fit: MixtureFit,
        schedule: Schedule,
    ) -> Option<Self> {
        let surface = Subset::of(points.points, &fit.surface());
        let surface = PointSet { points: surface.columns(), ..*points };
        let Some(side) = Side::of(&surface, &fit.descent.model) else {
            return Some(Self::unknown(fit));
        };
        let mut both = odds_of(&side, points, &fit);
        both.iter_mut().zip(odds).for_each(|(both, odds)| *both *= odds);
        let fit = alternate(points, Some(&both), &fit.descent.model, fit.mixture, schedule)?;
        Some(Self { fit, side: Some(side) })
    }

    /// The fit that makes the points more likely.
    pub fn more_likely(self, other: Self) -> Self {
        if other.fit.log_likelihood > self.fit.log_likelihood { other } else { self }
    }

    /// What the side says of each point; none where it is not known.
    pub fn odds(&self, points: &PointSet) -> Option<Vec<f64>> {
        self.side.map(|side| odds_of(&side, points, &self.fit))
    }
}

fn odds_of(side: &Side, points: &PointSet, fit: &MixtureFit) -> Vec<f64> {
    side.odds(points, &fit.descent.model, fit.mixture.variance.sqrt())
}
