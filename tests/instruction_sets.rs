//! The instruction set that the environment names: fits agree, whichever it is.

use std::process::{Command, Output};

use serde_json::Value;
use superquadric::machine::InstructionSet;

const SAMPLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/samples/one_sided_view.ply");

fn fit_by(set: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_superquadric"))
        .args(["fit", SAMPLE, "-o", "-"])
        .env("SUPERQUADRIC_SIMD", set)
        .output()
        .expect("the program starts")
}

/// Sizes and exponents, in the canonical order, of the fit by one set.
fn parameters(set: InstructionSet) -> Vec<f64> {
    let output = fit_by(set.name());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let fit: Value = serde_json::from_slice(&output.stdout).expect("a document");
    let shape = &fit["model"]["shape"];
    let numbers = |name: &str| shape[name].as_array().expect("numbers").clone();
    let numbers = numbers("size").into_iter().chain(numbers("exponents"));
    numbers.map(|number| number.as_f64().expect("a number")).collect()
}

#[test]
fn fits_agree_whichever_set_is_in_use() {
    let portable = parameters(InstructionSet::Portable);
    assert_eq!(portable.len(), 5);
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        for (other, expected) in parameters(set).iter().zip(&portable) {
            // Descents end when the cost has settled to 1e-8.
            assert!((other / expected - 1.0).abs() < 1e-4, "{}: {other} {expected}", set.name());
        }
    }
}

#[test]
fn a_set_that_is_not_to_be_had_is_refused() {
    let output = fit_by("mmx");
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("SUPERQUADRIC_SIMD is \"mmx\"; expected portable, avx2 or avx512"));
}
