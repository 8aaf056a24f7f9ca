//! The folder of the results: a document a scene, then the tables.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::error::BatchError;
use super::record::Record;
use super::suite::{SceneEntry, Suite};
use super::summary::Summary;
use crate::output::write_whole;
use crate::recover::FitOptions;

/// Results being gathered.
pub(super) struct Results {
    folder: PathBuf,
}

impl Results {
    /// Makes the folder, or goes on in one that holds results of the same suite and options.
    pub fn open(folder: &Path, suite: &Suite, options: &FitOptions) -> Result<Self, BatchError> {
        let results = Self { folder: folder.to_path_buf() };
        let scenes = results.folder.join("scenes");
        fs::create_dir_all(&scenes).map_err(|source| BatchError::Io { path: scenes, source })?;
        results.require_same(&label(suite, options))?;
        Ok(results)
    }

    /// What an earlier run has kept of a scene.
    pub fn finished(&self, scene: &SceneEntry) -> Result<Option<Record>, BatchError> {
        let path = self.scene_path(&scene.name);
        let Some(text) = read_if_there(&path)? else { return Ok(None) };
        let record = serde_json::from_str(&text).map_err(|source| BatchError::Document {
            path,
            expected: "the record of a scene",
            source,
        })?;
        Ok(Some(record))
    }

    /// Keeps a scene's record.
    pub fn keep(&self, record: &Record) -> Result<(), BatchError> {
        write_json(&self.scene_path(&record.scene), record)
    }

    /// Writes the table of all scenes and the summary.
    pub fn write_tables(&self, records: &[Record], summary: &Summary) -> Result<(), BatchError> {
        let path = self.folder.join("scenes.csv");
        write_whole(&path, |writer| {
            let mut table = csv::Writer::from_writer(writer);
            table.write_record(HEADER).map_err(io::Error::from)?;
            for record in records {
                table.write_record(row(record)).map_err(io::Error::from)?;
            }
            table.flush()
        })?;
        write_json(&self.folder.join("summary.json"), summary)
    }

    /// Labels a fresh folder, or compares its label.
    fn require_same(&self, expected: &str) -> Result<(), BatchError> {
        let path = self.folder.join("batch.txt");
        match read_if_there(&path)? {
            None => Ok(write_whole(&path, |writer| writeln!(writer, "{expected}"))?),
            Some(found) if found.trim_end() == expected => Ok(()),
            Some(found) => Err(BatchError::OtherResults {
                path: self.folder.clone(),
                found: found.trim_end().to_owned(),
                expected: expected.to_owned(),
            }),
        }
    }

    fn scene_path(&self, name: &str) -> PathBuf {
        self.folder.join("scenes").join(format!("{name}.json"))
    }
}

/// What the results depend on.
fn label(suite: &Suite, options: &FitOptions) -> String {
    format!(
        "suite {} of {} scenes, superquadric {}, seed {}, distance {:?}, {} precision",
        suite.name,
        suite.scenes.len(),
        env!("CARGO_PKG_VERSION"),
        options.seed,
        options.distance,
        options.precision.name(),
    )
}

const HEADER: [&str; 18] = [
    "scene",
    "level",
    "family",
    "status",
    "iou",
    "iou_standard_error",
    "surface_distance",
    "size_error",
    "rotation_error",
    "trusted",
    "rms_radial",
    "rms_geometric",
    "points",
    "points_skipped",
    "evaluations",
    "starts",
    "seconds",
    "error",
];

/// A scene's row; what a failed scene has not is empty.
fn row(record: &Record) -> Vec<String> {
    let mut row = vec![record.scene.clone(), record.level.clone(), record.family.clone()];
    match &record.outcome {
        super::Outcome::Fitted(score) => {
            row.push("fitted".to_owned());
            row.extend([
                score.iou.to_string(),
                score.iou_standard_error.to_string(),
                score.surface_distance.to_string(),
                score.size_error.to_string(),
                score.rotation_error.to_string(),
                score.trusted.to_string(),
                score.rms_radial.to_string(),
                score.rms_geometric.to_string(),
                score.points.to_string(),
                score.points_skipped.to_string(),
                score.evaluations.to_string(),
                score.starts.to_string(),
                score.seconds.to_string(),
                String::new(),
            ]);
        }
        super::Outcome::Failed { error } => {
            row.push("failed".to_owned());
            row.resize(HEADER.len() - 1, String::new());
            row.push(error.clone());
        }
    }
    row
}

fn write_json(path: &Path, document: &impl Serialize) -> Result<(), BatchError> {
    Ok(write_whole(path, |writer| {
        serde_json::to_writer_pretty(&mut *writer, document)?;
        writeln!(writer)
    })?)
}

fn read_if_there(path: &Path) -> Result<Option<String>, BatchError> {
    match fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(source) => Err(BatchError::Io { path: path.to_path_buf(), source }),
    }
}
