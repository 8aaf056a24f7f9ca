//! Scenes: the documents in `samples/solids` and what the program makes of them.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use jsonschema::Registry;
use serde_json::Value;
use tempfile::TempDir;

const COARSE: &str = r#"{"fx": 42, "fy": 42, "cx": 19.5, "cy": 14.5, "width": 40, "height": 30}"#;

/// Two balls of radius 1 before a parallel camera, the red one nearer.
const BALLS: &str = r#"{
    "solids": [
        {"solid": {"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]},
                   "pose": {"translation": [0, 0, 8]}},
         "material": {"color": [0, 0, 1], "specular": 0, "diffuse": 1}},
        {"solid": {"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]},
                   "pose": {"translation": [1.5, 0, 4]}},
         "material": {"color": [1, 0, 0], "specular": 0, "diffuse": 1}}
    ],
    "camera": {"kind": "orthographic", "scale": [10, 10], "origin": [12, 12], "width": 41, "height": 25},
    "ambient": [0, 0, 0],
    "lights": [{"kind": "directional", "to_light": [0, 0, -1]}],
    "background": [0, 1, 0]
}"#;

fn superquadric(folder: &TempDir, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_superquadric"));
    command.args(arguments).current_dir(folder).output().expect("the program")
}

fn succeed(folder: &TempDir, arguments: &[&str]) -> Vec<u8> {
    let output = superquadric(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

fn folder(name: &str, text: &str) -> TempDir {
    let folder = TempDir::new().expect("a folder");
    fs::write(folder.path().join(name), text).expect("a file");
    fs::write(folder.path().join("coarse.json"), COARSE).expect("a file");
    folder
}

fn pixels(folder: &TempDir, name: &str) -> Vec<u8> {
    let file = std::io::BufReader::new(fs::File::open(folder.path().join(name)).expect("a file"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut pixels).expect("pixels");
    pixels
}

/// The sample scenes, with their documents as JSON.
fn samples() -> Vec<(PathBuf, Value)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/solids");
    let entries =
        fs::read_dir(root).expect("a folder").map(|entry| entry.expect("an entry").path());
    let scenes: Vec<_> = entries
        .filter_map(|path| {
            let text = || fs::read_to_string(&path).expect("text");
            let value = match path.extension()?.to_str()? {
                "json" => serde_json::from_str(&text()).expect("JSON"),
                "toml" => toml::from_str(&text()).expect("TOML"),
                _ => return None,
            };
            Some((path, value))
        })
        .collect();
    assert_eq!(scenes.len(), 7);
    scenes
}

fn validator() -> jsonschema::Validator {
    let of = |text: &str| serde_json::from_str::<Value>(text).expect("JSON");
    let mut scene = of(include_str!("../schema/scene-1.schema.json"));
    scene["$id"] = "file:///schema/scene-1.schema.json".into();
    let registry = Registry::new()
        .add(
            "file:///schema/model-1.schema.json",
            of(include_str!("../schema/model-1.schema.json")),
        )
        .and_then(|registry| {
            let solid = of(include_str!("../schema/solid-1.schema.json"));
            registry.add("file:///schema/solid-1.schema.json", solid)
        })
        .and_then(|registry| registry.prepare())
        .expect("schemas");
    jsonschema::options().with_registry(&registry).build(&scene).expect("a schema")
}

#[test]
fn the_samples_satisfy_the_schema_and_misspelt_ones_do_not() {
    let validator = validator();
    for (path, value) in samples() {
        let errors: Vec<_> = validator.iter_errors(&value).map(|e| e.to_string()).collect();
        assert!(errors.is_empty(), "{path:?}: {errors:?}");
        for key in ["camera", "lights", "solids"] {
            assert!(value.get(key).is_some(), "{path:?} has no {key}");
        }
    }
    let balls: Value = serde_json::from_str(BALLS).expect("JSON");
    assert!(validator.is_valid(&balls));
    for (from, to) in [
        ("\"lights\"", "\"lamps\""),
        ("\"to_light\"", "\"from_light\""),
        ("\"orthographic\"", "\"pinhole\""),
        ("\"specular\": 0", "\"specular\": 2"),
        ("\"shape\"", "\"form\""),
    ] {
        let misspelt: Value = serde_json::from_str(&BALLS.replace(from, to)).expect("JSON");
        assert!(!validator.is_valid(&misspelt), "{to}");
        let folder = folder("scene.json", &BALLS.replace(from, to));
        let output = superquadric(&folder, &["render", "scene.json", "--depth", "d.npy"]);
        assert_eq!(output.status.code(), Some(2), "{to}");
    }
}

#[test]
fn the_samples_are_seen_by_their_cameras_and_by_another() {
    for (path, _) in samples() {
        let folder = folder("unused.json", "{}");
        let scene = path.to_str().expect("a name");
        succeed(&folder, &["render", scene, "--camera", "coarse.json", "--depth", "depth.png"]);
        let hit = pixels(&folder, "depth.png").chunks(2).filter(|count| *count != [0, 0]).count();
        assert!((40..900).contains(&hit), "{path:?}: {hit}");
    }
}

#[test]
fn the_nearest_solid_is_seen_in_its_own_colour() {
    let folder = folder("balls.json", BALLS);
    succeed(&folder, &["render", "balls.json", "--shaded", "s.png", "--depth", "d.png"]);
    let picture = pixels(&folder, "s.png");
    let color = |column: usize, row: usize| {
        let at = 3 * (row * 41 + column);
        [picture[at], picture[at + 1], picture[at + 2]]
    };
    // The middles of both face the light; pixel (20, 12) is of both, 0.7 from the nearer one.
    let facing = |offset: f64| (255.0 * (1.0 - offset * offset).sqrt()).round() as u8;
    assert_eq!([color(12, 12), color(27, 12)], [[0, 0, 255], [255, 0, 0]]);
    assert_eq!(color(20, 12), [facing(0.7), 0, 0]);
    assert_eq!(color(40, 0), [0, 255, 0]);
    let depths = pixels(&folder, "d.png");
    let count = |at: usize| u16::from_be_bytes([depths[2 * at], depths[2 * at + 1]]);
    assert_eq!([count(12 * 41 + 12), count(12 * 41 + 27)], [7000, 3000]);
}

#[test]
fn a_solid_alone_needs_a_camera_and_says_so() {
    let solid = r#"shape = {family = "superellipsoid", size = [1, 1, 1], exponents = [1, 1]}
pose.translation = [0, 0, 4]"#;
    let folder = folder("ball.toml", solid);
    let output = superquadric(&folder, &["render", "ball.toml", "--depth", "d.png"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("ball.toml") && message.contains("--camera"), "{message}");
    succeed(&folder, &["render", "ball.toml", "--camera", "coarse.json", "--depth", "d.png"]);
}

#[test]
fn info_bounds_the_volume_of_solids_and_scenes() {
    let folder = folder("balls.json", BALLS);
    let info = |arguments: &[&str]| -> Value {
        serde_json::from_slice(&succeed(&folder, arguments)).expect("JSON")
    };
    let number = |value: &Value| value.as_f64().expect("a number");
    let scene = info(&["info", "balls.json", "--json"]);
    let ball = 4.0 / 3.0 * std::f64::consts::PI;
    let solids = scene["solids"].as_array().expect("solids");
    assert_eq!(solids.len(), 2);
    for solid in solids {
        let [least, most] = [0, 1].map(|end| number(&solid["volume_bounds"][end]));
        assert!(least <= ball && ball <= most && most - least <= 0.02 * most, "{least} {most}");
    }
    for (at, expected) in [([0, 0], -1.0), ([1, 0], 2.5), ([0, 2], 3.0), ([1, 2], 9.0)] {
        let found = number(&scene["bounding_box"][at[0]][at[1]]);
        assert!((found - expected).abs() < 1e-2, "{at:?}: {found}");
    }
    let parts: Value = serde_json::from_str(BALLS).expect("JSON");
    let parts: Vec<&Value> = [0, 1].map(|i| &parts["solids"][i]["solid"]).into();
    for (key, is_empty) in [("union", false), ("intersection", true), ("difference", false)] {
        let solid = serde_json::json!({ key: &parts }).to_string();
        fs::write(folder.path().join("solid.json"), solid).expect("a file");
        let solid = info(&["info", "solid.json", "--json"]);
        assert_eq!(solid["models"], 2);
        assert_eq!(solid["bounding_box"].is_null(), is_empty, "{key}");
        let volume = match key {
            "union" => 2.0 * ball,
            "difference" => ball,
            _ => 0.0,
        };
        let [least, most] = [0, 1].map(|end| number(&solid["volume_bounds"][end]));
        assert!(least <= volume && volume <= most, "{key}: {least} {most}");
        let table = String::from_utf8(succeed(&folder, &["info", "solid.json"])).expect("text");
        assert!(table.contains("volume"), "{table}");
    }
    let table = String::from_utf8(succeed(&folder, &["info", "balls.json"])).expect("text");
    assert!(table.contains("2 solids"), "{table}");
}
