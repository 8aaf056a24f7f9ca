//! Plane curves and their spherical products, by the program as a user runs it.

#[path = "common/program.rs"]
mod program;

use std::fs;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use program::{assert_done, assert_refused, run, str, written};
use superquadric::shape::Superellipsoid;
use tempfile::TempDir;

/// The rows `branch, x, y` that the program prints for a curve.
fn printed_points(curve: &str, points: &str) -> Vec<[f64; 3]> {
    let folder = TempDir::new().unwrap();
    let path = written(&folder, "curve.json", curve);
    let output = run(&["curve", str(&path), "-n", points, "-o", "-"]);
    assert_done(&output);
    let text = String::from_utf8(output.stdout).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    assert_eq!(header, "branch,x,y");
    let row = |row: &str| {
        let numbers: Vec<f64> = row.split(',').map(|number| number.parse().unwrap()).collect();
        numbers.try_into().unwrap()
    };
    rows.lines().map(row).collect()
}

#[test]
fn points_satisfy_the_equation_of_their_curve() {
    type Function = fn(f64, f64) -> f64;
    let curves: [(&str, usize, Function); 4] = [
        (r#"{"curve": "superellipse", "size": [2, 3], "exponent": 0.5}"#, 200, |u, v| {
            u.powi(4) + v.powi(4)
        }),
        (r#"{"curve": "superhyperbola", "size": [2, 3], "exponent": 2}"#, 2 * 101, |u, v| {
            u.abs() - v.abs()
        }),
        (r#"{"curve": "lame", "size": [2, 3], "numerator": 3, "denominator": 1}"#, 151, |u, v| {
            u.powi(3) + v.powi(3)
        }),
        (r#"{"curve": "lame", "size": [2, 3], "numerator": -2, "denominator": 1}"#, 204, |u, v| {
            u.powi(-2) + v.powi(-2)
        }),
    ];
    for (curve, count, function) in curves {
        let rows = printed_points(curve, "200");
        assert_eq!(rows.len(), count, "{curve}");
        for [_, x, y] in rows {
            assert!((function(x / 2.0, y / 3.0) - 1.0).abs() < 1e-13, "{curve} {x} {y}");
        }
    }
}

#[test]
fn branches_are_numbered_and_end_at_the_clip() {
    let curve = r#"{"curve": "superhyperbola", "size": [2, 3], "exponent": 1, "clip": 4}"#;
    let rows = printed_points(curve, "40");
    let greatest = rows.iter().fold(0.0, |greatest: f64, [_, x, _]| greatest.max(*x));
    assert!((greatest - 8.0).abs() < 1e-12);
    for [branch, x, _] in rows {
        assert_eq!(branch, f64::from(u8::from(x < 0.0)));
    }
}

#[test]
fn a_drawing_is_a_closed_path() {
    let folder = TempDir::new().unwrap();
    let text = r#"{"curve": "superellipse", "size": [2, 1], "exponent": 0.5}"#;
    let [curve, drawing] = [written(&folder, "curve.json", text), folder.path().join("curve.svg")];
    assert_done(&run(&["curve", str(&curve), "-o", str(&drawing)]));
    let text = fs::read_to_string(drawing).unwrap();
    assert!(text.contains(r#"width="420.000" height="220.000""#), "{text}");
    assert_eq!((text.matches('M').count(), text.matches('L').count()), (1, 199));
    assert_eq!(text.matches("Z\"").count(), 1);
}

/// The vertices and the number of faces in an OBJ file.
fn read_obj(path: &Path) -> (Vec<Vector3<f64>>, usize) {
    let text = fs::read_to_string(path).unwrap();
    let vertex = |line: &str| {
        let numbers = line.split_whitespace().map(|number| number.parse().unwrap());
        Vector3::from_iterator(numbers)
    };
    let vertices = text.lines().filter_map(|line| line.strip_prefix("v ")).map(vertex).collect();
    (vertices, text.lines().filter(|line| line.starts_with("f ")).count())
}

#[test]
fn the_product_of_two_superellipses_is_the_superellipsoid() {
    let folder = TempDir::new().unwrap();
    let curve =
        |size, e| format!(r#"{{"curve": "superellipse", "size": {size}, "exponent": {e}}}"#);
    let north = written(&folder, "north.json", &curve("[1, 3]", 0.3));
    let east = written(&folder, "east.json", &curve("[1, 2]", 1.7));
    let mesh = folder.path().join("mesh.obj");
    let output = run(&["product", str(&north), str(&east), "--resolution", "8", "-o", str(&mesh)]);
    assert_done(&output);
    let (vertices, faces) = read_obj(&mesh);
    // Fifteen circles of 32 and two poles.
    assert_eq!((vertices.len(), faces), (15 * 32 + 2, 2 * 15 * 32));
    let solid = Superellipsoid::new([1.0, 2.0, 3.0], [0.3, 1.7]).unwrap();
    for x in vertices {
        assert!((solid.gauge(&x) - 1.0).abs() < 1e-13, "{x}");
    }
}

/// A file of the samples.
fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/curves").join(name)
}

#[test]
fn a_polyline_is_written_as_its_points_whatever_their_number_is_to_be() {
    let star = fs::read_to_string(sample("star.json")).unwrap();
    let rows = printed_points(&star, "200");
    assert_eq!((rows.len(), rows[0], rows[2]), (10, [0.0, 0.0, 1.0], [0.0, -0.951057, 0.309017]));
    let folder = TempDir::new().unwrap();
    let drawing = folder.path().join("star.svg");
    assert_done(&run(&["curve", str(&sample("star.json")), "-o", str(&drawing)]));
    let text = fs::read_to_string(drawing).unwrap();
    assert_eq!((text.matches('L').count(), text.matches("Z\"").count()), (9, 1));
}

/// B81 Fig. 1.
#[test]
fn an_ellipse_and_a_star_make_the_stars_of_all_heights() {
    let folder = TempDir::new().unwrap();
    let mesh = folder.path().join("mesh.obj");
    let [north, east] = ["ellipse.json", "star.json"].map(sample);
    let output = run(&["product", str(&north), str(&east), "--resolution", "8", "-o", str(&mesh)]);
    assert_done(&output);
    let (vertices, faces) = read_obj(&mesh);
    // Fifteen stars of ten corners and two poles.
    assert_eq!((vertices.len(), faces), (15 * 10 + 2, 2 * 15 * 10));
    for x in vertices {
        let scale = (1.0 - (x.z / 0.7).powi(2)).max(0.0).sqrt();
        let corner = x.xy().norm();
        let is_corner = [1.0, 0.4].iter().any(|radius| (corner - radius * scale).abs() < 1e-6);
        assert!(is_corner, "{x}");
    }
}

#[test]
fn polylines_without_points_enough_are_refused() {
    let folder = TempDir::new().unwrap();
    let points = |points: &str| {
        let text = format!(r#"{{"curve": "polyline", "points": {points}}}"#);
        let path = written(&folder, "line.json", &text);
        run(&["curve", str(&path), "-o", "-"])
    };
    assert_refused(&points("[[0, 1]]"), &["line.json: a polyline has from 2 to 10000 points"]);
    assert_refused(&points("[[0, 1], [0, 1]]"), &["line.json: points[0] must differ"]);
    assert_refused(&points(&format!("[{}[0, 1]]", "[1, 2],".repeat(10_000))), &["found 10001"]);
    assert_refused(&points("[[0, 1], [1e400, 1]]"), &["line.json"]);
}

#[test]
fn what_is_no_curve_or_no_format_is_refused_and_nothing_written() {
    let folder = TempDir::new().unwrap();
    let text = r#"{"curve": "superellipse", "size": [2, 1], "exponent": 0.5}"#;
    let good = written(&folder, "good.json", text);
    let bad = written(&folder, "bad.json", r#"{"curve": "cone", "size": [1, 1]}"#);
    let [csv, mesh, other] = ["out.csv", "out.ply", "out.txt"].map(|name| folder.path().join(name));
    assert_refused(&run(&["curve", str(&bad), "-o", str(&csv)]), &["`superhyperbola`"]);
    assert_refused(&run(&["curve", str(&good), "-o", str(&other)]), &["csv or svg"]);
    assert_refused(&run(&["curve", str(&good), "-n", "3", "-o", str(&csv)]), &["4..="]);
    assert_refused(&run(&["product", str(&good), str(&bad), "-o", str(&mesh)]), &["bad.json"]);
    assert_refused(&run(&["product", str(&good), str(&good), "-o", str(&other)]), &["stl"]);
    for path in [csv, mesh, other] {
        assert!(!path.exists());
    }
}
