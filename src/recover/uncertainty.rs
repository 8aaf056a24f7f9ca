//! How well the points determine the parameters: the linearised covariance at the optimum,
//! allowing for residuals that err together.

use std::f64::consts::PI;

use nalgebra::{SMatrix, SymmetricEigen};

use super::chart::Chart;
use super::covariance::Covariance;
use super::descent::PointSet;
use super::kernel::Gram;
use super::neighbours::nearest_others;
use super::radial::PARAMETERS;
use super::subset::Subset;
use crate::model::Model;

/// Standard errors of the correlation of neighbours that are put down to chance.
const CHANCE: f64 = 2.0;

type Matrix = SMatrix<f64, PARAMETERS, PARAMETERS>;

/// The covariance of the parameters of a model (normalised coordinates) that fits points, from the
/// Gram matrix of its rows, in the cloud's unit.
///
/// It is `(J'J / (s^2 n c) + 1)^-1` in the optimiser's coordinates, with `s^2 = r'r / (n - p)` but
/// not below the square of `resolution` (the rounding of the coordinates), and `1/c` the number
/// of independent residuals ([`dependence`]). The 1 is a prior of unit deviation, weak beside any
/// data, which stands in where the points say nothing: a standard error of `ln a` near one is "not
/// seen at all". Parameters that are fixed, or rest at a bound, have none.
pub(crate) fn covariance(
    points: &PointSet,
    model: &Model,
    gram: &Gram,
    resolution: f64,
    dependence: f64,
) -> Covariance {
    let (chart, coordinates) = Chart::around(model, points.constraints);
    let transform = chart.local_from_coordinates(&coordinates, model.pose.rotation());
    let is_free: Vec<bool> = (0..PARAMETERS).map(|k| transform.column(k).amax() > 0.0).collect();
    let free = is_free.iter().filter(|is_free| **is_free).count() as f64;

    let weight = points.weight();
    let freedom = weight - free;
    // As many points as parameters say nothing of the noise.
    let variance = if freedom < 1.0 { f64::INFINITY } else { gram.residual_squares() / freedom };
    let variance = variance.max(resolution * resolution) * weight * dependence;
    let information = transform.transpose() * hessian(gram) * transform / variance;
    let eigen = SymmetricEigen::new(information);
    let inverse =
        Matrix::from_diagonal(&eigen.eigenvalues.map(|value| 1.0 / (value.max(0.0) + 1.0)));
    let mut normalized = eigen.eigenvectors * inverse * eigen.eigenvectors.transpose();
    for k in (0..PARAMETERS).filter(|k| !is_free[*k]) {
        normalized.row_mut(k).fill(0.0);
        normalized.column_mut(k).fill(0.0);
    }
    let cloud_from_coordinates = derivatives_in_cloud(points, model, &transform);
    Covariance::new(cloud_from_coordinates * normalized * cloud_from_coordinates.transpose())
}

/// Derivatives of the parameters in the cloud's unit by the optimiser's coordinates.
fn derivatives_in_cloud(points: &PointSet, model: &Model, transform: &Matrix) -> Matrix {
    let radius = points.normalization.radius;
    let mut derivatives = Matrix::identity();
    for k in 0..3 {
        let size = model.shape.size()[k] * radius;
        for j in 0..3 {
            derivatives[(k, j)] = size * transform[(k, j)];
        }
        derivatives[(8 + k, 8 + k)] = radius;
    }
    derivatives
}

/// Half the second derivatives of the cost, by local parameters.
fn hessian(gram: &Gram) -> Matrix {
    Matrix::from_fn(|i, j| gram.matrix[1 + i.min(j)][1 + i.max(j)])
}

/// One over the number of independent residuals among `points`: `1/N` for noise that is
/// independent from point to point, more where the model misfits and neighbours err together.
///
/// A correlation that falls as `exp(-d/L)` over the surface is `rho` at the distance of
/// neighbours in a sample of n points, and makes one residual of each `2 pi / ln(rho)^2` of them.
pub(crate) fn dependence(sample: &PointSet, model: &Model, points: usize) -> f64 {
    let count = sample.len() as f64;
    let rho = neighbour_correlation(sample, model) - CHANCE / count.sqrt();
    let together = if rho > 0.0 { 2.0 * PI / rho.ln().powi(2) } else { 0.0 };
    (1.0 / points as f64 + together / count).min(1.0)
}

/// Correlation of each sampled point's geometric distance with its nearest neighbour's.
pub(crate) fn neighbour_correlation(sample: &PointSet, model: &Model) -> f64 {
    let residuals = sample.geometric_distances(model);
    let squares: f64 = residuals.iter().map(|r| r * r).sum();
    let points = Subset::normalized(sample.points, sample.normalization);
    let nearest = nearest_others(points.columns()).into_iter();
    let nearest = nearest.map(|other| other.map_or(0.0, |j| residuals[j]));
    let products: f64 = residuals.iter().zip(nearest).map(|(r, other)| r * other).sum();
    if squares > 0.0 { products / squares } else { 0.0 }
}
