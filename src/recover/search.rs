//! The search for the right minimum: brief descents on few points from several starts, then
//! switches from the best of them, then the best few on more points.

use super::descent::{Descent, Effort, PointSet, descend};
use super::normalization::Moments;
use super::start::{ambiguous_starts, principal_starts};
use super::switches::switches;
use crate::model::Model;

/// A switch must lower the mean square by this share to be taken.
const WORTHWHILE: f64 = 0.99;

/// Rounds of switches: as many as axis and dual can both be wrong.
const SWITCH_ROUNDS: usize = 4;

/// Models taken on to more points.
const FINALISTS: usize = 3;

/// A model whose mean square is this many times the best one's is not taken on.
const HOPELESS: f64 = 4.0;

/// A brief descent: it must tell minima apart, not find them exactly.
const BRIEF: Effort = Effort { tolerance: 1e-3, patience: 2, step_bound: 0.5 };

/// Bookkeeping of a search: every descent, best first, and what they cost.
#[derive(Debug, Default)]
pub(crate) struct Search {
    candidates: Vec<Descent>,
    /// Models that a descent started from.
    pub starts: usize,
    /// Passes over point sets of any size.
    pub passes: usize,
}

impl Search {
    /// Descends from the principal axes, from the frames between them, and by switches.
    pub fn coarse(points: &PointSet, moments: &Moments) -> Self {
        let mut search = Self::default();
        search.try_all(points, &principal_starts(moments), &BRIEF);
        search.try_switches(points);
        let further = ambiguous_starts(moments);
        if !further.is_empty() {
            search.try_all(points, &further, &BRIEF);
            search.try_switches(points);
        }
        search
    }

    /// Takes the best few on to other points: only these are kept.
    pub fn refine(&mut self, points: &PointSet, effort: &Effort) {
        let candidates = std::mem::take(&mut self.candidates);
        let least = candidates.first().map_or(0.0, |best| best.geometric_mean_square);
        let finalists: Vec<Model> = candidates
            .iter()
            .take(FINALISTS)
            .filter(|candidate| candidate.geometric_mean_square <= HOPELESS * least)
            .map(|candidate| candidate.model)
            .collect();
        for model in &finalists {
            self.descend(points, model, effort);
        }
    }

    /// The descent of least mean square.
    pub fn into_best(self) -> Option<Descent> {
        self.candidates.into_iter().next()
    }

    /// Switches from the best descent, as long as one of them is worth while.
    fn try_switches(&mut self, points: &PointSet) {
        for _ in 0..SWITCH_ROUNDS {
            let Some(best) = self.candidates.first().cloned() else { return };
            self.try_all(points, &switches(&best.model), &BRIEF);
            if self.candidates[0].geometric_mean_square >= WORTHWHILE * best.geometric_mean_square {
                return;
            }
        }
    }

    fn try_all(&mut self, points: &PointSet, starts: &[Model], effort: &Effort) {
        for start in starts {
            self.starts += 1;
            self.descend(points, start, effort);
        }
    }

    fn descend(&mut self, points: &PointSet, start: &Model, effort: &Effort) {
        if let Some(descent) = descend(points, start, effort) {
            self.passes += descent.passes;
            let place = self.candidates.partition_point(|other| {
                other.geometric_mean_square <= descent.geometric_mean_square
            });
            self.candidates.insert(place, descent);
        }
    }
}
