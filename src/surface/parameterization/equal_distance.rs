//! Equal steps along the curve.

use crate::shape::{greatest_arc_parameter, quarter_point};

/// Chords of the table from which places along the curve are read: the steps are then equal to
/// 1e-4 or so.
const TABLE_STEPS: usize = 4096;

/// Points from `(a, 0)` to `(0, b)` along `(x/a)^(2/e1) + (y/b)^(2/e2) = 1`.
pub(super) fn quarter([a, b]: [f64; 2], [e1, e2]: [f64; 2], n: usize) -> Vec<[f64; 2]> {
    if n == 0 {
        return vec![[a, 0.0]];
    }
    // One coordinate each of two superellipses, at the same share of the powers.
    let greatest = greatest_arc_parameter(e1.min(e2));
    let point = |share: f64| {
        let [[x, _], [_, y]] = [e1, e2].map(|e| quarter_point(e, (2.0 * share - 1.0) * greatest));
        [a * x, b * y]
    };
    let inner = evenly_spread(point, TABLE_STEPS, n).map(point);
    std::iter::once([a, 0.0]).chain(inner).chain(std::iter::once([0.0, b])).collect()
}

/// The `n - 1` shares of a curve's parameter that cut it into `n` parts of equal length, as far as
/// so many chords tell.
pub(super) fn evenly_spread(
    point: impl Fn(f64) -> [f64; 2],
    chords: usize,
    n: usize,
) -> impl Iterator<Item = f64> {
    let lengths = chord_lengths(point, chords);
    (1..n).map(move |i| inverse(&lengths, lengths[chords] * i as f64 / n as f64))
}

/// Length of the curve from its beginning to each entry.
fn chord_lengths(point: impl Fn(f64) -> [f64; 2], chords: usize) -> Vec<f64> {
    let (mut last, mut length) = (point(0.0), 0.0);
    let lengths = (0..=chords).map(|i| {
        let next = point(i as f64 / chords as f64);
        length += (next[0] - last[0]).hypot(next[1] - last[1]);
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
