//! The program as a user runs it, and what it writes.
#![allow(dead_code)] // each test file uses its own part

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use nalgebra::Vector3;
use tempfile::TempDir;

const POSE: &str = r#"{"euler_zyz": [0.3, 1.1, -0.8], "translation": [5, -3, 2]}"#;

/// A shape of every family in a pose, and the number of points in its rows of four steps.
pub fn documents() -> [(String, usize); 5] {
    let shapes = [
        (r#""family": "superellipsoid", "size": [2, 0.7, 1.3], "exponents": [0.4, 1.3]"#, 9 * 16),
        (
            r#""family": "superhyperboloid_one_sheet", "size": [2, 0.7, 1.3],
            "exponents": [0.4, 1.3], "clip": 2.2"#,
            9 * 16,
        ),
        (
            r#""family": "superhyperboloid_two_sheets", "size": [2, 0.7, 1.3],
            "exponents": [0.4, 1.3], "clip": 3.5"#,
            2 * 9 * 9,
        ),
        (
            r#""family": "supertoroid", "size": [2, 0.7, 1.3], "exponents": [0.4, 1.3],
            "ring": 1.6"#,
            16 * 16,
        ),
        (r#""family": "three_exponent", "size": [2, 0.7, 1.3], "exponents": [1.5, 2, 7]"#, 9 * 16),
    ];
    shapes.map(|(shape, points)| (format!(r#"{{"shape": {{{shape}}}, "pose": {POSE}}}"#), points))
}

/// A deformation.
pub const BENT: &str = r#"{"kind": "bend", "rate": 0.2, "center": 0, "range": [-1, 1]}"#;

/// The document of a shape at the origin.
pub fn plain(shape: &str) -> String {
    format!(r#"{{"shape": {{{shape}}}}}"#)
}

/// Runs the program.
pub fn run(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_superquadric"));
    command.args(arguments).output().expect("the program starts")
}

/// A file of a text in a folder.
pub fn written(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    fs::write(&path, text).expect("a file");
    path
}

/// A path as text.
pub fn str(path: &Path) -> &str {
    path.to_str().expect("a path of text")
}

/// Makes sure that the program ended well, without a word.
pub fn assert_done(output: &Output) {
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty());
}

/// Makes sure that the program has refused what it names.
pub fn assert_refused(output: &Output, names: &[&str]) {
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for name in names {
        assert!(message.contains(name), "{message:?} does not name {name:?}");
    }
}

/// A table as the program writes it.
pub struct Table {
    pub columns: Vec<String>,
    pub rows: Vec<Vec<f64>>,
}

impl Table {
    pub fn of(text: &str) -> Self {
        let mut lines = text.lines();
        let columns = lines.next().expect("a header").split(',').map(str::to_owned).collect();
        let row = |line: &str| line.split(',').map(|n| n.parse().expect("a number")).collect();
        let table = Self { columns, rows: lines.map(row).collect() };
        assert!(table.rows.iter().all(|row: &Vec<f64>| row.len() == table.columns.len()));
        table
    }

    pub fn column(&self, name: &str) -> Vec<f64> {
        let index = self.columns.iter().position(|column| column == name);
        let index = index.unwrap_or_else(|| panic!("{name} is none of {:?}", self.columns));
        self.rows.iter().map(|row| row[index]).collect()
    }

    pub fn vectors(&self, names: [&str; 3]) -> Vec<Vector3<f64>> {
        let [x, y, z] = names.map(|name| self.column(name));
        x.into_iter().zip(y).zip(z).map(|((x, y), z)| Vector3::new(x, y, z)).collect()
    }
}

/// The table that the program prints.
pub fn printed(arguments: &[&str]) -> Table {
    let output = run(&[arguments, &["-o", "-"]].concat());
    assert_done(&output);
    Table::of(&String::from_utf8(output.stdout).unwrap())
}

/// Whether there are numbers, and all near another.
pub fn is_all_near(values: &[f64], expected: f64, slack: f64) -> bool {
    !values.is_empty() && values.iter().all(|value| (value - expected).abs() < slack)
}
