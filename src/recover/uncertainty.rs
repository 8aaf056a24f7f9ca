//! How well the points determine the sizes: the linearised covariance at the optimum, allowing
//! for residuals that err together.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SymmetricEigen, Vector3};

use super::descent::{Descent, PointSet};
use super::geometric::geometric_row;
use super::kernel::{ModelView, Residual};
use super::radial::PARAMETERS;

/// Standard errors of the correlation of neighbours that are put down to chance.
const CHANCE: f64 = 2.0;

/// Standard errors of `ln a1, ln a2, ln a3`, that is relative errors of the semi-axes.
///
/// The covariance is `(J'J / (s^2 N c) + 1)^-1`, with `s^2 = r'r / (N - 11)` but not below the
/// square of `resolution` (the rounding of the coordinates), and `1/c` the number of independent
/// residuals ([`dependence`]): J'J of the local parameters in normalised units, and a prior of
/// unit deviation, weak beside any data, which stands in where the points say nothing. A standard
/// error near one is therefore "not seen at all".
pub(crate) fn size_errors(
    descent: &Descent,
    points: usize,
    resolution: f64,
    dependence: f64,
) -> [f64; 3] {
    let freedom = points.saturating_sub(PARAMETERS);
    if freedom == 0 {
        return [1.0; 3];
    }
    let variance = descent.gram.residual_squares() / freedom as f64;
    let variance = variance.max(resolution * resolution) * points as f64 * dependence;
    let entry = |i: usize, j: usize| descent.gram.matrix[1 + i.min(j)][1 + i.max(j)] / variance;
    let information = SMatrix::<f64, PARAMETERS, PARAMETERS>::from_fn(entry);
    let eigen = SymmetricEigen::new(information);
    std::array::from_fn(|axis| {
        let shares = eigen.eigenvectors.row(axis);
        let terms = shares.iter().zip(eigen.eigenvalues.iter());
        terms.map(|(share, value)| share * share / (value.max(0.0) + 1.0)).sum::<f64>().sqrt()
    })
}

/// One over the number of independent residuals among `points`: `1/N` for noise that is
/// independent from point to point, more where the model misfits and neighbours err together.
///
/// A correlation that falls as `exp(-d/L)` over the surface is `rho` at the distance of
/// neighbours in a sample of n points, and makes one residual of each `2 pi / ln(rho)^2` of them.
pub(crate) fn dependence(sample: &PointSet, descent: &Descent, points: usize) -> f64 {
    let count = sample.len() as f64;
    let rho = neighbour_correlation(sample, descent) - CHANCE / count.sqrt();
    let together = if rho > 0.0 { 2.0 * PI / rho.ln().powi(2) } else { 0.0 };
    (1.0 / points as f64 + together / count).min(1.0)
}

/// Correlation of each sampled point's geometric distance with its nearest neighbour's.
fn neighbour_correlation(sample: &PointSet, descent: &Descent) -> f64 {
    let view = ModelView::new(sample.normalization, &descent.model, Residual::Radial);
    let shape = &descent.model.shape;
    let [xs, ys, zs] = sample.points;
    let local: Vec<Vector3<f64>> =
        (0..sample.len()).map(|i| view.model_from_cloud([xs[i], ys[i], zs[i]]).into()).collect();
    let residuals: Vec<f64> = local
        .iter()
        .map(|x| geometric_row((*x).into(), &shape.size(), &shape.exponents()).distance)
        .collect();
    let squares: f64 = residuals.iter().map(|r| r * r).sum();
    let products: f64 =
        residuals.iter().zip(nearest_neighbours(&local)).map(|(r, j)| r * residuals[j]).sum();
    if squares > 0.0 { products / squares } else { 0.0 }
}

/// Of each point the index of its nearest neighbour, by trying all: they are few.
fn nearest_neighbours(points: &[Vector3<f64>]) -> Vec<usize> {
    let nearest = |(i, point): (usize, &Vector3<f64>)| {
        let mut best = (f64::INFINITY, i);
        for (j, other) in points.iter().enumerate() {
            let distance = (other - point).norm_squared();
            if distance < best.0 && j != i {
                best = (distance, j);
            }
        }
        best.1
    };
    points.iter().enumerate().map(nearest).collect()
}
