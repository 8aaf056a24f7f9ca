//! `superquadric render`: solids as a camera sees them.

use std::fs;
use std::process::{Command, Output};

use tempfile::TempDir;

const CAMERA: &str = r#"{"fx": 60, "fy": 60, "cx": 20, "cy": 15, "width": 41, "height": 31, "depth_units_m": 0.001}"#;

/// A ball of radius 1 at a depth of 4, bored through from the side.
const BORED: &str = r#"{"difference": [
    {"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]},
     "pose": {"translation": [0, 0, 4]}},
    {"shape": {"family": "superellipsoid", "size": [0.3, 0.3, 2], "exponents": [0.1, 1]},
     "pose": {"translation": [0.9, 0, 4]}}
]}"#;

fn folder() -> TempDir {
    let folder = TempDir::new().expect("a folder");
    for (name, text) in [("camera.json", CAMERA), ("bored.json", BORED)] {
        fs::write(folder.path().join(name), text).expect("a file");
    }
    folder
}

fn render(folder: &TempDir, arguments: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_superquadric");
    let start = ["render", "bored.json", "--camera", "camera.json"];
    let mut command = Command::new(program);
    command.args(start).args(arguments).current_dir(folder).output().expect("the program")
}

fn png(folder: &TempDir, name: &str) -> (png::OutputInfo, Vec<u8>) {
    let file = std::io::BufReader::new(fs::File::open(folder.path().join(name)).expect("a file"));
    let mut reader = png::Decoder::new(file).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    (reader.next_frame(&mut pixels).expect("pixels"), pixels)
}

#[test]
fn depths_normals_and_picture_are_of_the_solid() {
    let folder = folder();
    let outputs = ["--depth", "depth.png", "--normals", "normals.png", "--shaded", "shaded.png"];
    let output = render(&folder, &outputs);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let (info, depth) = png(&folder, "depth.png");
    assert_eq!((info.width, info.height), (41, 31));
    let count = |column: usize, row: usize| {
        let at = 2 * (row * 41 + column);
        u16::from_be_bytes([depth[at], depth[at + 1]])
    };
    // The ray of the middle pixel meets the ball at a depth of 3.
    assert_eq!(count(20, 15), 3000);
    assert_eq!(count(0, 0), 0);
    // In column c the ray has x = (c - 20) / 60 z; the bore takes what is within 0.3 of x = 0.9.
    let ball = |column: f64| {
        let x = (column - 20.0) / 60.0;
        let a = 1.0 + x * x;
        (4.0 - (16.0 - 15.0 * a).sqrt()) / a
    };
    assert_eq!(count(27, 15), (1000.0 * ball(27.0)).round() as u16);
    assert_eq!(count(33, 15), 0);
    let (_, normals) = png(&folder, "normals.png");
    let middle = 3 * (15 * 41 + 20);
    assert_eq!(normals[middle..middle + 3], [128, 128, 0]);
    let (_, shaded) = png(&folder, "shaded.png");
    assert_eq!(shaded[..3], [255; 3]);
    assert_ne!(shaded[middle..middle + 3], [255; 3]);
}

#[test]
fn depths_as_numbers_are_exact_and_the_same_for_any_number_of_threads() {
    let folder = folder();
    assert!(render(&folder, &["--depth", "depth.npy"]).status.success());
    let bytes = fs::read(folder.path().join("depth.npy")).expect("a file");
    let middle = bytes.len() - 8 * 41 * 31 + 8 * (15 * 41 + 20);
    let depth = f64::from_le_bytes(bytes[middle..middle + 8].try_into().expect("eight bytes"));
    assert!((depth - 3.0).abs() < 1e-14);
    let mut one = Command::new(env!("CARGO_BIN_EXE_superquadric"));
    one.args(["render", "bored.json", "--camera", "camera.json", "--depth", "one.npy"]);
    assert!(
        one.env("RAYON_NUM_THREADS", "1").current_dir(&folder).status().expect("run").success()
    );
    assert_eq!(fs::read(folder.path().join("one.npy")).expect("a file"), bytes);
}

#[test]
fn what_it_writes_is_what_a_fit_reads() {
    let folder = folder();
    assert!(render(&folder, &["--depth", "depth.png"]).status.success());
    let output = Command::new(env!("CARGO_BIN_EXE_superquadric"))
        .args(["fit", "depth.png", "--camera", "camera.json", "-o", "fit.json"])
        .current_dir(&folder)
        .output()
        .expect("the program");
    // Part of a ball says little, but it is read.
    assert!(matches!(output.status.code(), Some(0 | 1)), "{output:?}");
}

#[test]
fn a_solid_is_meshed() {
    let folder = folder();
    let output = Command::new(env!("CARGO_BIN_EXE_superquadric"))
        .args(["mesh", "bored.json", "-o", "bored.obj", "--resolution", "20"])
        .current_dir(&folder)
        .output()
        .expect("the program");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mesh = fs::read_to_string(folder.path().join("bored.obj")).expect("a mesh");
    let vertices = mesh.lines().filter_map(|line| line.strip_prefix("v "));
    for line in vertices.clone() {
        let x: Vec<f64> = line.split(' ').map(|n| n.parse().expect("a number")).collect();
        let of_center = (x[0].hypot(x[1])).hypot(x[2] - 4.0);
        let of_bore = (x[0] - 0.9).hypot(x[1]);
        // On the ball outside the bore, or on the bore inside the ball.
        let is_on_ball = (of_center - 1.0).abs() < 1e-6 && of_bore > 0.3 - 1e-6;
        assert!(is_on_ball || ((of_bore - 0.3).abs() < 1e-6 && of_center < 1.0 + 1e-6), "{x:?}");
    }
    assert!(vertices.count() > 1000);
}

#[test]
fn without_an_output_and_with_bad_input_it_says_so() {
    let folder = folder();
    assert_eq!(render(&folder, &[]).status.code(), Some(2));
    fs::write(folder.path().join("bored.json"), r#"{"union": []}"#).expect("a file");
    let output = render(&folder, &["--depth", "depth.png"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("at least one solid"), "{message}");
    assert!(message.contains("bored.json"), "{message}");
}
