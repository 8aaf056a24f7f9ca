//! The area seen against the area of the shape.
//!
//! Of a convex solid with a centre of symmetry a distant camera sees half of the surface, as of
//! each pair of opposite pieces one faces it. A model with much more than twice the area on which
//! the points lie is doubtful: where noise leaves the depth of a single view open, the points
//! alone would take a giant for it.

use std::f64::consts::PI;

use crate::model::Model;
use crate::recover::kernel::Gram;
use crate::recover::radial::PARAMETERS;
use crate::shape::Superellipsoid;

/// Area of a shape over that seen which is no reason for doubt. Less than 2: noise makes the
/// seen area seem larger.
const USUAL_RATIO: f64 = 1.5;

/// Deviation of the logarithm of the ratio beyond that.
const DEVIATION: f64 = 0.1;

/// The area on which the points lie, in normalised units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SeenArea(pub f64);

impl SeenArea {
    /// Multiplies the cost C of n points to `C (1 + r^2 / n)`, r being the model's excess area in
    /// deviations: as -2 log likelihood is `n ln C + r^2`, whatever the noise.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        let (area, log_gradient) = approximate_area(&model.shape);
        let excess = (area / (USUAL_RATIO * self.0)).ln() / DEVIATION;
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

/// The area to about a fifth, and the derivatives of its logarithm by `ln a1, ln a2, ln a3, e1,
/// e2`: that of the ellipsoid (K. Thomsen's formula), times the ratio of the volumes to the power
/// 2/3.
fn approximate_area(shape: &Superellipsoid) -> (f64, [f64; 5]) {
    const POWER: f64 = 1.6075;
    const STEP: f64 = 1e-6;
    let [a, b, c] = shape.size();
    let [ab, ac, bc] = [a * b, a * c, b * c].map(|product| product.powf(POWER));
    let sum = ab + ac + bc;
    let [e1, e2] = shape.exponents();
    let area = 4.0 * PI * (sum / 3.0).powf(1.0 / POWER) * volume_ratio([e1, e2]).powf(2.0 / 3.0);
    let by_exponent = |above: [f64; 2], below: [f64; 2]| {
        (volume_ratio(above) / volume_ratio(below)).ln() / (3.0 * STEP)
    };
    let gradient = [
        (ab + ac) / sum,
        (ab + bc) / sum,
        (ac + bc) / sum,
        by_exponent([e1 + STEP, e2], [e1 - STEP, e2]),
        by_exponent([e1, e2 + STEP], [e1, e2 - STEP]),
    ];
    (area, gradient)
}

/// The volume with these exponents over the ellipsoid's.
fn volume_ratio(exponents: [f64; 2]) -> f64 {
    const UNIT_BALL: f64 = 4.0 / 3.0 * PI;
    Superellipsoid::new([1.0; 3], exponents).map_or(f64::NAN, |shape| shape.volume() / UNIT_BALL)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;

    fn area(size: [f64; 3], e: [f64; 2]) -> f64 {
        approximate_area(&Superellipsoid::new(size, e).unwrap()).0
    }

    #[test]
    fn areas_of_sphere_cube_and_octahedron_are_right_to_a_fifth() {
        for (e, exact) in [(1.0, 16.0 * PI), (0.01, 96.0), (2.0, 16.0 * 3.0_f64.sqrt())] {
            let area = area([2.0; 3], [e; 2]);
            assert!((area / exact - 1.0).abs() < 0.2, "{e}: {area} {exact}");
        }
        assert!((area([2.0; 3], [1.0; 2]) / (16.0 * PI) - 1.0).abs() < 1e-12);
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

    fn cost(seen: f64, size: f64) -> Gram {
        let shape = Superellipsoid::new([size; 3], [1.0; 2]).unwrap();
        let mut gram = Gram::zero();
        gram.add_row(3.0, &[0.0; PARAMETERS]);
        (gram.geometric_squares, gram.evidence_squares) = (9.0, 0.0);
        SeenArea(seen).add_to(&mut gram, &Model { shape, pose: Pose::identity() }, 100.0);
        gram
    }

    #[test]
    fn a_shape_seen_on_one_side_costs_nothing_more_and_a_giant_does() {
        assert_eq!(cost(4.0 * PI, 1.0).residual_squares(), 9.0);
        assert_eq!(cost(3.0 * PI, 1.0).residual_squares(), 9.0);
        let excess = (4.0_f64 / 1.5).ln() / DEVIATION;
        let giant = cost(4.0 * PI, 2.0);
        let expected = 9.0 * (1.0 + excess * excess / 100.0);
        assert!((giant.geometric_squares + giant.evidence_squares - expected).abs() < 1e-9);
        // Half the derivative of the cost by ln a1, `9 excess / (100 DEVIATION)` times 2/3.
        let slope = 9.0 * excess / (100.0 * DEVIATION) * 2.0 / 3.0;
        assert!((giant.matrix[0][1] - slope).abs() < 1e-9, "{:?} {slope}", giant.matrix[0]);
    }
}
