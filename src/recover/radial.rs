//! One row of the radial problem: the radial Euclidean distance (JLS Eq. 2.43) of a point in
//! the model's frame, and its derivatives. The scalar reference of the block kernel.

use crate::shape::GaugeTerms;

/// Local parameters, in this order: `ln a1, ln a2, ln a3, e1, e2`, the body rotation increment
/// (x, y, z), the body translation increment (x, y, z).
pub const PARAMETERS: usize = 11;

/// A signed distance and its derivatives by the local parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// The signed radial Euclidean distance, negative inside.
    pub distance: f64,
    /// Its derivatives by `ln a1, ln a2, ln a3, e1, e2`, the rotation increment (x, y, z) and
    /// the translation increment (x, y, z), both in the model's frame.
    pub gradient: [f64; PARAMETERS],
}

/// The signed radial distance of the point `x` of the model's frame, with its derivatives: the
/// scalar reference of what [`fit`](super::fit) evaluates in blocks (JLS Eq. 2.43).
///
/// With `h = 1/H`, `r = |x|` and `rho = r h` (the surface along the ray): `d = r - rho`;
/// `dd/dx_i = n_i = x_i [(1 - h)/r + rho alpha_i / x_i^2]`, where `alpha` are the logarithmic
/// derivatives of H; a body rotation `R exp[delta]` gives `n x x`, a body translation `-n`;
/// `dd/d ln a_i = -rho alpha_i`; `dd/de_k = (1/2) rho S_k`, where S is an entropy.
pub fn radial_row(x: [f64; 3], size: &[f64; 3], exponents: &[f64; 2]) -> Row {
    let terms = GaugeTerms::at(x, size, exponents);
    let [mx, my, mz] = terms.magnitudes;
    let radius = (mx * mx + my * my + mz * mz).sqrt();
    let surface = radius * terms.inverse;
    let stretch = (1.0 - terms.inverse) / radius;
    let n: [f64; 3] = std::array::from_fn(|i| {
        let magnitude = terms.magnitudes[i];
        x[i] * (stretch + surface * terms.weights[i] / (magnitude * magnitude))
    });
    let [wx, wy, wz] = terms.weights;
    let [s1, s2] = terms.exponent_slopes;
    Row {
        distance: radius - surface,
        gradient: [
            -surface * wx,
            -surface * wy,
            -surface * wz,
            0.5 * surface * s1,
            0.5 * surface * s2,
            n[1] * x[2] - n[2] * x[1],
            n[2] * x[0] - n[0] * x[2],
            n[0] * x[1] - n[1] * x[0],
            -n[0],
            -n[1],
            -n[2],
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows written by `tests/golden/radial_distance.py`: a, e, x, d, and the derivatives of d
    /// by ln a, e and x.
    const GOLDEN: &str = include_str!("../../tests/golden/radial_distance.tsv");

    /// A dozen roundings, those of a logarithm multiplied by `2/e <= 40`.
    const TOLERANCE: f64 = 4e-14;

    fn golden() -> Vec<[f64; 17]> {
        let rows = GOLDEN.lines().filter(|line| !line.starts_with('#'));
        let parse = |line: &str| {
            let values: Vec<f64> = line.split('\t').map(|v| v.parse().unwrap()).collect();
            values.try_into().unwrap()
        };
        rows.map(parse).collect()
    }

    fn assert_close(actual: f64, expected: f64, scale: f64, row: &[f64]) {
        let error = (actual - expected).abs();
        assert!(error <= TOLERANCE * scale, "{actual:e} is not {expected:e} at {row:?}");
    }

    #[test]
    fn agrees_with_multiprecision_arithmetic_at_adversarial_points() {
        let rows = golden();
        assert!(rows.len() >= 300);
        for row in rows {
            let [a1, a2, a3, e1, e2, x, y, z, distance, derivatives @ ..] = row;
            let actual = radial_row([x, y, z], &[a1, a2, a3], &[e1, e2]);
            let radius = (x * x + y * y + z * z).sqrt();
            let surface = radius - distance;
            assert_close(actual.distance, distance, radius.max(surface), &row);
            for (k, expected) in derivatives[..5].iter().enumerate() {
                assert_close(actual.gradient[k], *expected, surface, &row);
            }
            let n = &derivatives[5..];
            // Far inside a long shape n is what remains of two terms of size 1/H.
            let steepest = n.iter().fold(1.0 + surface / radius, |most, v| most.max(v.abs()));
            let rotation = [n[1] * z - n[2] * y, n[2] * x - n[0] * z, n[0] * y - n[1] * x];
            for k in 0..3 {
                assert_close(-actual.gradient[8 + k], n[k], steepest, &row);
                assert_close(actual.gradient[5 + k], rotation[k], steepest * radius, &row);
            }
        }
    }

    #[test]
    fn is_finite_at_the_centre_and_on_axes_and_planes() {
        for e1 in [0.05, 1.0, 2.0] {
            for e2 in [0.05, 1.0, 2.0] {
                for x in [[0.0; 3], [0.0, 0.0, 3.0], [1.0, 0.0, 0.0], [0.0, 2.0, 1e-300]] {
                    let row = radial_row(x, &[1.0, 0.01, 100.0], &[e1, e2]);
                    assert!(row.distance.is_finite());
                    assert!(row.gradient.iter().all(|g| g.is_finite()), "{x:?} {row:?}");
                }
            }
        }
    }
}
