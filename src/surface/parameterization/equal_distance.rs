//! Equal steps along the curve.

use crate::shape::{greatest_arc_parameter, quarter_point};

/// Chords of the table from which places along the curve are read: the steps are then equal to
/// 1e-4 or so.
const TABLE_STEPS: usize = 4096;

/// Points from `(a, 0)` to `(0, b)`.
pub(super) fn quarter([a, b]: [f64; 2], e: f64, n: usize) -> Vec<[f64; 2]> {
    let lengths = chord_lengths([a, b], e);
    let total = lengths[TABLE_STEPS];
    let point = |i: usize| {
        let [x, y] = quarter_point(e, parameter(e, inverse(&lengths, total * i as f64 / n as f64)));
        [a * x, b * y]
    };
    let inner = (1..n).map(point);
    std::iter::once([a, 0.0]).chain(inner).chain(std::iter::once([0.0, b])).collect()
}

/// The arc's parameter at a share of the table.
fn parameter(e: f64, share: f64) -> f64 {
    (2.0 * share - 1.0) * greatest_arc_parameter(e)
}

/// Length of the curve from the x axis to each entry.
fn chord_lengths([a, b]: [f64; 2], e: f64) -> Vec<f64> {
    let mut last = [1.0, 0.0];
    let mut length = 0.0;
    let lengths = (0..=TABLE_STEPS).map(|i| {
        let next = quarter_point(e, parameter(e, i as f64 / TABLE_STEPS as f64));
        length += (a * (next[0] - last[0])).hypot(b * (next[1] - last[1]));
        last = next;
        length
    });
    lengths.collect()
}

/// The share of the table's steps at which its ascending entries reach a value.
fn inverse(table: &[f64], wanted: f64) -> f64 {
    let steps = table.len() - 1;
    let after = table.partition_point(|&entry| entry < wanted).clamp(1, steps);
    let (low, high) = (table[after - 1], table[after]);
    let within = if high > low { (wanted - low) / (high - low) } else { 0.0 };
    ((after - 1) as f64 + within) / steps as f64
}
