//! Models of every family through documents and the program.

use std::f64::consts::PI;
use std::io::Write;
use std::process::{Command, Output, Stdio};

use serde_json::{Value, json};
use superquadric::model::Model;
use superquadric::pose::Pose;
use superquadric::report::{ModelDocument, any_model_from_json, model_from_json};
use superquadric::shape::{
    Parametric, Shape, Solid, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets,
    Supertoroid, ThreeExponent,
};
use tempfile::TempDir;

const SCHEMA: &str = include_str!("../schema/model-1.schema.json");

fn models() -> [Model<Shape>; 5] {
    let size = [2.0, 0.7, 1.3];
    let shapes: [Shape; 5] = [
        Superellipsoid::new(size, [0.4, 1.3]).unwrap().into(),
        SuperhyperboloidOneSheet::new(size, [0.4, 1.3], 2.2).unwrap().into(),
        SuperhyperboloidTwoSheets::new(size, [0.4, 1.3], 3.5).unwrap().into(),
        Supertoroid::new(size, [0.4, 1.3], 1.6).unwrap().into(),
        ThreeExponent::new(size, [1.5, 2.0, 7.0]).unwrap().into(),
    ];
    let pose = Pose::from_euler_zyz([0.3, 1.1, -0.8], [5.0, -3.0, 2.0].into());
    shapes.map(|shape| Model { shape, pose })
}

/// Runs a subcommand on a model's document.
fn run(arguments: &[&str], document: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_superquadric"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("a pipe to the program");
    stdin.write_all(document.as_bytes()).expect("the program reads");
    drop(stdin);
    child.wait_with_output().expect("the program ends")
}

fn info(document: &str) -> Value {
    let output = run(&["info", "-", "--json"], document);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn every_family_comes_back_from_its_document_which_the_schema_accepts() {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    for model in models() {
        let document = serde_json::to_value(ModelDocument::from(&model)).unwrap();
        assert_eq!(document["shape"]["family"], model.shape.family());
        let errors: Vec<_> = validator.iter_errors(&document).map(|e| e.to_string()).collect();
        assert!(errors.is_empty(), "{errors:?}");
        let again = any_model_from_json(&document.to_string()).unwrap();
        assert_eq!(again.shape, model.shape);
        assert_eq!(again.pose.translation(), model.pose.translation());

        let superellipsoid = model_from_json(&document.to_string());
        match model.shape {
            Shape::Superellipsoid(shape) => assert_eq!(superellipsoid.unwrap().shape, shape),
            other => {
                let message = superellipsoid.unwrap_err().to_string();
                assert!(message.contains(other.family()), "{message}");
            }
        }
    }
}

#[test]
fn a_clip_that_is_not_given_has_its_documented_value() {
    let clips = [("superhyperboloid_one_sheet", 3.0), ("superhyperboloid_two_sheets", 2.0)];
    for (family, expected) in clips {
        let shape = json!({"family": family, "size": [1, 2, 3], "exponents": [1, 1]});
        let model = any_model_from_json(&json!({"shape": shape}).to_string()).unwrap();
        let clip = match model.shape {
            Shape::SuperhyperboloidOneSheet(tower) => tower.clip(),
            Shape::SuperhyperboloidTwoSheets(bowls) => bowls.clip(),
            other => panic!("{other:?}"),
        };
        assert_eq!(clip, expected);
    }
}

#[test]
fn info_tells_masses_and_the_least_box_of_every_family() {
    for model in models() {
        let info = info(&ModelDocument::from(&model).to_json());
        let mass = model.shape.mass_properties();
        assert_eq!(number(&info["volume"]), mass.volume());
        assert_eq!(number(&info["surface_area"]), model.shape.surface_area());
        for i in 0..3 {
            for j in 0..3 {
                assert_eq!(number(&info["inertia"][i][j]), mass.inertia()[(i, j)]);
            }
        }
        // The box holds every surface point of the world within the clip.
        let [[south, north], [west, east]] = model.shape.domain();
        let mut count = 0;
        for (i, j) in (0..=40).flat_map(|i| (0..=40).map(move |j| (f64::from(i), f64::from(j)))) {
            let x = model
                .shape
                .position(south + i / 40.0 * (north - south), west + j / 40.0 * (east - west));
            if !matches!(model.shape, Shape::SuperhyperboloidTwoSheets(_)) || x.x < 3.5 {
                let x_world = model.pose.world_from_model(&x);
                for axis in 0..3 {
                    let [min, max] = [0, 1].map(|k| number(&info["bounding_box"][k][axis]));
                    assert!(min - 1e-9 <= x_world[axis] && x_world[axis] <= max + 1e-9);
                }
                count += 1;
            }
        }
        assert!(count > 100, "{}", model.shape.family());
    }
}

#[test]
fn info_of_a_torus_is_the_textbooks() {
    let shape = json!({"family": "supertoroid", "size": [1, 1, 1], "exponents": [1, 1], "ring": 3});
    let info = info(&json!({"shape": shape}).to_string());
    assert!((number(&info["volume"]) / (6.0 * PI * PI) - 1.0).abs() < 1e-12);
    assert!((number(&info["surface_area"]) / (12.0 * PI * PI) - 1.0).abs() < 1e-10);
    assert_eq!(info["bounding_box"], json!([[-4.0, -4.0, -1.0], [4.0, 4.0, 1.0]]));
    let table = run(&["info", "-"], &json!({"shape": shape}).to_string());
    let table = String::from_utf8(table.stdout).unwrap();
    assert!(table.contains("supertoroid") && table.contains("ring"), "{table}");
}

#[test]
fn every_family_is_meshed_to_every_format() {
    let folder = TempDir::new().unwrap();
    for model in models() {
        for extension in ["ply", "obj", "stl", "glb"] {
            let path = folder.path().join(format!("{}.{extension}", model.shape.family()));
            let path_text = path.to_str().unwrap();
            let arguments = ["mesh", "-", "-o", path_text, "--resolution", "8"];
            let output = run(&arguments, &ModelDocument::from(&model).to_json());
            let message = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(0), "{message}");
            assert!(std::fs::metadata(&path).unwrap().len() > 1000);
        }
    }
}

#[test]
fn every_family_is_meshed_within_a_tolerance_by_every_method() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("mesh.obj");
    for model in models() {
        let document = ModelDocument::from(&model).to_json();
        for method in ["lattice", "curvature", "subdivision"] {
            let facets = |tolerance: &str| {
                let path_text = path.to_str().unwrap();
                let tolerance = ["--tolerance", tolerance, "--method", method];
                let output =
                    run(&[&["mesh", "-", "-o", path_text][..], &tolerance].concat(), &document);
                let message = String::from_utf8_lossy(&output.stderr);
                assert_eq!(output.status.code(), Some(0), "{message}");
                let text = std::fs::read_to_string(&path).unwrap();
                text.lines().filter(|line| line.starts_with("f ")).count()
            };
            let [coarse, fine] = ["0.1", "0.01"].map(facets);
            assert!(fine > 2 * coarse, "{method} {} {coarse} {fine}", model.shape.family());
        }
    }
}

#[test]
fn a_tolerance_is_for_one_shape_and_not_for_a_solid_of_several() {
    let ball =
        json!({"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]}});
    let output = run(
        &["mesh", "-", "-o", "never.ply", "--tolerance", "0.1"],
        &json!({"union": [ball, ball]}).to_string(),
    );
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("--resolution"), "{message}");
}

#[test]
fn what_is_wrong_with_a_shape_is_named() {
    let torus = |ring: Value| json!({"family": "supertoroid", "size": [1, 1, 1], "exponents": [1, 1], "ring": ring});
    let two = |clip: Value| {
        json!({
            "family": "superhyperboloid_two_sheets",
            "size": [2, 1, 1], "exponents": [1, 1], "clip": clip
        })
    };
    let cases = [
        (torus(json!(0.5)), "ring must be a number of at least 1, found 0.5"),
        (json!({"family": "supertoroid", "size": [1, 1, 1], "exponents": [1, 1]}), "`ring`"),
        (two(json!(2)), "clip must be a number above 2, found 2"),
        (json!({"family": "three_exponent", "size": [1, 1, 1], "exponents": [2, 2]}), "3"),
        (json!({"family": "three_exponent", "size": [1, 1, 1], "exponents": [2, 0, 2]}), "[1]"),
        (json!({"family": "cone", "size": [1, 1, 1], "exponents": [2, 2]}), "supertoroid"),
    ];
    for (shape, expected) in cases {
        let output = run(&["info", "-"], &json!({"shape": shape}).to_string());
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(expected), "{message:?} does not name {expected:?}");
    }
    // What only superellipsoids can do says so.
    let output =
        run(&["export", "-", "--to", "ovito"], &json!({"shape": torus(json!(2))}).to_string());
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("supertoroid"), "{message}");
}
