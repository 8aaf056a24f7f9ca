//! The area seen against the area of the shape.
//!
//! Of a convex solid with a centre of symmetry a distant camera sees half of the surface, as of
//! each pair of opposite pieces one faces it. A model with much more than twice the area on which
//! the points lie is doubtful: where noise leaves the depth of a single view open, the points
//! alone would take a giant for it.

use std::f64::consts::PI;

use crate::model::Model;
use crate::recover::kernel::Gram;
use crate::recover::neighbours::NEIGHBOUR;
use crate::recover::normalization::Normalization;
use crate::recover::radial::PARAMETERS;
use crate::shape::Superellipsoid;

/// Area of a shape over that seen which is no reason for doubt: well below 2, since noise by itself
/// makes the likelihood prefer what is larger than the truth.
const USUAL_RATIO: f64 = 1.3;

/// Deviation of the logarithm of the ratio beyond that.
const DEVIATION: f64 = 0.1;

/// What noise adds to the area, measured against the first order; and what it leaves at least.
const NOISE_SHARE: f64 = 0.85;
const LEAST_SHARE: f64 = 1.0 / 3.0;

/// The area on which the points lie, in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SeenArea {
    /// As the points' neighbours have it.
    pub area: f64,
    /// The number of these points.
    pub points: f64,
}

impl SeenArea {
    /// In the coordinates of another normalisation of the same cloud.
    pub fn renormalized(&self, from: &Normalization, to: &Normalization) -> Self {
        let ratio = from.radius * to.inverse_radius;
        Self { area: self.area * ratio * ratio, ..*self }
    }

    /// The area of a shape over that seen, where the points' distances have a variance.
    pub fn ratio(&self, shape: &Superellipsoid, variance: f64) -> f64 {
        approximate_area(shape).0 / self.without_noise(variance)
    }

    /// The area without what noise adds to it: neighbours that are off the surface by so much are
    /// farther by `2 s^2` in the square.
    fn without_noise(&self, variance: f64) -> f64 {
        let room = 2.0 * PI / NEIGHBOUR as f64 * variance * self.points;
        (self.area - NOISE_SHARE * room).max(LEAST_SHARE * self.area)
    }

    /// Multiplies the cost C of n points to `C (1 + r^2 / n)`, r being the model's excess area in
    /// deviations: as -2 log likelihood is `n ln C + r^2`, whatever the noise.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        let (area, log_gradient) = approximate_area(&model.shape);
        let seen = self.without_noise(gram.geometric_squares / weight);
        let excess = (area / (USUAL_RATIO * seen)).ln() / DEVIATION;
        if excess <= 0.0 {
            return;
        }
        let share = excess * excess / weight;
        let unexplained = share * gram.geometric_squares;
        let root = (gram.residual_squares() / weight).sqrt();
        let (mut of_factor, mut of_excess) = ([0.0; PARAMETERS], [0.0; PARAMETERS]);
        for (k, log_slope) in log_gradient.into_iter().enumerate() {
            of_factor[k] = 2.0 * excess / DEVIATION * log_slope / (weight * (1.0 + share));
            of_excess[k] = root / DEVIATION * log_slope;
        }
        gram.multiply_cost(1.0 + share, &of_factor);
        gram.add_curvature(&of_excess);
        gram.evidence_squares += unexplained;
    }
}

/// The area to some percent, and the derivatives of its logarithm by `ln a1, ln a2, ln a3, e1, e2`.
///
/// `A = 8 c (w (a1 a2)^p + (a1 a3)^p + (a2 a3)^p)^(1/p)`, a box's with `p = c = w = 1`, nearly an
/// ellipsoid's (K. Thomsen) with `p = 1.6`, an octahedron's with `p = 2`; `p - 1`, `ln c` and `ln w`
/// are quadratic in the exponents, fitted to the areas of 1,500 fine meshes of aspect up to 1:30:
/// standard error 1.5 %, at an aspect up to 1:4 1 %.
fn approximate_area(shape: &Superellipsoid) -> (f64, [f64; 5]) {
    let [a1, a2, a3] = shape.size();
    let exponents = shape.exponents();
    let (p, p_slopes) = quadratic(&[0.117, 0.193, 0.121, 0.057, 0.004], exponents);
    let (log_c, c_slopes) = quadratic(&[-0.152, -0.062, -0.048, 0.05, -0.059], exponents);
    let (log_w, w_slopes) = quadratic(&[-0.315, 0.28, 0.372, -0.301, -0.045], exponents);
    let p = 1.0 + p;

    let log_faces = [(a1 * a2).ln(), (a1 * a3).ln(), (a2 * a3).ln()];
    let logs = [log_w + p * log_faces[0], p * log_faces[1], p * log_faces[2]];
    let greatest = logs.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let powers = logs.map(|log| (log - greatest).exp());
    let sum: f64 = powers.iter().sum();
    let log_sum = greatest + sum.ln();
    let shares = powers.map(|power| power / sum);

    let mean_log_face: f64 = shares.iter().zip(log_faces).map(|(share, log)| share * log).sum();
    let by_p = (mean_log_face - log_sum / p) / p;
    let by_exponent = |k: usize| c_slopes[k] + by_p * p_slopes[k] + shares[0] / p * w_slopes[k];
    let log_gradient = [
        shares[0] + shares[1],
        shares[0] + shares[2],
        shares[1] + shares[2],
        by_exponent(0),
        by_exponent(1),
    ];
    (8.0 * (log_c + log_sum / p).exp(), log_gradient)
}

/// `q1 e1 + q2 e2 + q3 e1^2 + q4 e2^2 + q5 e1 e2` and its derivatives.
fn quadratic(q: &[f64; 5], [e1, e2]: [f64; 2]) -> (f64, [f64; 2]) {
    let value = q[0] * e1 + q[1] * e2 + q[2] * e1 * e1 + q[3] * e2 * e2 + q[4] * e1 * e2;
    (value, [q[0] + 2.0 * q[2] * e1 + q[4] * e2, q[1] + 2.0 * q[3] * e2 + q[4] * e1])
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::pose::Pose;
    use nalgebra::Vector3;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use crate::recover::clutter::seen_area as measured_area;
    use crate::recover::neighbours::{Neighbourhood, neighbourhoods};
    use crate::surface::{Resolution, sample_surface, tessellate};

    fn area(size: [f64; 3], e: [f64; 2]) -> f64 {
        approximate_area(&Superellipsoid::new(size, e).unwrap()).0
    }

    #[test]
    fn areas_are_those_of_meshes() {
        let resolution = Resolution::new(64).unwrap();
        for size in [[1.0; 3], [1.0, 2.0, 4.0], [4.0, 1.0, 2.0], [1.0, 0.25, 0.5]] {
            for e1 in [0.1, 0.7, 1.0, 1.5, 2.0] {
                for e2 in [0.1, 0.7, 1.0, 1.5, 2.0] {
                    let shape = Superellipsoid::new(size, [e1, e2]).unwrap();
                    let ratio = area(size, [e1, e2]) / tessellate(&shape, resolution).area();
                    assert!((ratio - 1.0).abs() < 0.06, "{size:?} {e1} {e2}: {ratio}");
                }
            }
        }
    }

    #[test]
    fn the_gradient_is_that_of_the_logarithm() {
        let (size, e) = ([1.0, 0.5, 2.0], [0.3, 1.4]);
        let (_, gradient) = approximate_area(&Superellipsoid::new(size, e).unwrap());
        for k in 0..5 {
            let at = |step: f64| {
                let (mut size, mut e) = (size, e);
                if k < 3 {
                    size[k] *= step.exp()
                } else {
                    e[k - 3] += step
                }
                area(size, e).ln()
            };
            let quotient = (at(1e-4) - at(-1e-4)) / 2e-4;
            assert!((gradient[k] - quotient).abs() < 1e-6, "{k}: {gradient:?} {quotient}");
        }
    }

    #[test]
    fn the_area_of_noisy_points_is_that_without_noise() {
        let sphere = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for deviation in [0.0, 0.02, 0.05] {
            let mut noise = || deviation * rng.random_range(-1.0..1.0) * 3.0_f64.sqrt();
            let points: Vec<_> = sample_surface(&sphere, 2000, 5)
                .into_iter()
                .map(|x| x + Vector3::from_fn(|_, _| noise()))
                .collect();
            let columns: [Vec<f64>; 3] =
                std::array::from_fn(|k| points.iter().map(|x| x[k]).collect());
            let found = neighbourhoods(columns.each_ref().map(|column| &column[..]));
            let reaches: Vec<f64> = found.iter().map(Neighbourhood::reach).collect();
            let area = measured_area(&reaches, &[1.0; 2000]);
            let ratio = SeenArea { area, points: 2000.0 }.ratio(&sphere, deviation * deviation);
            assert!((ratio - 1.0).abs() < 0.08, "{deviation}: {ratio}");
        }
    }

    fn cost(seen: f64, size: f64) -> Gram {
        let shape = Superellipsoid::new([size; 3], [1.0; 2]).unwrap();
        let mut gram = Gram::zero();
        gram.add_row(3.0, &[0.0; PARAMETERS]);
        (gram.geometric_squares, gram.evidence_squares) = (9.0, 0.0);
        let seen = SeenArea { area: seen, points: 0.0 };
        seen.add_to(&mut gram, &Model { shape, pose: Pose::identity() }, 100.0);
        gram
    }

    #[test]
    fn a_shape_seen_on_one_side_costs_nothing_more_and_a_giant_does() {
        assert_eq!(cost(4.0 * PI, 1.0).residual_squares(), 9.0);
        assert_eq!(cost(3.2 * PI, 1.0).residual_squares(), 9.0);
        let excess = (area([2.0; 3], [1.0; 2]) / (USUAL_RATIO * 4.0 * PI)).ln() / DEVIATION;
        let giant = cost(4.0 * PI, 2.0);
        let expected = 9.0 * (1.0 + excess * excess / 100.0);
        assert!((giant.geometric_squares + giant.evidence_squares - expected).abs() < 1e-9);
        // Half the derivative of the cost by ln a1, `9 excess / (100 DEVIATION)` times nearly 2/3.
        let slope = 9.0 * excess / (100.0 * DEVIATION) * 2.0 / 3.0;
        assert!((giant.matrix[0][1] - slope).abs() < 0.02, "{:?} {slope}", giant.matrix[0]);
    }
}
