//! Where along a face the lattice lines run, so that edges are resolved and flats are not.

use std::f64::consts::FRAC_PI_4;

use crate::shape::superellipse_norm;

/// Steps of the table from which the lines are read off.
const TABLE_STEPS: usize = 512;

/// By what measure, of arc length s and turning angle theta along a unit superellipse, lattice
/// lines are equally far apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Grading {
    /// `min(ds + dtheta, 4 ds)`: equal angles for exponent 1, equal distances (Pilu and Fisher
    /// 1995) where the curve is straight, and closer where it turns.
    Even,
    /// `sqrt(ds dtheta)`, that is the root of the curvature over the length, so that chords stay
    /// equally near to the curve: B81's sampling by curvature. It is kept from ds to 6 ds, so that
    /// flats are crossed too.
    Curvature,
}

impl Grading {
    /// The measure of a chord and its turn.
    fn measure(self, length: f64, turn: f64) -> f64 {
        match self {
            Self::Even => (length + turn).min(4.0 * length),
            Self::Curvature => (length * turn).sqrt().clamp(length, 6.0 * length),
        }
    }
}

/// Positions in [-1, 1] of the `n + 1` lattice lines of a face, `n` even: symmetric, with lines
/// at -1, 0 and 1.
///
/// Lines are equally far apart in the grading's measure along the unit superellipses of
/// `exponents`, added.
pub(super) fn lattice_lines(n: usize, exponents: &[f64], grading: Grading) -> Vec<f64> {
    let measure = cumulative_measure(exponents, grading);
    let half = n / 2;
    let outwards: Vec<f64> =
        (0..=half).map(|i| inverse(&measure, i as f64 / half as f64)).collect();
    let inwards = outwards.iter().skip(1).rev().map(|t| -t);
    inwards.chain(outwards.iter().copied()).collect()
}

/// Positions in `[-top, top]` of the `n + 1` lines, `n` even, across an even profile `radius(w)`,
/// by the grading's measure along it.
pub(super) fn profile_lines(
    n: usize,
    top: f64,
    radius: impl Fn(f64) -> f64,
    grading: Grading,
) -> Vec<f64> {
    let place = |i: usize| top * i as f64 / TABLE_STEPS as f64;
    let mut measure = vec![0.0; TABLE_STEPS + 1];
    let mut last_angle = 0.0;
    for i in 1..=TABLE_STEPS {
        let [low, high] = [place(i - 1), place(i)];
        let rise = radius(high) - radius(low);
        let (length, angle) = (rise.hypot(high - low), rise.atan2(high - low));
        let turn = if i == 1 { 0.0 } else { (angle - last_angle).abs() };
        measure[i] = measure[i - 1] + grading.measure(length, turn);
        last_angle = angle;
    }
    let half = n / 2;
    let line = |i: usize| top * inverse(&measure, i as f64 / half as f64);
    let upwards: Vec<f64> = (0..=half).map(line).collect();
    let downwards = upwards.iter().skip(1).rev().map(|w| -w);
    downwards.chain(upwards.iter().copied()).collect()
}

/// The measure from slope `t = y/x = 0` on, at equal steps of t up to the diagonal `t = 1`.
fn cumulative_measure(exponents: &[f64], grading: Grading) -> Vec<f64> {
    let mut measure = vec![0.0; TABLE_STEPS + 1];
    for &e in exponents {
        let (mut last, mut sum) = (OctantPoint::at(0.0, e), 0.0);
        for (i, entry) in measure.iter_mut().enumerate().skip(1) {
            let next = OctantPoint::at(i as f64 / TABLE_STEPS as f64, e);
            let length = (next.x - last.x).hypot(next.y - last.y);
            let turn = (next.normal_angle - last.normal_angle).abs();
            sum += grading.measure(length, turn);
            *entry += sum;
            last = next;
        }
    }
    measure
}

/// The slope at which the table has reached `share` of its last entry.
fn inverse(table: &[f64], share: f64) -> f64 {
    let steps = table.len() - 1;
    let wanted = share * table[steps];
    let after = table.partition_point(|&entry| entry < wanted).clamp(1, steps);
    let (low, high) = (table[after - 1], table[after]);
    ((after - 1) as f64 + (wanted - low) / (high - low)) / steps as f64
}

/// A point of the unit superellipse `x^(2/e) + y^(2/e) = 1` between the x axis and the diagonal.
struct OctantPoint {
    x: f64,
    y: f64,
    /// Angle of the normal from the x axis.
    normal_angle: f64,
}

impl OctantPoint {
    /// The point of slope `t = y/x` in [0, 1]; its normal has slope `t^(2/e - 1)`.
    fn at(t: f64, e: f64) -> Self {
        let x = 1.0 / superellipse_norm(1.0, t, e);
        let normal_angle = if e == 2.0 { FRAC_PI_4 } else { t.powf(2.0 / e - 1.0).atan() };
        Self { x, y: t * x, normal_angle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_a_circle_are_at_equal_angles() {
        for grading in [Grading::Even, Grading::Curvature] {
            for (i, t) in lattice_lines(16, &[1.0], grading).iter().enumerate() {
                let angle = (i as f64 / 8.0 - 1.0) * FRAC_PI_4;
                // The table's chords fall short of arcs by (1/512)^2 / 24.
                assert!((t - angle.tan()).abs() < 1e-6, "{i}");
            }
        }
    }

    #[test]
    fn lines_of_straight_sides_are_equally_far_apart() {
        for (i, t) in lattice_lines(8, &[2.0], Grading::Even).iter().enumerate() {
            let along = i as f64 / 4.0 - 1.0;
            // On |x| + |y| = 1, equal steps of y = t / (1 + t).
            assert!((t / (1.0 + t.abs()) - 0.5 * along).abs() < 1e-6, "{i}: {t}");
        }
    }

    #[test]
    fn lines_ascend_symmetrically_and_crowd_at_most_as_stated() {
        let exponents = [0.05, 0.1, 0.5, 1.0, 1.5, 1.9, 2.0];
        for (e, e1) in exponents.into_iter().flat_map(|e| [(e, e), (e, 1.0), (e, 0.05)]) {
            for (grading, crowding) in [(Grading::Even, 4.0), (Grading::Curvature, 6.0)] {
                let lines = lattice_lines(32, &[e, e1], grading);
                assert_eq!((lines[0], lines[16], lines[32]), (-1.0, 0.0, 1.0));
                assert!((0..=16).all(|i| lines[i] == -lines[32 - i]));
                let steps: Vec<f64> = lines.windows(2).map(|pair| pair[1] - pair[0]).collect();
                let least = steps.iter().copied().fold(f64::INFINITY, f64::min);
                let greatest = steps.iter().copied().fold(0.0, f64::max);
                // Length per slope itself varies, at most fourfold: on |x| + |y| = 1.
                assert!(least > 0.0 && greatest / least < 4.0 * crowding, "{e} {e1}");
            }
        }
    }
}
