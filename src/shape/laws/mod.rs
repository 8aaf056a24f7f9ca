//! The laws that every family keeps, over exponents and degenerate positions.

mod differential;
mod masses;
mod positions;

use super::{
    Parametric, Shape, Solid, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets,
    Supertoroid, ThreeExponent,
};

/// Exponents from almost square to pinched.
const EXPONENTS: [f64; 6] = [0.1, 0.5, 1.0, 1.5, 2.0, 2.6];

const SIZE: [f64; 3] = [2.0, 0.7, 1.3];

/// Of aspect 1:100.
const THIN: [f64; 3] = [0.3, 0.01, 1.0];

/// A shape to try a law on.
#[derive(Debug, Clone, Copy)]
struct Example {
    shape: Shape,
    /// The exponents that it was made of, in B81's sense.
    exponents: [f64; 2],
    least_size: f64,
}

impl Example {
    /// Whether no exponent exceeds this one.
    fn is_at_most(&self, exponent: f64) -> bool {
        self.exponents.iter().all(|&e| e <= exponent)
    }
}

/// Every family at a pair of exponents.
fn families(size: [f64; 3], [e1, e2]: [f64; 2]) -> [Example; 5] {
    let n = [2.0 / e1, 2.0 / e2, 1.0 / e1 + 1.0 / e2];
    let shapes: [Shape; 5] = [
        Superellipsoid::new(size, [e1, e2]).unwrap().into(),
        SuperhyperboloidOneSheet::new(size, [e1, e2], 1.7 * size[2]).unwrap().into(),
        SuperhyperboloidTwoSheets::new(size, [e1, e2], 1.75 * size[0]).unwrap().into(),
        Supertoroid::new(size, [e1, e2], 1.6).unwrap().into(),
        ThreeExponent::new(size, n).unwrap().into(),
    ];
    let least_size = size.into_iter().fold(f64::INFINITY, f64::min);
    shapes.map(|shape| Example { shape, exponents: [e1, e2], least_size })
}

/// Every family at every pair of exponents, thick and thin.
fn examples() -> impl Iterator<Item = Example> {
    let pairs = || EXPONENTS.into_iter().flat_map(|e1| EXPONENTS.map(|e2| [e1, e2]));
    [SIZE, THIN].into_iter().flat_map(move |size| pairs().flat_map(move |e| families(size, e)))
}

/// Tries a law on every example, and refuses to pass unless it held for `least` cases of every
/// family; the law tells how many cases it has tried.
fn try_on_all(least: usize, law: impl Fn(&Example) -> usize) {
    let mut counts = [(); 5].map(|()| ("", 0));
    for (i, example) in examples().enumerate() {
        let (family, count) = &mut counts[i % 5];
        *family = example.shape.family();
        *count += law(&example);
    }
    assert!(counts.iter().all(|&(_, count)| count >= least), "too few cases: {counts:?}");
}

/// Shares of the natural ranges: ends, middle and quarters, where axes and planes of symmetry
/// are, and others.
const SHARES: [f64; 9] = [0.0, 0.11, 0.25, 0.37, 0.5, 0.62, 0.75, 0.93, 1.0];

/// Latitudes and longitudes of a shape's domain, on both sheets where there are two.
fn angles(shape: &Shape) -> Vec<[f64; 2]> {
    let [[south, north], [west, east]] = shape.domain();
    let sheets = match shape {
        Shape::SuperhyperboloidTwoSheets(_) => vec![0.0, std::f64::consts::PI],
        _ => vec![0.0],
    };
    let mut angles = Vec::new();
    for turn in sheets {
        for across in SHARES {
            let eta = south + across * (north - south);
            angles.extend(SHARES.map(|along| [eta, turn + west + along * (east - west)]));
        }
    }
    angles
}

/// Those off the planes of symmetry, where every function is smooth.
fn smooth_angles(shape: &Shape) -> Vec<[f64; 2]> {
    let is_smooth = |angle: f64| (2.0 * angle).sin().abs() > 0.1;
    angles(shape).into_iter().filter(|angles| angles.iter().all(|&t| is_smooth(t))).collect()
}

#[test]
#[should_panic(expected = "too few cases")]
fn a_law_without_cases_does_not_pass() {
    try_on_all(1, |_| 0);
}
