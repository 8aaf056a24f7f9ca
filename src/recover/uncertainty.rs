//! How well the points determine the sizes: the linearised covariance at the optimum.

use nalgebra::{SMatrix, SymmetricEigen};

use super::descent::Descent;
use super::radial::PARAMETERS;

/// Standard errors of `ln a1, ln a2, ln a3`, that is relative errors of the semi-axes.
///
/// The covariance is `(J'J / s^2 + 1)^-1`, with `s^2 = r'r / (N - 11)` but not below the square
/// of `resolution` (the rounding of the coordinates): J'J of the local parameters in normalised
/// units, and a prior of unit deviation, weak beside any data, which stands in where the points
/// say nothing. A standard error near one is therefore "not seen at all".
pub(crate) fn size_errors(descent: &Descent, points: usize, resolution: f64) -> [f64; 3] {
    let freedom = points.saturating_sub(PARAMETERS);
    if freedom == 0 {
        return [1.0; 3];
    }
    let variance = descent.gram.residual_squares() / freedom as f64;
    let variance = variance.max(resolution * resolution);
    let entry = |i: usize, j: usize| descent.gram.matrix[1 + i.min(j)][1 + i.max(j)] / variance;
    let information = SMatrix::<f64, PARAMETERS, PARAMETERS>::from_fn(entry);
    let eigen = SymmetricEigen::new(information);
    std::array::from_fn(|axis| {
        let shares = eigen.eigenvectors.row(axis);
        let terms = shares.iter().zip(eigen.eigenvalues.iter());
        terms.map(|(share, value)| share * share / (value.max(0.0) + 1.0)).sum::<f64>().sqrt()
    })
}
