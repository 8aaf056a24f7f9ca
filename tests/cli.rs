//! The program as a user runs it.

mod common;

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use common::shared;
use serde_json::Value;
use tempfile::TempDir;

const SAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/samples/one_sided_view.ply");
const SCHEMA: &str = include_str!("../schema/fit-1.schema.json");

/// A bare model in JSON: an ellipsoid of volume 8 pi.
const BARE: &str = r#"{
  "shape": {"family": "superellipsoid", "size": [1, 2, 3], "exponents": [1, 1]},
  "pose": {"euler_zyz": [0.1, 0.2, 0.3], "translation": [5, 0, 0]}
}"#;

fn superquadric(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_superquadric"));
    command.args(arguments).stdin(Stdio::null());
    command
}

fn run(arguments: &[&str]) -> Output {
    superquadric(arguments).output().expect("the program starts")
}

fn run_with_input(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = superquadric(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("a pipe to the program");
    // A program that refuses its input early closes the pipe.
    let _ = stdin.write_all(input);
    drop(stdin);
    child.wait_with_output().expect("the program ends")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("text")
}

fn assert_done(output: &Output) {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(text(&output.stderr), "");
}

/// Bad input: exit code 2, nothing on stdout, and a message that names what it must.
fn assert_refused(output: &Output, names: &[&str]) {
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert_eq!(text(&output.stdout), "");
    for name in names {
        assert!(message.contains(name), "{message:?} does not name {name:?}");
    }
}

fn in_folder(folder: &TempDir, name: &str) -> String {
    folder.path().join(name).display().to_string()
}

#[test]
fn fit_prints_a_table_for_a_person() {
    let output = run(&["fit", SAMPLE]);
    assert_done(&output);
    let table = text(&output.stdout);
    for line in ["size", "exponents", "centre", "rotation", "residual", "points", "search"] {
        assert!(table.lines().any(|text| text.starts_with(line)), "{table}");
    }
    assert!(
        table.contains("can be trusted")
            && table.contains("1964 used, 0 of them strays; 0 skipped"),
        "{table}"
    );
}

#[test]
fn fit_writes_json_that_the_schema_accepts_and_the_truth_agrees_with() {
    let output = run(&["fit", SAMPLE, "-o", "-"]);
    assert_done(&output);
    let fit: Value = serde_json::from_slice(&output.stdout).expect("only JSON on stdout");
    let schema: Value = serde_json::from_str(SCHEMA).expect("a schema in JSON");
    let validator = jsonschema::validator_for(&schema).expect("a schema");
    let errors: Vec<String> = validator.iter_errors(&fit).map(|e| e.to_string()).collect();
    assert_eq!(errors, Vec::<String>::new());
    assert!(!validator.is_valid(&serde_json::json!({"schema": "superquadric.fit/1"})));

    // What examples/one_sided_view.rs made; 1 mm of noise on 2000 points.
    let size = fit["model"]["shape"]["size"].as_array().unwrap();
    for (actual, truth) in size.iter().zip([0.10, 0.07, 0.045]) {
        assert!((actual.as_f64().unwrap() / truth - 1.0).abs() < 0.02, "{size:?}");
    }
    assert_eq!(fit["fit"]["trusted"], true);
}

#[test]
fn fit_gives_the_same_bytes_for_any_number_of_threads_but_for_the_time() {
    let document = |threads: &str| {
        let output = run(&["fit", SAMPLE, "--threads", threads, "--seed", "3", "-o", "-"]);
        let mut fit: Value = serde_json::from_slice(&output.stdout).unwrap();
        fit["fit"]["seconds"] = 0.into();
        fit.to_string()
    };
    assert_eq!(document("1"), document("2"));
}

#[test]
fn fit_reads_stdin_and_writes_files_and_meshes() {
    let folder = TempDir::new().unwrap();
    let json = in_folder(&folder, "fit.json");
    for mesh in ["fit.ply", "fit.obj", "fit.stl"] {
        let mesh = in_folder(&folder, mesh);
        let output =
            run_with_input(&["fit", "-", "-o", &json, "--mesh", &mesh], &fs::read(SAMPLE).unwrap());
        assert_done(&output);
        assert!(text(&output.stdout).contains("can be trusted"));
        assert!(fs::metadata(&mesh).unwrap().len() > 10_000);
    }
    assert_done(&run(&["info", &json]));
}

#[test]
fn a_fit_that_cannot_be_trusted_exits_with_one_and_says_why() {
    let plane: String = (0..400).map(|i| format!("{} {} 0\n", i % 20, i / 20)).collect();
    let output = run_with_input(&["fit", "-"], plane.as_bytes());
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stdout).contains("not to be trusted: the points lie in one plane"));
}

#[test]
fn info_tells_volume_and_extents_of_a_bare_model() {
    let output = run_with_input(&["info", "-", "--json"], BARE.as_bytes());
    assert_done(&output);
    let info: Value = serde_json::from_slice(&output.stdout).unwrap();
    let volume = info["volume"].as_f64().unwrap();
    assert!((volume / (8.0 * std::f64::consts::PI) - 1.0).abs() < 1e-13);
    assert_eq!(info["extents"], serde_json::json!([2.0, 4.0, 6.0]));
    // An ellipsoid's inertia is a fifth of its mass times sums of squares.
    for (axis, sum) in [13.0, 10.0, 5.0].into_iter().enumerate() {
        let inertia = info["inertia"][axis][axis].as_f64().unwrap();
        assert!((inertia / (volume / 5.0 * sum) - 1.0).abs() < 1e-13);
    }
    let area = info["surface_area"].as_f64().unwrap();
    assert!((area / 48.882_146_302_582 - 1.0).abs() < 1e-12, "{area}");
    let [min, max] = [0, 1].map(|side| info["bounding_box"][side][0].as_f64().unwrap());
    assert!((min + max - 10.0).abs() < 1e-12 && max - min > 2.0 && max - min < 6.0);
    assert!(text(&run_with_input(&["info", "-"], BARE.as_bytes()).stdout).contains("25.1327"));
}

#[test]
fn mesh_writes_every_format_and_refuses_others() {
    let folder = TempDir::new().unwrap();
    for (name, magic) in [
        ("m.ply", &b"ply"[..]),
        ("m.obj", b"# superquadric {"),
        ("m.stl", b"SQE1"),
        ("m.glb", b"glTF"),
    ] {
        let path = in_folder(&folder, name);
        assert_done(&run_with_input(&["mesh", "-", "-o", &path], BARE.as_bytes()));
        assert!(fs::read(&path).unwrap().starts_with(magic));
    }
    let path = in_folder(&folder, "m.step");
    let output = run_with_input(&["mesh", "-", "-o", &path], BARE.as_bytes());
    assert_refused(&output, &["m.step", "ply, obj, stl or glb"]);
    assert!(!Path::new(&path).exists());
}

#[test]
fn models_go_to_other_programs_and_come_back() {
    let folder = TempDir::new().unwrap();
    let rounded = BARE.replace("[1, 1]", "[0.5, 0.25]");
    for program in ["ovito", "liggghts", "lammps", "mercury", "ems", "supercompose"] {
        let path = in_folder(&folder, program);
        assert_done(&run_with_input(
            &["export", "-", "--to", program, "-o", &path],
            rounded.as_bytes(),
        ));
        let output = run(&["import", &path, "--from", program]);
        assert_done(&output);
        let model: Value = serde_json::from_slice(&output.stdout).unwrap();
        let exponents = &model["shape"]["exponents"];
        assert_eq!(*exponents, serde_json::json!([0.5, 0.25]), "{program}");
    }
    for (program, part) in [("vtk", "vtkSuperquadricSource"), ("pov", "<0.25, 0.5>")] {
        let output = run_with_input(&["export", "-", "--to", program], rounded.as_bytes());
        assert_done(&output);
        assert!(text(&output.stdout).contains(part) && !text(&output.stdout).contains('@'));
    }
    let mesh = in_folder(&folder, "mesh.glb");
    assert_done(&run_with_input(&["mesh", "-", "-o", &mesh], rounded.as_bytes()));
    let output = run(&["import", &mesh, "--from", "mesh"]);
    assert!(text(&output.stdout).contains("superellipsoid"));
}

#[test]
fn a_supertoroid_goes_to_vtk_and_stays_in_its_mesh() {
    let folder = TempDir::new().unwrap();
    let toroid = r#"{"shape": {"family": "supertoroid", "size": [1, 0.7, 0.4],
        "exponents": [0.4, 1.3], "ring": 2.5}}"#;
    let output = run_with_input(&["export", "-", "--to", "vtk"], toroid.as_bytes());
    assert_done(&output);
    assert!(text(&output.stdout).contains("RING = 2.5"));
    let output = run_with_input(&["export", "-", "--to", "pov"], toroid.as_bytes());
    assert_refused(&output, &["stdin", "POV-Ray", "supertoroid"]);

    let mesh = in_folder(&folder, "toroid.glb");
    assert_done(&run_with_input(&["mesh", "-", "-o", &mesh], toroid.as_bytes()));
    let output = run(&["import", &mesh, "--from", "mesh"]);
    assert_done(&output);
    let model: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(model["shape"]["ring"], 2.5);
}

#[test]
fn what_cannot_be_exported_or_imported_is_told_with_its_file() {
    let folder = TempDir::new().unwrap();
    let bevelled = BARE.replace("[1, 1]", "[1, 1.5]");
    let output = run_with_input(&["export", "-", "--to", "lammps"], bevelled.as_bytes());
    assert_refused(&output, &["stdin", "LAMMPS", "from 0 to 1", "exponents[1] = 1.5"]);

    let two = in_folder(&folder, "two.txt");
    fs::write(&two, "1 1 1 2 3 0 0 0 0 0 0\n1 0.5 1 2 3 0 0 0 0 0 0\n").unwrap();
    for number in [&[][..], &["--number", "3"]] {
        let output = run(&[&["import", &two, "--from", "ems"], number].concat());
        assert_refused(&output, &["two.txt", "holds 2 superquadrics", "--number"]);
    }
    let output = run(&["import", &two, "--from", "ems", "--number", "2"]);
    assert!(text(&output.stdout).contains("0.5"));
    let output = run(&["import", &two, "--from", "supercompose"]);
    assert_refused(&output, &["two.txt", "components"]);

    let plain = in_folder(&folder, "plain.ply");
    fs::write(&plain, "ply\nend_header\n").unwrap();
    let output = run(&["import", &plain, "--from", "mesh"]);
    assert_refused(&output, &["plain.ply", "comment superquadric"]);
    assert_refused(&run(&["import", "absent.ply", "--from", "mesh"]), &["absent.ply"]);
}

#[test]
fn mesh_is_as_fine_as_its_tolerance_asks_for_by_every_method() {
    let folder = TempDir::new().unwrap();
    let path = in_folder(&folder, "m.obj");
    let facets = |tolerance: &str, method: &[&str]| {
        let arguments = ["mesh", "-", "-o", &path, "--tolerance", tolerance];
        assert_done(&run_with_input(&[&arguments, method].concat(), BARE.as_bytes()));
        fs::read_to_string(&path).unwrap().lines().filter(|line| line.starts_with("f ")).count()
    };
    assert_eq!(facets("0.01", &[]), facets("0.01", &["--method", "subdivision"]));
    for method in ["lattice", "curvature", "subdivision"] {
        let [coarse, fine] = ["0.1", "0.01"].map(|share| facets(share, &["--method", method]));
        assert!(fine > 4 * coarse && fine < 40 * coarse, "{method} {coarse} {fine}");
    }
    for (options, names) in [
        (&["--tolerance", "0"][..], "positive"),
        (&["--tolerance", "1e-12"], "13 million"),
        (&["--tolerance", "1", "--resolution", "8"], "--resolution"),
        (&["--method", "subdivision"], "--tolerance"),
    ] {
        let output =
            run_with_input(&[&["mesh", "-", "-o", &path], options].concat(), BARE.as_bytes());
        assert_refused(&output, &[names]);
    }
}

#[test]
fn bad_input_names_the_file_and_the_place() {
    let folder = TempDir::new().unwrap();
    assert_refused(&run(&["fit", "no-such-file.ply"]), &["no-such-file.ply"]);
    assert_refused(&run(&["fit", folder.path().to_str().unwrap()]), &["no files"]);
    assert_refused(&run_with_input(&["fit", "-"], b"1 2 3\n1 2\n"), &["stdin", "line 2"]);
    assert_refused(&run_with_input(&["fit", "-"], b"1 2 3\n"), &["stdin", "eleven"]);
    assert_refused(&run_with_input(&["info", "-"], b"{\"shape\": 1}"), &["stdin", "shape"]);
    assert_refused(&run_with_input(&["info", "-"], b"nonsense"), &["stdin", "line 1"]);
    assert_refused(&run(&["info", "no-such-file.json"]), &["no-such-file.json"]);
    let nowhere = in_folder(&folder, "no/such/folder/fit.json");
    assert_refused(&run(&["fit", SAMPLE, "-o", &nowhere]), &["no/such/folder"]);
    assert_refused(&run(&["fit", SAMPLE, "--mesh", "fit.xyz"]), &["fit.xyz"]);
    assert_refused(&run(&["fit", SAMPLE, "--resolution", "3"]), &["even"]);
    assert_refused(&run(&["fit", SAMPLE, "--threads", "0"]), &["--threads"]);
    assert_refused(&run(&["fly"]), &["fly"]);
}

#[test]
fn help_and_completions_are_there() {
    let help = text(&run(&["--help"]).stdout);
    for word in ["fit", "mesh", "info", "completions", "Examples", "Exit codes"] {
        assert!(help.contains(word), "{help}");
    }
    for shell in ["bash", "zsh", "fish"] {
        assert!(text(&run(&["completions", shell]).stdout).contains("superquadric"));
    }
}

/// Every file ends in a result or a clear refusal, never in a signal or a panic.
#[test]
fn files_that_readers_get_wrong_end_with_a_documented_exit_code() {
    let Some(corpus) = shared("plycorpus") else { return };
    let mut files = 0;
    let mut folders = vec![corpus];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            files += 1;
            let output = run(&["fit", path.to_str().unwrap()]);
            let message = text(&output.stderr);
            match output.status.code() {
                Some(0 | 1) => assert_eq!(message, "", "{}", path.display()),
                Some(2) => {
                    assert!(message.starts_with("superquadric: "), "{message}");
                    assert!(message.contains(path.to_str().unwrap()), "{message}");
                    assert_eq!(message.lines().count(), 1, "{message}");
                }
                code => panic!("{}: {code:?} {message}", path.display()),
            }
        }
    }
    assert!(files >= 50, "only {files} files in the corpus");
}

#[test]
fn coincident_and_coplanar_clouds_of_the_corpus() {
    let Some(corpus) = shared("plycorpus/reports") else { return };
    let path = |name: &str| corpus.join(name).display().to_string();
    assert_refused(&run(&["fit", &path("57_all_identical_points.ply")]), &["coincide"]);
    let coplanar = run(&["fit", &path("59_coplanar_points.ply")]);
    assert_eq!(coplanar.status.code(), Some(1));
    assert!(text(&coplanar.stdout).contains("one plane"));
}

#[test]
fn several_clouds_and_folders_get_a_line_and_a_document_each() {
    let folder = TempDir::new().expect("a folder");
    let clouds = folder.path().join("clouds");
    fs::create_dir(&clouds).expect("a folder");
    for name in ["b.ply", "a.ply"] {
        fs::copy(SAMPLE, clouds.join(name)).expect("a copy");
    }
    fs::write(clouds.join("notes.md"), "no cloud").expect("a file");
    let results = in_folder(&folder, "results");
    let clouds = clouds.display().to_string();
    let output = run(&["fit", &clouds, SAMPLE, "-o", &results]);
    assert_done(&output);
    let lines = text(&output.stdout);
    let names: Vec<&str> = lines.lines().filter_map(|line| line.split("  ").next()).collect();
    assert_eq!(names, [format!("{clouds}/a.ply"), format!("{clouds}/b.ply"), SAMPLE.to_owned()]);
    let written = |name: &str| {
        let json = fs::read_to_string(Path::new(&results).join(name)).expect("a document");
        serde_json::from_str::<Value>(&json).expect("JSON")
    };
    assert_eq!(written("a.ply.json")["model"], written("one_sided_view.ply.json")["model"]);

    // One that cannot be read does not keep the others from being fitted.
    let output = run(&["fit", SAMPLE, &in_folder(&folder, "nothing.ply")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stdout).contains("trusted"));
    assert!(text(&output.stderr).contains("nothing.ply"));

    let empty = folder.path().join("empty");
    fs::create_dir(&empty).expect("a folder");
    assert_refused(&run(&["fit", &empty.display().to_string()]), &["empty", "ply"]);
    assert_refused(&run(&["fit", SAMPLE, SAMPLE]), &["one_sided_view.ply"]);
    assert_refused(&run(&["fit", &clouds, "--mesh", "m.ply"]), &["--mesh"]);
}

#[test]
fn what_is_known_of_the_shape_is_kept() {
    let output = run(&["fit", SAMPLE, "-o", "-", "--fix", "a1=0.1", "--exponent-range", "0.2,0.6"]);
    assert_done(&output);
    let fit: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let size = fit["model"]["shape"]["size"][0].as_f64().expect("a number");
    assert!((size / 0.1 - 1.0).abs() < 1e-12);
    for wrong in [["--fix", "a9=1"], ["--fix", "a1"], ["--size-range", "3"], ["--support", "1,2"]] {
        let output = run(&["fit", SAMPLE, wrong[0], wrong[1]]);
        assert_eq!(output.status.code(), Some(2), "{wrong:?}");
        assert!(text(&output.stderr).contains("expected"), "{wrong:?}");
    }
    assert_refused(&run(&["fit", SAMPLE, "--fix", "e1=9"]), &["one_sided_view.ply", "e1"]);
    assert_refused(&run(&["fit", SAMPLE, "--support", "auto"]), &["--viewpoint"]);
}

#[test]
fn inliers_are_written_with_their_points() {
    let folder = TempDir::new().expect("a folder");
    let path = in_folder(&folder, "inliers.ply");
    assert_done(&run(&["fit", SAMPLE, "--viewpoint", "0,0,0", "--inliers", &path]));
    let bytes = fs::read(&path).expect("a file");
    let header = String::from_utf8_lossy(&bytes[..200]).into_owned();
    assert!(header.contains("element vertex 1964") && header.contains("property uchar inlier"));
}
