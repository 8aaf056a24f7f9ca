//! Points of models, and models at points, by the program as a user runs it.

#[path = "common/program.rs"]
mod program;

use std::fs;
use std::path::Path;

use program::{
    BENT, Table, assert_done, assert_refused, documents, is_all_near, plain, printed, run, str,
    written,
};
use serde_json::{Value, json};
use superquadric::cloud;
use tempfile::TempDir;

const BYS: [&str; 5] = ["area", "trigonometric", "angle-centre", "explicit", "equal-distance"];

/// What `evaluate` tells of what `sample` writes.
fn samples_and_evaluation(model: &str, by: &str, number: &str) -> (Table, Table) {
    let folder = TempDir::new().unwrap();
    let [model, points] = [written(&folder, "model.json", model), folder.path().join("p.csv")];
    assert_done(&run(&["sample", str(&model), "--by", by, "-n", number, "-o", str(&points)]));
    let samples = Table::of(&fs::read_to_string(&points).unwrap());
    (samples, printed(&["evaluate", str(&model), str(&points)]))
}

#[test]
fn points_in_rows_are_on_the_surface_of_every_family() {
    for (model, count) in documents() {
        for by in &BYS[1..] {
            let (samples, evaluation) = samples_and_evaluation(&model, by, "4");
            assert_eq!((samples.rows.len(), evaluation.rows.len()), (count, count));
            assert!(is_all_near(&evaluation.column("inside_outside"), 1.0, 1e-9), "{model} {by}");
            assert!(is_all_near(&evaluation.column("radial_distance"), 0.0, 1e-10), "{model} {by}");
            let places = [&samples, &evaluation].map(|table| table.vectors(["x", "y", "z"]));
            assert_eq!(places[0], places[1]);
            for normal in samples.vectors(["nx", "ny", "nz"]) {
                assert!((normal.norm() - 1.0).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn points_by_area_are_on_the_boundary_and_their_normals_along_the_gradient() {
    for (model, _) in documents() {
        let (samples, evaluation) = samples_and_evaluation(&model, "area", "300");
        assert_eq!(samples.rows.len(), 300);
        let functions = evaluation.column("inside_outside");
        let normals = samples.vectors(["nx", "ny", "nz"]);
        let gradients = evaluation.vectors(["gradient_x", "gradient_y", "gradient_z"]);
        let mut on_surface = 0;
        for ((f, normal), gradient) in functions.iter().zip(normals).zip(gradients) {
            // What is not of the surface is of a cap.
            assert!(*f < 1.0 + 1e-9);
            if (f - 1.0).abs() < 1e-9 {
                on_surface += 1;
                assert!((gradient.normalize() - normal).norm() < 1e-6, "{model}");
            }
        }
        assert!(on_surface == 300 || model.contains("clip") && on_surface > 50, "{on_surface}");
    }
}

#[test]
fn distances_and_feet_of_points_of_a_superellipsoid_are_no_distance_away() {
    let (_, evaluation) = samples_and_evaluation(&documents()[0].0, "area", "100");
    assert!(is_all_near(&evaluation.column("euclidean_distance"), 0.0, 1e-8));
    let feet = evaluation.vectors(["nearest_x", "nearest_y", "nearest_z"]);
    for (x, foot) in evaluation.vectors(["x", "y", "z"]).iter().zip(feet) {
        assert!((x - foot).norm() < 1e-8);
    }
}

#[test]
fn distances_from_a_ball_are_its_own_and_rows_that_are_no_points_stay_in_their_place() {
    let folder = TempDir::new().unwrap();
    let ball = r#""family": "superellipsoid", "size": [2, 2, 2], "exponents": [1, 1]"#;
    let ball = written(&folder, "ball.json", &plain(ball));
    let points = written(&folder, "points.csv", "x,y,z\n0,0,5\nnan,0,0\n1,0,0\n0,-3,4\n");
    let table = printed(&["evaluate", str(&ball), str(&points)]);
    assert!(table.rows[1].iter().all(|value| value.is_nan()));
    for (name, expected) in [
        ("inside", [0.0, 1.0, 0.0]),
        ("inside_outside", [6.25, 0.25, 6.25]),
        ("gradient_z", [2.5, 0.0, 2.0]),
        ("radial_distance", [3.0, -1.0, 3.0]),
        ("euclidean_distance", [3.0, -1.0, 3.0]),
        ("nearest_z", [2.0, 0.0, 1.6]),
        ("nearest_y", [0.0, 0.0, -1.2]),
    ] {
        let found = table.column(name);
        for (found, expected) in [found[0], found[2], found[3]].iter().zip(expected) {
            assert!((found - expected).abs() < 1e-7, "{name} {found} {expected}");
        }
    }
}

#[test]
fn curvatures_of_a_sphere_and_a_cylinder_are_their_closed_forms() {
    let ball = plain(r#""family": "superellipsoid", "size": [2, 2, 2], "exponents": [1, 1]"#);
    for by in BYS {
        let (samples, _) = samples_and_evaluation(&ball, by, "8");
        assert!(is_all_near(&samples.column("k1"), 0.5, 1e-9), "{by}");
        assert!(is_all_near(&samples.column("k2"), 0.5, 1e-9), "{by}");
    }
    let cylinder =
        plain(r#""family": "superellipsoid", "size": [2, 2, 3], "exponents": [0.05, 1]"#);
    let (samples, _) = samples_and_evaluation(&cylinder, "explicit", "8");
    let of_side = |values: Vec<f64>| -> Vec<f64> {
        let heights = samples.column("z");
        values.into_iter().zip(heights).filter(|(_, z)| z.abs() < 1.0).map(|(k, _)| k).collect()
    };
    assert!(is_all_near(&of_side(samples.column("k1")), 0.5, 1e-6));
    assert!(is_all_near(&of_side(samples.column("k2")), 0.0, 1e-6));
    assert!(is_all_near(&of_side(samples.column("nz")), 0.0, 1e-6));
}

#[test]
fn ply_and_csv_hold_the_same_points_and_seeds_tell_them_apart() {
    let folder = TempDir::new().unwrap();
    let model = written(&folder, "model.json", &documents()[3].0);
    let sample = |name: &str, seed: &str| {
        let path = folder.path().join(name);
        let arguments = ["-n", "50", "--seed", seed, "-o", str(&path)];
        assert_done(&run(&[&["sample", str(&model)], &arguments[..]].concat()));
        path
    };
    let [csv, ply, other] = [sample("a.csv", "7"), sample("a.ply", "7"), sample("b.ply", "8")];
    let [csv, ply, other] = [csv, ply, other].map(|path| cloud::read(&path).unwrap());
    assert_eq!((csv.len(), &csv), (50, &ply));
    assert_ne!(ply, other);
}

#[test]
fn deformed_models_have_points_and_functions_but_no_curvatures() {
    let folder = TempDir::new().unwrap();
    let mut bent = 0;
    for (model, _) in documents() {
        let mut model: Value = serde_json::from_str(&model).unwrap();
        model["deformations"] = json!([serde_json::from_str::<Value>(BENT).unwrap()]);
        let path = written(&folder, "bent.json", &model.to_string());
        if run(&["info", str(&path)]).status.code() == Some(2) {
            // A shape that the bend would fold.
            continue;
        }
        let (samples, evaluation) = samples_and_evaluation(&model.to_string(), "explicit", "4");
        assert_eq!(samples.columns, ["x", "y", "z", "nx", "ny", "nz"]);
        assert!(is_all_near(&evaluation.column("inside_outside"), 1.0, 1e-9));
        assert_eq!(evaluation.columns.len(), 8);
        // A step along the normal leads outside, one against it inside.
        let steps = [(1.0, 0.0), (-1.0, 1.0)].map(|(sign, inside)| {
            let places = samples.vectors(["x", "y", "z"]).into_iter();
            let moved = places.zip(samples.vectors(["nx", "ny", "nz"]));
            let lines = moved.map(|(x, n)| x + sign * 1e-5 * n);
            let lines: String = lines.map(|x| format!("{} {} {}\n", x.x, x.y, x.z)).collect();
            let points = written(&folder, "moved.xyz", &lines);
            let inside_found = printed(&["evaluate", str(&path), str(&points)]).column("inside");
            inside_found.iter().filter(|found| **found == inside).count()
        });
        // On rims of clips and on poles there may be no way in along the normal.
        let least = samples.rows.len() / 2;
        assert!(steps.iter().all(|&count| count >= least), "{model} {steps:?} {least}");
        bent += 1;
    }
    assert!(bent >= 4, "{bent}");
}

#[test]
fn of_solids_it_is_told_what_is_inside_and_the_level() {
    let folder = TempDir::new().unwrap();
    let ball = |radius: f64| {
        let size = format!("[{radius}, {radius}, {radius}]");
        plain(&format!(r#""family": "superellipsoid", "size": {size}, "exponents": [1, 1]"#))
    };
    let shell = format!(r#"{{"difference": [{}, {}]}}"#, ball(2.0), ball(1.0));
    let shell = written(&folder, "shell.json", &shell);
    let points = written(&folder, "points.xyz", "0 0 0\n0 1.5 0\n3 0 0\n0 0 2\n");
    let table = printed(&["evaluate", str(&shell), str(&points)]);
    assert_eq!(table.columns, ["x", "y", "z", "inside", "level"]);
    assert_eq!(table.column("inside"), [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(table.column("level"), [2.0, 0.75, 1.5, 1.0]);
}

#[test]
fn bad_use_is_refused_by_name_and_nothing_written() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out.csv");
    let other = folder.path().join("out.txt");
    let good = written(&folder, "good.json", &documents()[0].0);
    let points = written(&folder, "points.xyz", "0 0 0\n");
    let spiky = r#""family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 2.5]"#;
    let spiky = written(&folder, "spiky.json", &plain(spiky));
    let pair = format!(r#"{{"union": [{0}, {0}]}}"#, documents()[0].0);
    let pair = written(&folder, "pair.json", &pair);

    let sample = |model: &Path, more: &[&str]| {
        run(&[&["sample", str(model), "-o", str(&out)], more].concat())
    };
    assert_refused(&sample(&spiky, &[]), &["spiky.json", "up to 2", "2.5"]);
    assert_refused(&sample(&pair, &[]), &["pair.json", "several"]);
    assert_refused(&sample(&points, &[]), &["points.xyz"]);
    assert_refused(&sample(&folder.path().join("none.json"), &[]), &["none.json"]);
    assert_refused(&sample(&good, &["-n", "0"]), &["--number"]);
    assert_refused(&sample(&good, &["--by", "polar"]), &["--by", "angle-centre"]);
    assert_refused(&sample(&good, &["--by", "explicit", "-n", "751"]), &["--number", "750"]);
    assert_refused(&sample(&good, &["--by", "explicit", "--seed", "1"]), &["--seed"]);
    assert_refused(&run(&["sample", str(&good), "-o", str(&other)]), &["out.txt", "csv or ply"]);

    let evaluate = |model: &Path, points: &Path, output: &Path| {
        run(&["evaluate", str(model), str(points), "-o", str(output)])
    };
    assert_refused(&evaluate(&good, &points, &other), &["out.txt", "csv or ply"]);
    assert_refused(&evaluate(&good, &folder.path().join("none.ply"), &out), &["none.ply"]);
    assert_refused(&evaluate(&points, &points, &out), &["points.xyz"]);
    assert_refused(&evaluate(Path::new("-"), Path::new("-"), &out), &["stdin"]);

    assert!(!out.exists() && !other.exists());
}
