//! The covariance of a fit's parameters.

use nalgebra::{Matrix3, SMatrix};

use super::radial::PARAMETERS;

/// The 97.5 % quantile of a normal deviate.
const QUANTILE_NORMAL: f64 = 1.959_964;

/// The 95 % quantile of chi squared with three degrees of freedom.
const QUANTILE_CHI_SQUARED: f64 = 7.814_728;

/// Covariance of the eleven parameters as far as the noise of the points goes: in the cloud's unit
/// and frame, in the order of [`Covariance::NAMES`].
///
/// The rotation is that by a small vector in the model's frame, after the model's own:
/// `R exp[r]`. What the points do not determine has the spread of a weak prior: standard errors
/// of about the size itself, an exponent of 1, a radian, and the points' RMS radius. Parameters
/// that are fixed, or rest at a bound, have no spread.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Covariance {
    matrix: SMatrix<f64, PARAMETERS, PARAMETERS>,
}

impl Covariance {
    /// The parameters, in the order of rows and columns.
    pub const NAMES: [&'static str; PARAMETERS] =
        ["a1", "a2", "a3", "e1", "e2", "rx", "ry", "rz", "x", "y", "z"];

    pub(crate) fn new(matrix: SMatrix<f64, PARAMETERS, PARAMETERS>) -> Self {
        Self { matrix }
    }

    /// The matrix, row by row.
    pub fn rows(&self) -> [[f64; PARAMETERS]; PARAMETERS] {
        std::array::from_fn(|i| std::array::from_fn(|j| self.matrix[(i, j)]))
    }

    /// The standard error of each parameter.
    pub fn standard_errors(&self) -> [f64; PARAMETERS] {
        std::array::from_fn(|k| self.matrix[(k, k)].max(0.0).sqrt())
    }

    /// Half the length of each parameter's 95 % interval.
    pub fn half_intervals(&self) -> [f64; PARAMETERS] {
        self.standard_errors().map(|error| QUANTILE_NORMAL * error)
    }

    /// That of the semi-axes.
    pub fn of_size(&self) -> Matrix3<f64> {
        self.matrix.fixed_view::<3, 3>(0, 0).into_owned()
    }

    /// That of the centre.
    pub fn of_centre(&self) -> Matrix3<f64> {
        self.matrix.fixed_view::<3, 3>(8, 8).into_owned()
    }

    /// Whether errors of three parameters lie in their joint 95 % region, `x' C^-1 x <= 7.81`;
    /// false where the covariance is singular.
    pub fn is_in_region(covariance: &Matrix3<f64>, errors: [f64; 3]) -> bool {
        let errors = nalgebra::Vector3::from(errors);
        let solved = covariance.cholesky().map(|factor| factor.solve(&errors));
        solved.is_some_and(|solved| errors.dot(&solved) <= QUANTILE_CHI_SQUARED)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_intervals_and_regions_are_those_of_the_matrix() {
        let mut matrix = SMatrix::zeros();
        for k in 0..PARAMETERS {
            matrix[(k, k)] = (k as f64 + 1.0).powi(2);
        }
        let covariance = Covariance::new(matrix);
        assert_eq!(covariance.standard_errors()[10], 11.0);
        assert!((covariance.half_intervals()[1] - 3.92).abs() < 1e-3);
        let size = covariance.of_size();
        assert!(Covariance::is_in_region(&size, [2.79, 0.0, 0.0]));
        assert!(!Covariance::is_in_region(&size, [2.80, 0.0, 0.0]));
        assert!(!Covariance::is_in_region(&Matrix3::zeros(), [0.0; 3]));
        assert_eq!(covariance.of_centre()[(2, 2)], 121.0);
        assert_eq!(covariance.rows()[3][3], 16.0);
    }
}
