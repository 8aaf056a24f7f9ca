//! One row of the geometric problem: the first-order geometric distance of a point in the
//! model's frame, and its derivatives. The scalar reference of the block kernel.

use super::radial::{PARAMETERS, Row, radial_row};
use crate::shape::GaugeTerms;

/// The signed first-order geometric (Sampson) distance `g = (H - 1)/|grad H|` of the point `x` of
/// the model's frame, with its derivatives by the same local parameters as [`radial_row`].
///
/// H being homogeneous, `g = d / Q` with d the radial distance and `Q = |q|`, `q_i = |x| alpha_i
/// / x_i`: the distance from the tangent plane at the radial foot point. With `beta_i = q_i^2/Q^2`,
/// y and Y the log-odds of the equatorial and meridional shares,
/// `d ln Q = d ln |x| + A dY + B dy - sum beta_i d ln |x_i|`, `A = alpha_z - beta_z`, `B = beta_x
/// eta_y - beta_y eta_x`.
pub fn geometric_row(x: [f64; 3], size: &[f64; 3], exponents: &[f64; 2]) -> Row {
    let radial = radial_row(x, size, exponents);
    let terms = GaugeTerms::at(x, size, exponents);
    let stretch = Stretch::of(&terms, x, exponents);
    let mut gradient = [0.0; PARAMETERS];
    for (k, slope) in gradient.iter_mut().enumerate() {
        *slope = (radial.gradient[k] - radial.distance * stretch.log_gradient[k]) / stretch.value;
    }
    Row { distance: radial.distance / stretch.value, gradient }
}

/// The stretch Q, the radial over the geometric distance, and the derivatives of its logarithm.
struct Stretch {
    value: f64,
    log_gradient: [f64; PARAMETERS],
}

impl Stretch {
    fn of(terms: &GaugeTerms, x: [f64; 3], exponents: &[f64; 2]) -> Self {
        let square_radius: f64 = terms.magnitudes.iter().map(|m| m * m).sum();
        let q: [f64; 3] =
            std::array::from_fn(|i| square_radius.sqrt() * terms.weights[i] / terms.magnitudes[i]);
        let square: f64 = q.iter().map(|q| q * q).sum();
        let beta = q.map(|q| q * q / square);
        let mut log_gradient = normal_log_gradient(terms, x, exponents, beta);
        for (slope, x) in log_gradient[8..].iter_mut().zip(x) {
            *slope -= x / square_radius;
        }
        Self { value: square.sqrt(), log_gradient }
    }
}

/// Derivatives by the local parameters of `sum w_i ln g_i`, where `g_i = alpha_i / |x_i|` are in the
/// ratio of the components of grad H, and the weights w do not change:
/// `A dY + B dy - sum w_i d ln |x_i|`, `A = (w_x + w_y) alpha_z - w_z (alpha_x + alpha_y)`,
/// `B = w_x eta_y - w_y eta_x`.
pub(crate) fn normal_log_gradient(
    terms: &GaugeTerms,
    x: [f64; 3],
    [e1, e2]: &[f64; 2],
    weights: [f64; 3],
) -> [f64; PARAMETERS] {
    let [share_x, share_y] = terms.equator_shares;
    let [meridian_odds, equator_odds] = terms.log_odds;
    let [of_x, of_y, of_z] = weights;
    let [alpha_x, alpha_y, alpha_z] = terms.weights;
    let a = (of_x + of_y) * alpha_z - of_z * (alpha_x + alpha_y);
    let b = of_x * share_y - of_y * share_x;
    // Derivatives by ln |x_i| at constant size, of A dY + B dy: they sum to zero.
    let [meridian, equator] = [a * 2.0 / e1, b * 2.0 / e2];
    let by_size = [meridian * share_x + equator, meridian * share_y - equator, -meridian];
    let n: [f64; 3] =
        std::array::from_fn(|i| if x[i] == 0.0 { 0.0 } else { (by_size[i] - weights[i]) / x[i] });
    [
        -by_size[0],
        -by_size[1],
        -by_size[2],
        -a * meridian_odds / e1,
        0.5 * meridian * terms.equator_entropy - b * equator_odds / e2,
        n[1] * x[2] - n[2] * x[1],
        n[2] * x[0] - n[0] * x[2],
        n[0] * x[1] - n[1] * x[0],
        -n[0],
        -n[1],
        -n[2],
    ]
}

#[cfg(test)]
mod tests {
    use nalgebra::{Rotation3, Vector3};

    use super::*;
    use crate::shape::Superellipsoid;

    const EXPONENTS: [f64; 5] = [0.1, 0.5, 1.0, 1.5, 1.9];

    fn shapes() -> impl Iterator<Item = Superellipsoid> {
        EXPONENTS.into_iter().flat_map(|e1| {
            EXPONENTS.map(|e2| Superellipsoid::new([1.0, 0.6, 1.7], [e1, e2]).unwrap())
        })
    }

    fn points() -> [Vector3<f64>; 5] {
        [[0.9, 0.3, -0.4], [-0.5, 0.8, 0.6], [0.1, -1.5, 0.2], [0.3, 0.2, 1.9], [0.05, 0.1, 0.03]]
            .map(Vector3::from)
    }

    fn row(x: &Vector3<f64>, shape: &Superellipsoid) -> Row {
        geometric_row((*x).into(), &shape.size(), &shape.exponents())
    }

    #[test]
    fn is_the_gauge_less_one_over_the_length_of_its_gradient() {
        for shape in shapes() {
            for x in points() {
                let expected = (shape.gauge(&x) - 1.0) / shape.gauge_gradient(&x).norm();
                let actual = row(&x, &shape).distance;
                // Rounding of the gauge over its gradient, amplified by 2/e = 20.
                assert!((actual - expected).abs() < 1e-13 * (1.0 + expected.abs()), "{shape:?}");
            }
        }
    }

    #[test]
    fn is_the_euclidean_distance_of_a_sphere_and_near_it_elsewhere_to_second_order() {
        let sphere = Superellipsoid::new([2.0; 3], [1.0; 2]).unwrap();
        for x in points() {
            assert!((row(&x, &sphere).distance - (x.norm() - 2.0)).abs() < 1e-14);
        }
        for shape in shapes() {
            for (eta, omega) in [(0.4, 0.7), (-0.8, 2.5)] {
                let (x, normal) = (shape.position(eta, omega), shape.normal(eta, omega));
                let error = |step: f64| (row(&(x + step * normal), &shape).distance - step).abs();
                assert!(error(1e-6) < 1e-9, "{shape:?} {}", error(1e-6));
            }
        }
    }

    /// The shape and pose after a step of one local parameter.
    fn stepped(
        shape: &Superellipsoid,
        x: &Vector3<f64>,
        k: usize,
        step: f64,
    ) -> (Superellipsoid, Vector3<f64>) {
        let (mut size, mut exponents) = (shape.size(), shape.exponents());
        let mut moved = *x;
        match k {
            0..3 => size[k] *= step.exp(),
            3..5 => exponents[k - 3] += step,
            5..8 => moved = Rotation3::new(Vector3::ith(k - 5, step)).inverse() * x,
            _ => moved[k - 8] -= step,
        }
        (Superellipsoid::new(size, exponents).unwrap(), moved)
    }

    #[test]
    fn derivatives_are_difference_quotients() {
        for shape in shapes() {
            for x in points() {
                let gradient = row(&x, &shape).gradient;
                for (k, slope) in gradient.into_iter().enumerate() {
                    let h = 1e-6;
                    let distance = |step: f64| {
                        let (shape, x) = stepped(&shape, &x, k, step);
                        row(&x, &shape).distance
                    };
                    let quotient = (distance(h) - distance(-h)) / (2.0 * h);
                    // Rounding over the step; third derivatives, of (2/e)^3 and, at a coordinate
                    // of 0.03, 1/x^3, times its square.
                    let tolerance = 1e-6 * (1.0 + slope.abs());
                    assert!(
                        (slope - quotient).abs() < tolerance,
                        "{k} of {shape:?} at {x:?}: {slope} is not {quotient}"
                    );
                }
            }
        }
    }

    #[test]
    fn is_finite_at_the_centre_and_on_axes_and_planes() {
        for e1 in [0.05, 1.0, 2.0] {
            for e2 in [0.05, 1.0, 2.0] {
                for x in [[0.0; 3], [0.0, 0.0, 3.0], [1.0, 0.0, 0.0], [0.0, 2.0, 1e-300]] {
                    let row = geometric_row(x, &[1.0, 0.01, 100.0], &[e1, e2]);
                    assert!(row.distance.is_finite());
                    assert!(row.gradient.iter().all(|g| g.is_finite()), "{x:?} {row:?}");
                }
            }
        }
    }
}
