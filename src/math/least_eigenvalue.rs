//! The least eigenvalue of a scatter matrix.

use nalgebra::Matrix3;

/// A sum of principal minors that is a smaller share of the square of the trace is rounding: all
/// but one eigenvalue are none.
const RANK_ONE: f64 = 1e-12;

/// Newton steps at most, and the step, as a share of the trace, that ends them.
const STEPS: usize = 30;
const SETTLED: f64 = 1e-12;

/// The least eigenvalue of a positive semidefinite symmetric matrix, to 1e-5 of its trace where all
/// three are alike, to 1e-8 where two are, and nearly to rounding elsewhere.
///
/// From zero Newton's method climbs to the least root of the characteristic polynomial `l^3 - t
/// l^2 + m l - d`, which it never passes: a tenth of the time of a full decomposition.
pub(crate) fn least_eigenvalue(matrix: &Matrix3<f64>) -> f64 {
    let minor =
        |i: usize, j: usize| matrix[(i, i)] * matrix[(j, j)] - matrix[(i, j)] * matrix[(i, j)];
    let (trace, minors) = (matrix.trace(), minor(0, 1) + minor(0, 2) + minor(1, 2));
    let determinant = matrix.determinant();
    let mut least = 0.0;
    if minors <= RANK_ONE * trace * trace {
        return least;
    }
    for _ in 0..STEPS {
        let value = ((least - trace) * least + minors) * least - determinant;
        let slope = (3.0 * least - 2.0 * trace) * least + minors;
        let step = -value / slope;
        if step.is_nan() || step <= SETTLED * trace {
            break;
        }
        least += step;
    }
    least
}

#[cfg(test)]
mod tests {
    use nalgebra::{Rotation3, Vector3};

    use super::*;

    fn matrix(eigenvalues: [f64; 3]) -> Matrix3<f64> {
        let turn = Rotation3::new(Vector3::new(0.3, -1.1, 0.7)).into_inner();
        turn * Matrix3::from_diagonal(&eigenvalues.into()) * turn.transpose()
    }

    #[test]
    fn is_that_of_the_decomposition() {
        for eigenvalues in
            [[3.0, 2.0, 1.0], [1.0, 1e-3, 1e-6], [5.0, 1.0, 1.0], [1e-9, 1e-9, 1e-10]]
        {
            let matrix = matrix(eigenvalues);
            let expected = matrix.symmetric_eigenvalues().min();
            let error = (least_eigenvalue(&matrix) - expected).abs();
            assert!(error < 1e-8 * matrix.trace(), "{eigenvalues:?}: {error:e}");
        }
        assert!((least_eigenvalue(&matrix([1.0; 3])) - 1.0).abs() < 1e-5);
    }

    #[test]
    fn is_none_in_a_plane_and_on_a_line() {
        assert!(least_eigenvalue(&matrix([2.0, 1.0, 0.0])) < 1e-15);
        assert_eq!(least_eigenvalue(&matrix([2.0, 0.0, 0.0])), 0.0);
        assert_eq!(least_eigenvalue(&Matrix3::zeros()), 0.0);
        assert_eq!(least_eigenvalue(&Matrix3::repeat(f64::NAN)), 0.0);
    }
}
