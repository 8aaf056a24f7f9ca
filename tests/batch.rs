//! Evaluation of a suite, by the program as a user runs it.

mod common;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use common::Scene;
use serde_json::{Value, json};
use superquadric::report::ModelDocument;
use tempfile::TempDir;

/// Writes a suite of six good scenes on two levels, one without a cloud, and one whose truth is
/// not a model.
fn write_suite(folder: &Path) {
    let mut scenes = Vec::new();
    for (level, noise) in [("clean", 0.0), ("noisy", 0.02)] {
        for index in 0..3 {
            let name = format!("{level}-{index}");
            let mut scene = Scene::new(index);
            let truth = scene.random_model();
            let points = scene.cloud(&truth, 500, noise);
            let rows: String = points.iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();
            let header = format!(
                "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double \
                 y\nproperty double z\nend_header\n",
                points.len()
            );
            let truth = json!({"level": level, "model": ModelDocument::from(&truth)});
            write_scene(folder, &name, Some(&(header + &rows)), &truth.to_string());
            scenes.push(json!({"name": name, "level": level, "family": "any"}));
        }
    }
    write_scene(folder, "lost", None, "{}");
    write_scene(folder, "void", Some("ply\n"), "{\"model\": {}}");
    for name in ["lost", "void"] {
        scenes.push(json!({"name": name, "level": "broken", "family": "any"}));
    }
    let suite = json!({"name": "test", "levels": ["clean", "noisy", "broken"], "scenes": scenes});
    fs::write(folder.join("suite.json"), suite.to_string()).unwrap();
}

fn write_scene(folder: &Path, name: &str, cloud: Option<&str>, truth: &str) {
    let folder = folder.join("scenes").join(name);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("truth.json"), truth).unwrap();
    if let Some(cloud) = cloud {
        fs::write(folder.join("cloud.ply"), cloud).unwrap();
    }
}

fn batch(suite: &Path, results: &Path, options: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_superquadric"))
        .arg("batch")
        .arg(suite)
        .arg("-o")
        .arg(results)
        .args(options)
        .output()
        .expect("the program starts")
}

fn rows(results: &Path) -> Vec<csv::StringRecord> {
    let mut table = csv::Reader::from_path(results.join("scenes.csv")).unwrap();
    table.records().map(Result::unwrap).collect()
}

#[test]
fn a_suite_is_scored_and_failures_are_rows() {
    let [suite, results] = [TempDir::new().unwrap(), TempDir::new().unwrap()];
    write_suite(suite.path());
    let output = batch(suite.path(), results.path(), &[]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), message.as_str()), (Some(0), ""));
    let table = String::from_utf8(output.stdout).unwrap();
    assert_eq!(table.lines().count(), 4, "{table}");

    let rows = rows(results.path());
    assert_eq!(rows.len(), 8);
    for row in &rows[..6] {
        let iou: f64 = row[4].parse().unwrap();
        assert!(&row[3] == "fitted" && iou > 0.95, "{row:?}");
    }
    for (row, named) in rows[6..].iter().zip(["truth.json", "truth.json"]) {
        assert!(&row[3] == "failed" && row[17].contains(named), "{row:?}");
    }

    let summary = fs::read_to_string(results.path().join("summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(summary["levels"][0]["success"], 1.0);
    assert_eq!(summary["levels"][2]["failed"], 2);
    assert_eq!(summary["levels"][2]["iou"], Value::Null);
}

#[test]
fn a_second_run_does_not_do_finished_scenes_again_and_ends_with_the_same_bytes() {
    let [suite, results] = [TempDir::new().unwrap(), TempDir::new().unwrap()];
    write_suite(suite.path());
    assert!(batch(suite.path(), results.path(), &["--threads", "2"]).status.success());
    let tables =
        || ["scenes.csv", "summary.json"].map(|name| fs::read(results.path().join(name)).unwrap());
    let first = tables();
    // Were the scenes done again, they would fail now.
    fs::remove_dir_all(suite.path().join("scenes")).unwrap();
    assert!(batch(suite.path(), results.path(), &["--threads", "1"]).status.success());
    assert_eq!(tables(), first);
}

#[test]
fn results_of_other_options_are_not_mixed() {
    let [suite, results] = [TempDir::new().unwrap(), TempDir::new().unwrap()];
    write_suite(suite.path());
    assert!(batch(suite.path(), results.path(), &[]).status.success());
    let output = batch(suite.path(), results.path(), &["--seed", "1"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("seed 0") && message.contains("seed 1"), "{message}");
}

#[test]
fn a_suite_that_is_none_is_refused() {
    let [suite, results] = [TempDir::new().unwrap(), TempDir::new().unwrap()];
    for (document, named) in [
        (None, "suite.json"),
        (Some("[]".to_owned()), "expected a suite"),
        (
            Some(
                json!({
                    "name": "x", "levels": [],
                    "scenes": [{"name": "../out", "level": "a", "family": "b"}]
                })
                .to_string(),
            ),
            "../out",
        ),
    ] {
        if let Some(document) = document {
            fs::write(suite.path().join("suite.json"), document).unwrap();
        }
        let output = batch(suite.path(), results.path(), &[]);
        assert_eq!(output.status.code(), Some(2));
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(message.contains(named), "{message}");
    }
}
