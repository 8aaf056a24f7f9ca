//! How much of two solids is common to both.

use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use super::RelativePose;
use super::low_discrepancy::ShiftedKronecker;
use crate::model::Model;

/// Independently shifted copies of the point sequence, from whose scatter the error is known.
const REPLICATES: usize = 16;

/// Intersection over union of two solids.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeOverlap {
    /// Volume of the intersection over that of the union, in [0, 1].
    pub iou: f64,
    /// Standard error of `iou`.
    pub standard_error: f64,
}

/// The volume common to two models over the volume of their union; the same for the same seed.
///
/// `iou = I / (Va + Vb - I)` with the closed-form volumes (JLS Eq. 2.59), and with `I` the
/// smaller volume times the share of that solid's points that lie in the other: exactly 1 for
/// one solid in two descriptions up to rounding, exactly 0 for disjoint solids. The share is
/// taken over `samples` points of a low-discrepancy sequence in the smaller solid's bounding
/// box; 50 000 leave a standard error below 1e-3, which falls a little faster than the square
/// root of their number. Domain: exponents up to 2, for which that box is at most six times the
/// solid.
pub fn volume_overlap(a: &Model, b: &Model, samples: usize, seed: u64) -> VolumeOverlap {
    let (inner, outer) = if a.shape.volume() <= b.shape.volume() { (a, b) } else { (b, a) };
    let count = samples.div_ceil(REPLICATES).max(1);
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let sequences: Vec<ShiftedKronecker> =
        (0..REPLICATES).map(|_| ShiftedKronecker::new(&mut rng)).collect();
    let hits: Vec<Hits> = sequences
        .into_par_iter()
        .map(|sequence| Hits::count(inner, outer, sequence, count))
        .collect();

    let iou_of = |hits: Hits| iou(inner.shape.volume(), outer.shape.volume(), hits.share());
    let total = hits.iter().fold(Hits::default(), |sum, hits| sum.plus(hits));
    let single: Vec<f64> = hits.into_iter().map(iou_of).collect();
    VolumeOverlap { iou: iou_of(total), standard_error: standard_error(&single) }
}

/// Intersection over union of solids of two volumes, if `share` of the first lies in the second.
fn iou(inner: f64, outer: f64, share: f64) -> f64 {
    let intersection = inner * share;
    intersection / (inner + outer - intersection)
}

/// Standard error of the mean of independent estimates.
fn standard_error(estimates: &[f64]) -> f64 {
    let count = estimates.len() as f64;
    let mean = estimates.iter().sum::<f64>() / count;
    let squares: f64 = estimates.iter().map(|estimate| (estimate - mean).powi(2)).sum();
    (squares / (count * (count - 1.0))).sqrt()
}

/// How many points lay in the inner solid, and of these in the outer one.
#[derive(Debug, Clone, Copy, Default)]
struct Hits {
    inner: usize,
    both: usize,
}

impl Hits {
    fn count(inner: &Model, outer: &Model, mut sequence: ShiftedKronecker, count: usize) -> Self {
        let outer_from_inner = RelativePose::new(outer, inner);
        let size = inner.shape.size();
        let mut hits = Self::default();
        for _ in 0..count {
            let unit = sequence.draw();
            let x = Vector3::from_fn(|i, _| (2.0 * unit[i] - 1.0) * size[i]);
            if inner.shape.gauge(&x) <= 1.0 {
                hits.inner += 1;
                hits.both += usize::from(outer.shape.gauge(&outer_from_inner.apply(&x)) <= 1.0);
            }
        }
        hits
    }

    fn plus(self, other: &Self) -> Self {
        Self { inner: self.inner + other.inner, both: self.both + other.both }
    }

    fn share(self) -> f64 {
        self.both as f64 / self.inner.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::shape::Superellipsoid;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    const SAMPLES: usize = 20_000;

    fn model(size: [f64; 3], exponents: [f64; 2], angles: [f64; 3], p: [f64; 3]) -> Model {
        Model {
            shape: Superellipsoid::new(size, exponents).unwrap(),
            pose: Pose::from_euler_zyz(angles, Vector3::from(p)),
        }
    }

    /// Asserts that the overlap is as stated, and the error it claims small.
    fn assert_overlap(a: &Model, b: &Model, expected: f64) {
        let VolumeOverlap { iou, standard_error } = volume_overlap(a, b, SAMPLES, 3);
        // Five standard errors of 16 replicates.
        assert!((iou - expected).abs() <= 5.0 * standard_error + 1e-14, "{iou} {expected}");
        assert!(standard_error < 2e-3, "{standard_error}");
    }

    #[test]
    fn equivalent_descriptions_overlap_entirely() {
        for unit in [1e-6, 1.0, 1e6] {
            let size = [2.0 * unit, unit, 0.03 * unit];
            let at = [3e3 * unit, -2e3 * unit, 1e3 * unit];
            let a = model(size, [0.2, 1.4], [0.3, 1.1, -0.8], at);
            let swapped = [size[1], size[0], size[2]];
            for b in [
                a,
                model(swapped, [0.2, 1.4], [0.3, 1.1, -0.8 + FRAC_PI_2], at),
                model(size, [0.2, 1.4], [0.3, 1.1, -0.8 + PI], at),
                model(size, [0.2, 1.4], [0.3 + PI, PI - 1.1, 0.8], at),
            ] {
                // Rounding displaces the solids by 1e-12 of their size; no sample is that near.
                let overlap = volume_overlap(&a, &b, SAMPLES, 3);
                assert!((overlap.iou - 1.0).abs() < 1e-14, "{overlap:?}");
                assert!(overlap.standard_error < 1e-14);
            }
        }
    }

    #[test]
    fn concentric_copies_overlap_by_their_volumes() {
        let a = model([2.0, 1.0, 0.5], [0.4, 1.3], [0.3, 1.1, -0.8], [4.0, -2.0, 7.0]);
        for factor in [0.97, 0.5, 1.03] {
            let b = Model { shape: a.shape.with_size([2.0, 1.0, 0.5].map(|s| s * factor)), ..a };
            let expected = f64::min(factor, 1.0 / factor).powi(3);
            let overlap = volume_overlap(&a, &b, SAMPLES, 3);
            // The smaller lies wholly in the larger; only the closed-form volumes remain.
            assert!((overlap.iou - expected).abs() < 1e-14, "{overlap:?}");
        }
    }

    #[test]
    fn shifted_and_turned_boxes_overlap_by_closed_forms() {
        // Exponent 1e-3 leaves a box up to corners of 3e-4 of its size.
        let exponents = [1e-3, 1e-3];
        let fixed = model([1.0, 2.0, 3.0], exponents, [0.0; 3], [0.0; 3]);
        let shifted = model([1.0, 2.0, 3.0], exponents, [0.0; 3], [0.5, -1.0, 0.3]);
        let share = 0.75 * 0.75 * 0.95;
        assert_overlap(&fixed, &shifted, share / (2.0 - share));

        let square = model([1.0, 1.0, 5.0], exponents, [0.0; 3], [0.0; 3]);
        let turned = model([1.0, 1.0, 5.0], exponents, [0.0, 0.0, FRAC_PI_4], [0.0; 3]);
        // Two squares at 45 degrees have an octagon of 8 (sqrt(2) - 1) of 4 in common.
        let share = 2.0 * (2.0_f64.sqrt() - 1.0);
        assert_overlap(&square, &turned, share / (2.0 - share));
    }

    #[test]
    fn a_shifted_ball_overlaps_by_the_lens() {
        let a = model([1.0; 3], [1.0, 1.0], [0.0; 3], [1e6; 3]);
        let b = model([1.0; 3], [1.0, 1.0], [0.0; 3], [1e6 + 0.5, 1e6, 1e6]);
        // Lens of two unit balls at distance d: pi (4 + d) (2 - d)^2 / 12.
        let share = (4.0 + 0.5) * 1.5 * 1.5 / 16.0;
        assert_overlap(&a, &b, share / (2.0 - share));
    }

    #[test]
    fn disjoint_solids_do_not_overlap_and_a_wrong_rotation_is_seen() {
        let a = model([3.0, 1.0, 0.2], [0.3, 0.3], [0.0; 3], [0.0; 3]);
        let far = model([3.0, 1.0, 0.2], [0.3, 0.3], [0.0; 3], [0.0, 0.0, 0.41]);
        let overlap = volume_overlap(&a, &far, SAMPLES, 3);
        assert_eq!((overlap.iou, overlap.standard_error), (0.0, 0.0));

        let turned = model([3.0, 1.0, 0.2], [0.3, 0.3], [FRAC_PI_2, 0.0, 0.0], [0.0; 3]);
        // A cross: 2 x 2 of 6 x 2, or less as the corners are round.
        assert!(volume_overlap(&a, &turned, SAMPLES, 3).iou < 1.0 / 4.5);
    }

    #[test]
    fn stated_errors_are_those_made() {
        let a = model([2.0, 1.0, 0.5], [0.4, 1.3], [0.3, 1.1, -0.8], [0.0; 3]);
        let b = model([1.8, 1.1, 0.6], [0.8, 1.0], [0.2, 1.2, -0.8], [0.2, 0.1, 0.0]);
        let best = volume_overlap(&a, &b, 1_000_000, 0).iou;
        let normalized: f64 = (1..=20)
            .map(|seed| {
                let overlap = volume_overlap(&a, &b, 2_000, seed);
                ((overlap.iou - best) / overlap.standard_error).powi(2)
            })
            .sum();
        // Mean square of 20 Student variables of 15 degrees: 1.15, standard error 0.4.
        assert!((0.3..3.2).contains(&(normalized / 20.0)), "{normalized}");
    }
}
