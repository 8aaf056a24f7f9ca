//! `superquadric contour` and `overlay` as a user runs them.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;
use std::process::{Command, Output};

use png::{BitDepth, ColorType, Decoder, Encoder};
use serde_json::Value;
use tempfile::TempDir;

const MODEL: &str = r#"{"shape": {"family": "superellipsoid", "size": [0.1, 0.1, 0.1],
    "exponents": [1, 1]}, "pose": {"translation": [0, 0, 1]}}"#;
const CAMERA: &str =
    r#"{"fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5, "width": 640, "height": 480}"#;
const POSE: &str = r#"{"camera_from_world": [[0, -1, 0, 0.25], [1, 0, 0, 0], [0, 0, 1, 0]]}"#;

const SCHEMA: &str = include_str!("../schema/contour-1.schema.json");

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
    let schema: Value = serde_json::from_str(SCHEMA).expect("a schema in JSON");
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    let errors: Vec<String> = validator.iter_errors(&document).map(|e| e.to_string()).collect();
    assert_eq!(errors, Vec::<String>::new());
    assert!(!validator.is_valid(&serde_json::json!({"schema": "superquadric.contour/1"})));
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
    // A point a pixel at least.
    let count = rim["points"].as_array().unwrap().len();
    assert!(count as f64 > 0.99 * std::f64::consts::TAU * radius, "{count}");
    assert_eq!(rim["hidden"].as_array().unwrap().len(), count);
    // The circle on the sphere: 1 m off, (1 - 0.1^2) m deep.
    assert!((rim["points"][3][2].as_f64().unwrap() - 0.99).abs() < 1e-14);
}

#[test]
fn contour_of_a_torus_has_a_hole_and_hides_part_of_its_rim() {
    let folder = folder();
    let torus = r#"{"shape": {"family": "supertoroid", "size": [0.05, 0.05, 0.05],
        "exponents": [1, 1], "ring": 3}, "pose": {"translation": [0, 0, 1]}}"#;
    fs::write(folder.path().join("model.json"), torus).expect("a written file");
    let document = contour(&folder, &[]);
    let schema: Value = serde_json::from_str(SCHEMA).expect("a schema in JSON");
    assert!(jsonschema::validator_for(&schema).expect("a schema").is_valid(&document));
    assert_eq!(document["contour"].as_array().map(Vec::len), Some(2));
    // Lines of sight through the camera, 1 m off, that touch circles 0.15 m off the axis.
    let slope = |side: f64| {
        let (distance, angle) = (1.0_f64.hypot(0.15), (0.15_f64).atan());
        (angle + side * (0.05 / distance).asin()).tan()
    };
    let ring = std::f64::consts::PI * 500.0 * 500.0 * (slope(1.0).powi(2) - slope(-1.0).powi(2));
    assert!((document["area"].as_f64().unwrap() / ring - 1.0).abs() < 1e-3);
    let tilted = torus.replace("[0, 0, 1]}", "[0, 0, 1], \"euler_zyz\": [0, 1.5, 0]}");
    fs::write(folder.path().join("model.json"), tilted).expect("a written file");
    let document = contour(&folder, &[]);
    assert_eq!(document["contour"].as_array().map(Vec::len), Some(1));
    let flags = document["rim"].as_array().unwrap().iter();
    let flags = flags.flat_map(|curve| curve["hidden"].as_array().unwrap());
    let hidden = flags.clone().filter(|flag| **flag == Value::Bool(true)).count();
    assert!(hidden > 20 && hidden < flags.count() - 20, "{hidden}");
}

#[test]
fn contour_of_an_orthographic_camera_is_in_pixels_to_a_unit() {
    let folder = folder();
    let camera = r#"{"model": "orthographic", "scale": [300, 200], "origin": [10, 20],
        "width": 64, "height": 48}"#;
    let write = |text: &str| {
        fs::write(folder.path().join("camera.json"), text).expect("a written file");
    };
    write(camera);
    let document = contour(&folder, &[]);
    let ellipse = std::f64::consts::PI * 30.0 * 20.0;
    assert!((document["area"].as_f64().unwrap() / ellipse - 1.0).abs() < 5e-4);
    for pixel in document["contour"][0].as_array().unwrap() {
        let [u, v] = [0, 1].map(|k| pixel[k].as_f64().unwrap());
        assert!((((u - 10.0) / 30.0).hypot((v - 20.0) / 20.0) - 1.0).abs() < 1e-12);
    }
    for (from, to, expected) in [
        ("[300, 200]", "[300, 0]", "expected a scale of two positive numbers"),
        ("\"origin\"", "\"centre\"", "missing field `origin`"),
    ] {
        write(&camera.replace(from, to));
        let arguments = ["contour", "model.json", "--camera", "camera.json", "-o", "-"];
        let output = run(folder.path(), &arguments);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(expected), "{message}");
    }
}

const SCENE: &str = r#"{
    "solids": [
        {"solid": {"shape": {"family": "superellipsoid", "size": [0.1, 0.1, 0.1],
            "exponents": [1, 1]}, "pose": {"translation": [0.25, 0, 1]}}},
        {"solid": {"difference": [
            {"shape": {"family": "superellipsoid", "size": [0.3, 0.2, 0.2],
                "exponents": [0.2, 0.2]}, "pose": {"translation": [0, 0, 2]}},
            {"shape": {"family": "superellipsoid", "size": [0.1, 0.1, 0.5],
                "exponents": [0.2, 1]}, "pose": {"translation": [0, 0, 2]}}]}}],
    "camera": {"kind": "pinhole", "fx": 500, "fy": 500, "cx": 319.5, "cy": 239.5,
        "width": 640, "height": 480}}"#;

#[test]
fn contour_of_a_scene_is_that_of_all_its_solids_before_its_own_camera() {
    let folder = folder();
    fs::write(folder.path().join("scene.json"), SCENE).expect("a written file");
    let output = run(folder.path(), &["contour", "scene.json", "-o", "-"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let document: Value = serde_json::from_slice(&output.stdout).expect("JSON on stdout");
    let schema: Value = serde_json::from_str(SCHEMA).expect("a schema in JSON");
    assert!(jsonschema::validator_for(&schema).expect("a schema").is_valid(&document));
    // The block joined with the ball that hides a corner of it, and the hole through it.
    assert_eq!(document["contour"].as_array().map(Vec::len), Some(2));
    let ball = &document["rim"][0]["hidden"].as_array().unwrap();
    assert!(ball.iter().all(|flag| *flag == Value::Bool(false)));
    let flags = document["rim"].as_array().unwrap()[1..].iter();
    let hidden = flags.flat_map(|curve| curve["hidden"].as_array().unwrap());
    let count = hidden.filter(|flag| **flag == Value::Bool(true)).count();
    assert!(count > 20, "{count}");
    let output = run(folder.path(), &["contour", "model.json", "-o", "-"]);
    assert_eq!(output.status.code(), Some(2));
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

/// A picture of one grey, of 8 or 16 bits.
fn write_photo(path: &Path, size: [u32; 2], depth: BitDepth) {
    let mut encoder = Encoder::new(File::create(path).unwrap(), size[0], size[1]);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(depth);
    let count = (size[0] * size[1]) as usize * (depth as usize / 8);
    encoder.write_header().unwrap().write_image_data(&vec![90; count]).unwrap();
}

/// Red, green and blue of each pixel.
fn read_picture(path: &Path) -> (u32, Vec<[u8; 3]>) {
    let decoder = Decoder::new(BufReader::new(File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut bytes).unwrap();
    assert_eq!(frame.color_type, ColorType::Rgb);
    (frame.width, bytes.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect())
}

#[test]
fn overlay_draws_the_outline_on_its_pixels_and_leaves_the_rest() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let points: String = (0..200).map(|i| format!("0 {} 0.9\n", 0.0004 * f64::from(i))).collect();
    fs::write(path("points.xyz"), points).unwrap();
    for depth in [BitDepth::Eight, BitDepth::Sixteen] {
        write_photo(&path("photo.png"), [640, 480], depth);
        let view = ["overlay", "model.json", "--camera", "camera.json", "--image", "photo.png"];
        let more = ["-o", "out.png", "--points", "points.xyz"];
        let output = run(folder.path(), &[&view[..], &more].concat());
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let (width, pixels) = read_picture(&path("out.png"));
        assert_eq!((width, pixels.len()), (640, 640 * 480));
        let radius = 500.0 * (0.1_f64).asin().tan();
        for turn in 0..100 {
            let (sin, cos) = (0.0628 * f64::from(turn)).sin_cos();
            let at = |radius: f64| {
                let [u, v] = [319.5 + radius * cos, 239.5 + radius * sin].map(f64::round);
                pixels[v as usize * 640 + u as usize]
            };
            let [red, _, blue] = at(radius);
            // The axes x and y cross the outline.
            let is_axis = !(3..=97).contains(&turn) || (22..29).contains(&turn);
            assert!(red > blue || is_axis, "{turn}");
            assert_eq!(at(1.5 * radius), [90; 3]);
        }
        let coloured =
            pixels.iter().filter(|[red, _, blue]| *blue > red.saturating_add(60)).count();
        assert!(coloured > 500, "{coloured} pixels of points and scale within the model");
    }
}

const PARALLEL: &str = r#"{"model": "orthographic", "scale": [300, 300], "origin": [320, 240],
    "width": 640, "height": 480}"#;

#[test]
fn overlay_draws_every_family_and_deformed_models_and_scenes_before_both_cameras() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let pose = r#""pose": {"translation": [0, 0, 1], "euler_zyz": [0.3, 1.1, 0]}"#;
    let bend =
        r#""deformations": [{"kind": "bend", "rate": 2, "center": 0, "range": [-0.1, 0.1]}]"#;
    let models = [
        r#""family": "supertoroid", "size": [0.05, 0.05, 0.04], "exponents": [0.6, 1], "ring": 2"#,
        r#""family": "superhyperboloid_one_sheet", "size": [0.05, 0.05, 0.1],
            "exponents": [0.6, 1], "clip": 0.15"#,
        r#""family": "superhyperboloid_two_sheets", "size": [0.05, 0.05, 0.1],
            "exponents": [0.6, 1], "clip": 0.15"#,
        r#""family": "three_exponent", "size": [0.1, 0.1, 0.15], "exponents": [2, 4, 8]"#,
        r#""family": "superellipsoid", "size": [0.1, 0.1, 0.15], "exponents": [1, 2.6]"#,
    ];
    let plain = models.map(|shape| format!("{{\"shape\": {{{shape}}}, {pose}}}"));
    let bent = models.map(|shape| format!("{{\"shape\": {{{shape}}}, {bend}, {pose}}}"));
    write_photo(&path("photo.png"), [640, 480], BitDepth::Eight);
    fs::write(path("parallel.json"), PARALLEL).unwrap();
    for model in plain.iter().chain(&bent[..2]).chain([&SCENE.to_owned()]) {
        fs::write(path("model.json"), model).unwrap();
        for camera in ["camera.json", "parallel.json"] {
            let view = ["model.json", "--camera", camera];
            let drawn = run(
                folder.path(),
                &[&["overlay"], &view[..], &["--image", "photo.png", "-o", "out.png"]].concat(),
            );
            let message = String::from_utf8_lossy(&drawn.stderr);
            assert_eq!(drawn.status.code(), Some(0), "{message} {model}");
            let (_, pixels) = read_picture(&path("out.png"));
            let outline = run(folder.path(), &[&["contour"], &view[..], &["-o", "-"]].concat());
            let outline: Value = serde_json::from_slice(&outline.stdout).unwrap();
            let outline = outline["contour"].as_array().unwrap().iter();
            let on_line = outline.flat_map(|polygon| polygon.as_array().unwrap()).map(|pixel| {
                let [u, v] = [0, 1].map(|k| pixel[k].as_f64().unwrap().round() as usize);
                let [red, _, blue] = pixels[v * 640 + u];
                red > blue
            });
            let (count, yellow) =
                on_line.fold((0, 0), |(count, is), on| (count + 1, is + i32::from(on)));
            assert!(yellow * 10 > count * 8, "{yellow} of {count} {camera} {model}");
            assert!(pixels.contains(&[90; 3]));
        }
    }
}

#[test]
fn overlay_takes_points_from_a_depth_map() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    write_photo(&path("photo.png"), [640, 480], BitDepth::Eight);
    // 0x5a5a counts everywhere.
    write_photo(&path("depth.png"), [640, 480], BitDepth::Sixteen);
    let view = ["overlay", "model.json", "--camera", "camera.json", "--image", "photo.png"];
    let depth = ["-o", "out.png", "--depth", "depth.png"];
    let output = run(folder.path(), &[&view[..], &depth].concat());
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(message.contains("depth.png: the camera's file has no depth_units_m"), "{message}");
    let unit = ["--depth-unit", "1e-4"];
    let output = run(folder.path(), &[&view[..], &depth, &unit].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let (_, pixels) = read_picture(&path("out.png"));
    let outside = pixels.iter().filter(|[red, _, blue]| *red > blue.saturating_add(60)).count();
    assert!(outside > 1000, "{outside} pixels of points outside the model");
}

#[test]
fn pictures_that_are_not_the_cameras_are_refused() {
    let folder = folder();
    write_photo(&folder.path().join("photo.png"), [64, 48], BitDepth::Eight);
    for (photo, expected) in [
        ("photo.png", "photo.png: expected [640, 480] pixels"),
        ("model.json", "model.json: expected a PNG image"),
        ("none.png", "none.png: "),
    ] {
        let view = ["overlay", "model.json", "--camera", "camera.json", "--image", photo];
        let output = run(folder.path(), &[&view[..], &["-o", "out.png"]].concat());
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        assert!(!folder.path().join("out.png").exists());
    }
}
