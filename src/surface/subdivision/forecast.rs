//! How many triangles a tolerance needs, from those that coarser ones have taken.

use crate::surface::tolerance::{MOST_TRIANGLES, TooMany};

/// Each tolerance on the way over the next.
const STEP: f64 = 4.0;

/// The first tolerance, as a share of the surface's extent.
const FIRST_SHARE: f64 = 0.05;

/// From so many triangles on their number tells how many more are needed.
const TELLING: usize = 2000;

/// By what share of itself the number may be wrong, for each step that it looks ahead.
const UNCERTAINTY: f64 = 0.25;

/// A sequence of falling tolerances, and the numbers of triangles that they have taken.
#[derive(Debug)]
pub(super) struct Forecast {
    finest: f64,
    next: Option<f64>,
    reached: Option<usize>,
    stages_left: f64,
    growth: f64,
}

impl Forecast {
    /// Of the way from a share of the extent to a finest tolerance.
    pub fn new(finest: f64, extent: f64) -> Self {
        let first = (FIRST_SHARE * extent).max(finest);
        Self { finest, next: Some(first), reached: None, stages_left: 0.0, growth: STEP }
    }

    /// The next tolerance, if the finest has not been reached.
    pub fn next_tolerance(&mut self) -> Option<f64> {
        let tolerance = self.next?;
        let is_last = tolerance <= self.finest;
        self.stages_left = (tolerance / self.finest).log(STEP);
        self.next = (!is_last).then(|| (tolerance / STEP).max(self.finest));
        Some(tolerance)
    }

    /// Takes in how many triangles the tolerance has taken.
    ///
    /// # Errors
    /// If the finest one needs too many.
    pub fn reached(&mut self, triangles: usize) -> Result<(), TooMany> {
        if let Some(before) = self.reached.replace(triangles) {
            // Where a surface is smooth or bends across triangles, the number rises with the
            // inverse of the tolerance; along edges that triangles follow it rises less.
            self.growth = (triangles as f64 / before as f64).min(STEP);
            let wanted = self.triangles(triangles);
            let most = MOST_TRIANGLES as f64 * (1.0 + UNCERTAINTY * self.stages_left);
            if triangles > TELLING && wanted > most {
                return Err(TooMany(wanted));
            }
        }
        Ok(())
    }

    /// About how many triangles the finest tolerance takes, if this one takes so many.
    pub fn triangles(&self, taken: usize) -> f64 {
        taken as f64 * self.growth.powf(self.stages_left)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a finest tolerance is refused when every step takes so many times the triangles of
    /// the last.
    fn is_refused(finest: f64, growth: f64) -> bool {
        let mut forecast = Forecast::new(finest, 1.0);
        let mut triangles = 100.0;
        while forecast.next_tolerance().is_some() {
            if forecast.reached(triangles as usize).is_err() {
                return true;
            }
            triangles *= growth;
        }
        false
    }

    #[test]
    fn tolerances_fall_to_the_finest() {
        for finest in [1e-3, 0.04, 1.0, 0.05 / 16.0] {
            let mut forecast = Forecast::new(finest, 1.0);
            let stages: Vec<f64> = std::iter::from_fn(|| forecast.next_tolerance()).collect();
            assert_eq!(stages.last(), Some(&finest));
            assert!(stages.windows(2).all(|pair| pair[1] < pair[0] && pair[1] >= pair[0] / STEP));
        }
    }

    #[test]
    fn what_grows_with_the_inverse_of_the_tolerance_is_refused_early_and_flats_are_not() {
        assert!(is_refused(1e-12, STEP));
        assert!(!is_refused(1e-5, STEP));
        assert!(!is_refused(1e-12, 1.0));
        assert!(is_refused(1e-12, 2.5));
    }
}
