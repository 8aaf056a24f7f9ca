//! Ends of a model that strays alone make out.
//!
//! A mixture takes the surface to be as dense everywhere as it is on the whole. Of an end that is
//! not seen at all, the few strays that happen to lie near it would pass for points, and seem to
//! tell where it is.

use nalgebra::Vector3;

use super::descent::PointSet;
use super::subset::Subset;
use crate::model::Model;

/// Deviations within which points are near the surface.
const NEAR: f64 = 3.0;

/// Multiples of the model between which the strays over an end are counted.
const SHELL: [f64; 2] = [0.5, 1.5];

/// Standard deviations of the number of strays near an end that are put down to chance: many, since
/// the end was laid where most of them are.
const CHANCE: f64 = 5.0;

/// A point near an end that strays make out is one of them from this share on of the coordinate that
/// would make it the end's.
const RIM: f64 = 0.9;

/// The number of ends: 0 and 1 are those of the x axis, on its positive and negative side.
const ENDS: usize = 6;

/// What is counted over one end: where that axis's coordinate is the greatest, in semi-axes.
#[derive(Debug, Clone, Copy, Default)]
struct End {
    /// Points of the surface.
    points: f64,
    /// Strays in the shell.
    strays: f64,
}

impl End {
    /// Whether as many strays may lie within `near` of an end that is `semi_axis` off the centre.
    ///
    /// The cone from the centre to a flat end of area A has the volume `A a / 3`, its part in the
    /// shell `A a (high^3 - low^3) / 3`, and `2 A near` of it is near the end. One stray more
    /// stands for those that might have been there.
    fn is_by_chance(&self, near: f64, semi_axis: f64) -> bool {
        let [low, high] = SHELL.map(|scale| scale.powi(3));
        let share = (6.0 * near / (semi_axis * (high - low))).min(1.0);
        let expected = share * (self.strays + 1.0);
        self.points <= expected + CHANCE * expected.sqrt()
    }
}

/// The probabilities of points to be of the surface of a model (normalised coordinates) about which
/// they scatter with this deviation: 0 on ends of which no more is seen than strays would show by
/// chance. None if there are no such points.
pub(crate) fn without_ends_by_chance(
    points: &PointSet,
    model: &Model,
    deviation: f64,
    weights: &[f64],
) -> Option<Vec<f64>> {
    let size = Vector3::from(model.shape.size());
    let scaled = scaled(points, model);
    let mut ends = [End::default(); ENDS];
    for (u, weight) in scaled.iter().zip(weights) {
        if *weight > 0.5 {
            ends[end_under(u)].points += 1.0;
        } else if (SHELL[0]..SHELL[1]).contains(&model.shape.gauge(&u.component_mul(&size))) {
            ends[end_under(u)].strays += 1.0;
        }
    }
    let by_chance: Vec<usize> = (0..ENDS)
        .filter(|&k| ends[k].points > 0.0 && ends[k].is_by_chance(NEAR * deviation, size[k / 2]))
        .collect();
    let is_kept = |u: &Vector3<f64>| !by_chance.iter().any(|&end| along(u, end) > RIM * u.amax());
    let weight = |(u, weight): (&Vector3<f64>, &f64)| if is_kept(u) { *weight } else { 0.0 };
    (!by_chance.is_empty()).then(|| scaled.iter().zip(weights).map(weight).collect())
}

/// Points in the model's frame, in its semi-axes.
fn scaled(points: &PointSet, model: &Model) -> Vec<Vector3<f64>> {
    let normalized = Subset::normalized(points.points, points.normalization);
    let [xs, ys, zs] = normalized.columns();
    let size = Vector3::from(model.shape.size());
    let scaled = |i| {
        let x_model = model.pose.model_from_world(&Vector3::new(xs[i], ys[i], zs[i]));
        x_model.component_div(&size)
    };
    (0..points.len()).map(scaled).collect()
}

/// The coordinate of a point towards an end.
fn along(scaled: &Vector3<f64>, end: usize) -> f64 {
    if end.is_multiple_of(2) { scaled[end / 2] } else { -scaled[end / 2] }
}

/// The end that a point is over: where its coordinate is the greatest.
fn end_under(scaled: &Vector3<f64>) -> usize {
    let axis = scaled.iamax();
    2 * axis + usize::from(scaled[axis] < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::recover::descent::tests::bare;
    use crate::recover::normalization::{Moments, Normalization};
    use crate::shape::Superellipsoid;

    const DEVIATION: f64 = 0.01;

    /// The points of `per_side` rows on each side of a cube of side 2 but that of x = 1, and others.
    fn open_cube(per_side: i32, others: &[[f64; 3]]) -> Vec<[f64; 3]> {
        let mut points = Vec::new();
        let steps = (0..per_side).map(|i| 1.8 * (f64::from(i) / f64::from(per_side - 1) - 0.5));
        for (u, v) in steps.clone().flat_map(|u| steps.clone().map(move |v| (u, v))) {
            points.extend([[-1.0, u, v], [u, 1.0, v], [u, -1.0, v], [u, v, 1.0], [u, v, -1.0]]);
        }
        points.extend(others);
        points
    }

    /// The weights that are left of points, of which the last `strays` weigh nothing.
    fn left(points: &[[f64; 3]], strays: usize) -> Option<Vec<f64>> {
        let columns = [0, 1, 2].map(|k| points.iter().map(|x| x[k]).collect::<Vec<f64>>());
        let columns = [&columns[0][..], &columns[1], &columns[2]];
        let Moments { normalization, .. } = Moments::of(columns);
        let points = PointSet { normalization: &normalization, ..bare(columns) };
        let count = points.len();
        let weights: Vec<f64> = (0..count).map(|i| f64::from(i < count - strays)).collect();
        let cube = Superellipsoid::new([1.0; 3], [0.1; 2]).unwrap();
        let cube = Model { shape: cube, pose: Pose::identity() };
        let cube = normalization.model_of(&Normalization::identity(), &cube);
        let deviation = DEVIATION * normalization.inverse_radius;
        without_ends_by_chance(&points, &cube, deviation, &weights)
    }

    #[test]
    fn three_strays_are_no_end_and_those_on_its_rim_go_with_them() {
        let on_end = [[1.0, 0.3, 0.2], [1.01, -0.4, 0.1], [0.99, 0.5, -0.6]];
        let on_rim = [[0.95, 0.3, 1.0]];
        let off = [1.3, 1.2, 1.1, 0.9, 0.8, 0.7, 0.6].map(|x| [x, 0.1, 0.2 - 0.4 * x]);
        let points = open_cube(10, &[&on_end[..], &on_rim, &off].concat());
        let left = left(&points, off.len()).unwrap();
        assert!(left[..500].iter().all(|weight| *weight == 1.0));
        assert_eq!(left[500..], [0.0; 11]);
    }

    #[test]
    fn an_end_of_many_points_and_one_of_none_are_left_as_they_are() {
        let many: Vec<[f64; 3]> = (0..25)
            .map(|i| [1.0, 0.3 * f64::from(i % 5) - 0.6, 0.3 * f64::from(i / 5) - 0.6])
            .collect();
        assert_eq!(left(&open_cube(10, &many), 0), None);
        assert_eq!(left(&open_cube(10, &[]), 0), None);
    }
}
