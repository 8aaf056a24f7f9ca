//! A suite's results by level.

use std::fmt::Write;

use serde::Serialize;

use super::record::{Record, Score};

/// Overlap from which on a shape counts as recovered.
pub const SUCCESS_IOU: f64 = 0.9;

/// Results of a suite.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Summary {
    /// Name of the suite.
    pub suite: String,
    /// One entry a level, in the suite's order.
    pub levels: Vec<LevelSummary>,
}

/// Results of a level.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LevelSummary {
    /// Name of the level.
    pub level: String,
    /// Scenes of the level.
    pub scenes: usize,
    /// Scenes for which no model was found.
    pub failed: usize,
    /// Share of all scenes recovered with an overlap of at least 0.9.
    pub success: f64,
    /// Share of all scenes whose fit was trusted.
    pub trusted: f64,
    /// Scenes whose fit was trusted, but not recovered.
    pub wrongly_trusted: usize,
    /// Intersection over union.
    pub iou: Quartiles,
    /// Symmetric mean surface distance over the mean semi-axis.
    pub surface_distance: Quartiles,
    /// Greatest relative error of a semi-axis.
    pub size_error: Quartiles,
    /// Rotation error in radians.
    pub rotation_error: Quartiles,
    /// Time of a fit.
    pub seconds: Quartiles,
}

/// Least, quartiles and greatest of the scenes that were fitted; null if there are none.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Quartiles(pub Option<[f64; 5]>);

impl Quartiles {
    fn of(scores: &[&Score], value: impl Fn(&Score) -> f64) -> Self {
        let mut values: Vec<f64> = scores.iter().map(|score| value(score)).collect();
        values.sort_by(f64::total_cmp);
        let last = values.len().saturating_sub(1) as f64;
        let at = |share: f64| {
            let place = share * last;
            let (below, above) = (values[place.floor() as usize], values[place.ceil() as usize]);
            below + (above - below) * place.fract()
        };
        Self((!values.is_empty()).then(|| [0.0, 0.25, 0.5, 0.75, 1.0].map(at)))
    }

    /// The middle one.
    pub fn median(&self) -> Option<f64> {
        self.0.map(|values| values[2])
    }
}

impl Summary {
    pub(super) fn of(suite: &str, levels: &[String], records: &[Record]) -> Self {
        let levels = levels.iter().map(|level| LevelSummary::of(level, records)).collect();
        Self { suite: suite.to_owned(), levels }
    }
}

impl LevelSummary {
    fn of(level: &str, records: &[Record]) -> Self {
        let records: Vec<&Record> = records.iter().filter(|record| record.level == level).collect();
        let scores: Vec<&Score> =
            records.iter().filter_map(|record| record.outcome.score()).collect();
        let count =
            |test: &dyn Fn(&Score) -> bool| scores.iter().filter(|score| test(score)).count();
        let share = |count: usize| count as f64 / records.len().max(1) as f64;
        Self {
            level: level.to_owned(),
            scenes: records.len(),
            failed: records.len() - scores.len(),
            success: share(count(&|score| score.iou >= SUCCESS_IOU)),
            trusted: share(count(&|score| score.trusted)),
            wrongly_trusted: count(&|score| score.trusted && score.iou < SUCCESS_IOU),
            iou: Quartiles::of(&scores, |score| score.iou),
            surface_distance: Quartiles::of(&scores, |score| score.surface_distance),
            size_error: Quartiles::of(&scores, |score| score.size_error),
            rotation_error: Quartiles::of(&scores, |score| score.rotation_error),
            seconds: Quartiles::of(&scores, |score| score.seconds),
        }
    }
}

/// The summary for a person.
pub fn summary_table(summary: &Summary) -> String {
    let mut table = format!(
        "{:<20} {:>6} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>8}\n",
        summary.suite,
        "scenes",
        "failed",
        "success",
        "trusted",
        "wrongly",
        "IoU",
        "IoU 1/4",
        "surface",
        "ms"
    );
    for level in &summary.levels {
        let [_, quarter, half, ..] = level.iou.0.unwrap_or([f64::NAN; 5]);
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "{:<20} {:>6} {:>6} {:>6.1} % {:>6.1} % {:>8} {:>8.4} {:>8.4} {:>7.2} % {:>8.2}",
            level.level,
            level.scenes,
            level.failed,
            100.0 * level.success,
            100.0 * level.trusted,
            level.wrongly_trusted,
            half,
            quarter,
            100.0 * level.surface_distance.median().unwrap_or(f64::NAN),
            1e3 * level.seconds.median().unwrap_or(f64::NAN),
        );
    }
    table
}

#[cfg(test)]
mod tests {
    use super::super::record::Outcome;
    use super::*;
    use crate::model::Model;
    use crate::pose::Pose;
    use crate::report::ModelDocument;
    use crate::shape::Superellipsoid;

    fn record(level: &str, outcome: Outcome) -> Record {
        Record { scene: "s".into(), level: level.into(), family: "f".into(), outcome }
    }

    fn fitted(iou: f64, trusted: bool) -> Outcome {
        let shape = Superellipsoid::new([1.0, 2.0, 3.0], [0.1, 1.9]).unwrap();
        Outcome::Fitted(Box::new(Score {
            iou,
            iou_standard_error: 0.0,
            surface_distance: 1.0 - iou,
            size_error: 0.0,
            rotation_error: 0.0,
            trusted,
            rms_radial: 0.0,
            rms_geometric: 0.0,
            points: 1,
            points_skipped: 0,
            evaluations: 1,
            starts: 1,
            seconds: 0.5,
            model: ModelDocument::from(&Model { shape, pose: Pose::identity() }),
        }))
    }

    #[test]
    fn levels_are_summed_up_apart_and_failures_count_as_no_success() {
        let records = [
            record("a", fitted(1.0, true)),
            record("a", fitted(0.9, true)),
            record("a", fitted(0.8, true)),
            record("a", Outcome::Failed { error: "no points".into() }),
            record("b", fitted(0.5, false)),
        ];
        let levels = ["a", "b", "c"].map(str::to_owned);
        let summary = Summary::of("suite", &levels, &records);
        let [a, b, c] = &summary.levels[..] else { panic!("three levels") };
        assert_eq!((a.scenes, a.failed, a.success, a.trusted), (4, 1, 0.5, 0.75));
        assert_eq!(a.wrongly_trusted, 1);
        let expected = [0.8, 0.85, 0.9, 0.95, 1.0];
        assert!(a.iou.0.unwrap().iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15));
        assert_eq!((b.success, b.wrongly_trusted, b.iou.median()), (0.0, 0, Some(0.5)));
        assert_eq!((c.scenes, c.success, c.iou), (0, 0.0, Quartiles(None)));
        assert_eq!(summary_table(&summary).lines().count(), 4);
    }

    #[test]
    fn records_come_back_from_json() {
        for outcome in [fitted(0.5, true), Outcome::Failed { error: "no points".into() }] {
            let record = record("a", outcome);
            let text = serde_json::to_string(&record).unwrap();
            assert_eq!(serde_json::from_str::<Record>(&text).unwrap(), record);
        }
    }
}
