//! Least trimmed squares: the model of the points that fit it best, whatever the others are.
//!
//! By concentration steps (P. Rousseeuw and K. Van Driessen, Computing LTS Regression for Large Data
//! Sets, Data Mining and Knowledge Discovery 12, 2006): what is of another surface, a stand or the
//! ground, soon has no say.

use super::descent::{Effort, PointSet, descend};
use super::subset::Subset;
use crate::model::Model;

/// The share of the points that count.
pub(crate) const CORE_SHARE: f64 = 0.5;

/// Steps, at most.
const STEPS: usize = 30;

/// The model of the half of the points that is nearest to it, from another one, and the passes over
/// points that it took. None where a descent has no result.
pub(crate) fn concentrated(points: &PointSet, start: &Model) -> Option<(Model, usize)> {
    let count = (CORE_SHARE * points.len() as f64) as usize;
    let (mut model, mut core, mut passes) = (*start, Vec::new(), 0);
    for _ in 0..STEPS {
        let nearest = least(&points.geometric_squares(&model), count);
        if core == nearest {
            break;
        }
        core = nearest;
        let some = Subset::of(points.points, &core);
        let descent =
            descend(&PointSet { points: some.columns(), ..*points }, &model, &Effort::MEDIUM)?;
        passes += descent.passes + 1;
        model = descent.model;
    }
    Some((model, passes))
}

/// Indices, ascending, of so many of the least values.
pub(crate) fn least(values: &[f64], count: usize) -> Vec<usize> {
    let mut indices: Vec<usize> = (0..values.len()).collect();
    indices.sort_by(|&i, &j| values[i].total_cmp(&values[j]));
    indices.truncate(count);
    indices.sort_unstable();
    indices
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::recover::constraints::Constraints;
    use crate::recover::descent::tests::bare;
    use crate::recover::normalization::Normalization;
    use crate::shape::Superellipsoid;

    /// A ball before a wall, on which one point in six is: the fit to all of them is drawn to it.
    #[test]
    fn a_ball_before_a_wall_is_found_from_the_fit_to_both() {
        let turns = (0..140).map(|i| 2.4 * f64::from(i));
        let ball = turns.enumerate().map(|(i, turn): (usize, f64)| {
            let x = 1.0 - i as f64 / 140.0;
            let radius = (1.0 - x * x).sqrt();
            [x, radius * turn.cos(), radius * turn.sin()]
        });
        let wall =
            (0..28).map(|i| [-0.3, 0.3 * f64::from(i % 7) - 0.9, -1.2 - 0.1 * f64::from(i / 7)]);
        let points: Vec<[f64; 3]> = ball.chain(wall).collect();
        let columns = [0, 1, 2].map(|k| points.iter().map(|x| x[k]).collect::<Vec<f64>>());
        let normalization = Normalization::identity();
        let points = PointSet {
            constraints: &Constraints::sphere().normalized(&normalization),
            ..bare([&columns[0], &columns[1], &columns[2]])
        };
        let ball = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        let start = Model { shape: ball, pose: Pose::identity() };
        let of_all = descend(&points, &start, &Effort::MEDIUM).unwrap().model;
        assert!((of_all.shape.size()[0] - 1.0).abs() > 0.05, "{of_all:?}");
        let (found, _) = concentrated(&points, &of_all).unwrap();
        assert!((found.shape.size()[0] - 1.0).abs() < 1e-6, "{found:?}");
        assert!(found.pose.translation().norm() < 1e-6, "{found:?}");
    }

    #[test]
    fn the_least_are_those_that_sorting_puts_first() {
        assert_eq!(least(&[3.0, 1.0, 2.0, 1.0, 5.0], 3), [1, 2, 3]);
        assert_eq!(least(&[1.0; 4], 2), [0, 1]);
        assert_eq!(least(&[2.0, 1.0], 0), [0; 0]);
    }
}
