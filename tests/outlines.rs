//! `superquadric contour` as a user runs it.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

const MODEL: &str = r#"{"shape": {"family": "superellipsoid", "size": [0.1, 0.1, 0.1],
    "exponents": [1, 1]}, "pose": {"translation": [0, 0, 1]}}"#;
const CAMERA: &str =
    r#"{"fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5, "width": 640, "height": 480}"#;
const POSE: &str = r#"{"camera_from_world": [[0, -1, 0, 0.25], [1, 0, 0, 0], [0, 0, 1, 0]]}"#;

fn folder() -> TempDir {
    let folder = TempDir::new().expect("a folder");
    for (name, text) in [("model.json", MODEL), ("camera.json", CAMERA), ("pose.json", POSE)] {
        fs::write(folder.path().join(name), text).expect("a written file");
    }
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_superquadric"));
    command.args(arguments).current_dir(folder).output().expect("the program starts")
}

fn contour(folder: &TempDir, more: &[&str]) -> Value {
    let arguments = [&["contour", "model.json", "--camera", "camera.json", "-o", "-"], more];
    let output = run(folder.path(), &arguments.concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON on stdout")
}

#[test]
fn contour_writes_the_outline_in_json() {
    let folder = folder();
    let document = contour(&folder, &[]);
    assert_eq!(document["schema"], "superquadric.contour/1");
    assert_eq!(document["image"]["width"], 640);
    let radius = 500.0 * (0.1_f64).asin().tan();
    let polygon = document["contour"][0].as_array().unwrap();
    for pixel in polygon {
        let [u, v] = [0, 1].map(|k| pixel[k].as_f64().unwrap());
        assert!(((u - 319.5).hypot(v - 239.5) - radius).abs() < 1e-10);
    }
    let area = document["area"].as_f64().unwrap();
    assert!((area / (std::f64::consts::PI * radius * radius) - 1.0).abs() < 5e-4);
    let rim = &document["rim"][0];
    assert_eq!(rim["points"].as_array().unwrap().len(), polygon.len());
    assert_eq!(rim["hidden"].as_array().unwrap().len(), polygon.len());
    // The circle on the sphere: 1 m off, (1 - 0.1^2) m deep.
    assert!((rim["points"][3][2].as_f64().unwrap() - 0.99).abs() < 1e-14);
}

#[test]
fn a_pose_takes_the_model_from_the_world_to_the_camera() {
    let document = contour(&folder(), &["--pose", "pose.json"]);
    let [min, max] = [0, 1].map(|side| document["bounding_box"][side][0].as_f64().unwrap());
    let near = 319.5 + 500.0 * 0.25;
    assert!(min < near && near < max, "{min} {max}");
}

#[test]
fn contour_writes_svg_with_pixel_centres_at_integers() {
    let folder = folder();
    let arguments = ["contour", "model.json", "--camera", "camera.json", "-o", "outline.svg"];
    assert_eq!(run(folder.path(), &arguments).status.code(), Some(0));
    let svg = fs::read_to_string(folder.path().join("outline.svg")).unwrap();
    assert!(svg.starts_with("<svg ") && svg.contains("viewBox=\"-0.5 -0.5 640 480\""), "{svg}");
    assert!(svg.contains("<path d=\"M") && svg.ends_with("</svg>\n"), "{svg}");
}

#[test]
fn views_without_an_outline_and_bad_files_are_refused_by_name() {
    let folder = folder();
    let near = MODEL.replace("[0, 0, 1]", "[0, 0, 0.05]");
    fs::write(folder.path().join("near.json"), near).unwrap();
    for (arguments, expected) in [
        (["near.json", "--camera", "camera.json", "-o", "c.json"], "near.json: the camera"),
        (["model.json", "--camera", "model.json", "-o", "c.json"], "model.json: expected a camera"),
        (["model.json", "--camera", "camera.json", "-o", "c.txt"], "c.txt: the extension"),
        (["model.json", "--camera", "none.json", "-o", "c.json"], "none.json: "),
        (
            ["camera.json", "--camera", "camera.json", "-o", "c.json"],
            "camera.json: expected a model",
        ),
    ] {
        let output = run(folder.path(), &[&["contour"], &arguments[..]].concat());
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        assert!(!folder.path().join("c.json").exists());
    }
}
