//! Deformed models in the program: their document, and what is told and meshed of them.

use std::process::Command;

use serde_json::Value;
use tempfile::TempDir;

const SCHEMA: &str = include_str!("../schema/model-1.schema.json");

/// A ribbon, tapered, twisted about its length and bent.
const RIBBON: &str = r#"{
    "shape": {"family": "superellipsoid", "size": [0.5, 2, 0.1], "exponents": [0.3, 0.4]},
    "deformations": [
        {"kind": "taper", "profile": {"form": "line", "at_zero": 1, "slope": -0.2},
         "axis": {"direction": [0, 1, 0]}},
        {"kind": "twist", "profile": {"form": "line", "at_zero": 0, "slope": 0.8},
         "axis": {"direction": [0, 1, 0]}},
        {"kind": "bend", "rate": 0.8, "center": 0, "range": [-1, 1]}
    ],
    "pose": {"euler_zyz": [0.3, 0.2, 0.1], "translation": [5, 0, 1]}
}"#;

/// Runs the program in a folder that holds the ribbon.
fn superquadric(folder: &TempDir, arguments: &[&str]) -> std::process::Output {
    std::fs::write(folder.path().join("ribbon.json"), RIBBON).expect("a file");
    let program = env!("CARGO_BIN_EXE_superquadric");
    Command::new(program).args(arguments).current_dir(folder).output().expect("the program")
}

fn folder() -> TempDir {
    TempDir::new().expect("a folder")
}

#[test]
fn info_tells_the_masses_and_a_box_that_holds_the_mesh() {
    let folder = folder();
    let output = superquadric(&folder, &["info", "ribbon.json", "--json"]);
    assert!(output.status.success());
    let info: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(info["deformations"].as_array().map(Vec::len), Some(3));
    assert!(info["mass_error"].as_f64().expect("a number") < 1e-3);
    let output = superquadric(&folder, &["mesh", "ribbon.json", "-o", "ribbon.obj"]);
    assert!(output.status.success());
    let mesh = std::fs::read_to_string(folder.path().join("ribbon.obj")).expect("a mesh");
    let corner = |end: usize| -> Vec<f64> {
        let ends = info["bounding_box"][end].as_array().expect("an array");
        ends.iter().map(|number| number.as_f64().expect("a number")).collect()
    };
    let (min, max) = (corner(0), corner(1));
    let mut vertices = 0;
    for line in mesh.lines().filter_map(|line| line.strip_prefix("v ")) {
        let x: Vec<f64> = line.split(' ').map(|n| n.parse().expect("a number")).collect();
        assert!((0..3).all(|i| min[i] <= x[i] && x[i] <= max[i]), "{x:?} {min:?} {max:?}");
        vertices += 1;
    }
    assert!(vertices > 1000);
}

#[test]
fn the_table_names_the_deformations() {
    let output = superquadric(&folder(), &["info", "ribbon.json"]);
    let table = String::from_utf8(output.stdout).expect("text");
    for expected in ["then       tapered", "then       twisted", "then       bent", "volume"] {
        assert!(table.contains(expected), "{table}");
    }
}

#[test]
fn what_takes_plain_models_refuses_deformed_ones() {
    let output = superquadric(&folder(), &["export", "ribbon.json", "--to", "pov", "-o", "o.pov"]);
    let message = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(2));
    assert!(message.contains("without deformations"), "{message}");
}

#[test]
fn the_schema_accepts_the_document_and_refuses_others() {
    let schema: Value = serde_json::from_str(SCHEMA).expect("a schema in JSON");
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    let ribbon: Value = serde_json::from_str(RIBBON).expect("JSON");
    assert!(validator.is_valid(&ribbon));
    let output = superquadric(&folder(), &["info", "ribbon.json", "--json"]);
    let info: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(validator.is_valid(&info));
    for (from, to) in [("\"bend\"", "\"bow\""), ("\"slope\"", "\"rise\""), ("[-1, 1]", "[-1]")] {
        let other: Value = serde_json::from_str(&RIBBON.replace(from, to)).expect("JSON");
        assert!(!validator.is_valid(&other), "{to}");
    }
}
