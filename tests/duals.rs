//! Duals, by the program as a user runs it.

#[path = "common/program.rs"]
mod program;

use std::path::Path;

use program::{
    BENT, assert_done, assert_refused, documents, is_all_near, plain, printed, run, str, written,
};
use serde_json::{Value, json};
use tempfile::TempDir;

fn dual(model: &Path) -> Value {
    let output = run(&["dual", str(model)]);
    assert_done(&output);
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// Whether two documents are the same but for rounding.
fn is_same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let [a, b] = [a, b].map(|number| number.as_f64().unwrap());
            (a - b).abs() <= 1e-13 * a.abs().max(1.0)
        }
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
        }
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| is_same(a, b)))
        }
        _ => a == b,
    }
}

#[test]
fn the_dual_of_the_dual_is_the_model_at_the_origin() {
    let folder = TempDir::new().unwrap();
    for (model, _) in documents() {
        let path = written(&folder, "model.json", &model);
        let first = dual(&path);
        let again = dual(&written(&folder, "dual.json", &first.to_string()));
        let model: Value = serde_json::from_str(&model).unwrap();
        assert_eq!(first["pose"]["translation"], json!([0.0, 0.0, 0.0]));
        assert!(is_same(&again["pose"]["euler_zyz"], &model["pose"]["euler_zyz"]));
        let (again, shape) = (&again["shape"], &model["shape"]);
        match shape["family"].as_str().unwrap() {
            "supertoroid" => {
                assert_eq!(first["shape"]["family"], "superellipsoid");
                assert!(is_same(&again["size"], &shape["size"]));
            }
            "three_exponent" => assert!(is_same(&again["exponents"], &shape["exponents"])),
            _ => assert!(is_same(again, shape), "{again} {shape}"),
        }
    }
}

#[test]
fn normals_lie_on_the_dual() {
    let folder = TempDir::new().unwrap();
    let model = written(&folder, "model.json", &documents()[0].0);
    let points = folder.path().join("points.csv");
    assert_done(&run(&["sample", str(&model), "--by", "trigonometric", "-o", str(&points)]));
    let evaluation = printed(&["evaluate", str(&model), str(&points)]);
    // Gradients of F are 2/e1 times B81's normals.
    let normals = evaluation.vectors(["gradient_x", "gradient_y", "gradient_z"]);
    let lines = normals.into_iter().map(|n| n * 0.2);
    let lines: String = lines.map(|x| format!("{} {} {}\n", x.x, x.y, x.z)).collect();
    let points = written(&folder, "normals.xyz", &lines);
    let path = folder.path().join("dual.json");
    assert_done(&run(&["dual", str(&model), "-o", str(&path)]));
    let on_dual = printed(&["evaluate", str(&path), str(&points)]).column("inside_outside");
    assert!(is_all_near(&on_dual, 1.0, 1e-6), "{on_dual:?}");
}

#[test]
fn models_without_a_dual_are_refused_by_name_and_nothing_written() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out.json");
    let shape = r#""family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 2.5]"#;
    let spiky = written(&folder, "spiky.json", &plain(shape));
    let shape = r#""family": "three_exponent", "size": [1, 1, 1], "exponents": [1, 2, 2]"#;
    let pointed = written(&folder, "pointed.json", &plain(shape));
    let pair = format!(r#"{{"union": [{0}, {0}]}}"#, documents()[0].0);
    let pair = written(&folder, "pair.json", &pair);
    let bent = documents()[0].0.replacen('{', &format!(r#"{{"deformations": [{BENT}], "#), 1);
    let bent = written(&folder, "bent.json", &bent);
    let dual = |model: &Path| run(&["dual", str(model), "-o", str(&out)]);
    assert_refused(&dual(&spiky), &["spiky.json", "no dual", "exponents[1]"]);
    assert_refused(&dual(&pointed), &["pointed.json", "no dual", "exponents[0]"]);
    assert_refused(&dual(&bent), &["bent.json", "deformations"]);
    assert_refused(&dual(&pair), &["pair.json"]);
    assert!(!out.exists());
}
