//! The side that a surface among strays was seen from.
//!
//! What a model turns away from the sensor was not seen: points there are strays, or the model is
//! wrong. Both are weighed by the mixture, to which this lends odds. So strays on a side that nobody
//! saw do not tell where it is, and points of the surface that a model has in its shade are strays
//! to it, which costs likelihood.

use nalgebra::Vector3;

use super::facing::{Seen, are_turned_away, direction_faced_around};
use crate::model::Model;
use crate::recover::descent::PointSet;
use crate::recover::search::is_noisy;
use crate::recover::subset::Subset;

/// Error of the cosine between normal and direction: the direction is an estimate, and on a flat
/// side one cosine holds for all.
const COSINE_ERROR: f64 = 0.1;

/// Least odds: where noise leaves the minimum in doubt, models are not trusted to know their shade
/// that well.
const LEAST_ODDS: f64 = 1e-6;
const LEAST_ODDS_IN_DOUBT: f64 = 0.03;

/// Where the sensor was, in normalised coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Side {
    /// At a point.
    Viewpoint(Vector3<f64>),
    /// Far off in the direction of this unit vector.
    Direction(Vector3<f64>),
}

impl Side {
    /// Of these points of a model's surface: from the viewpoint, if one is known, else the direction
    /// that most of them face. None if they do not face one.
    pub fn of(surface: &PointSet, model: &Model) -> Option<Self> {
        match &surface.evidence.free_space {
            Some(space) => Some(Self::Viewpoint(space.viewpoint())),
            None => direction_faced_around(model, surface).map(Self::Direction),
        }
    }

    /// Probability of each point's place on the surface of a model, given that the sensor saw it, over
    /// that of a place which faces the sensor: `exp(-z^2/2)`, where `1/z^2` is the sum of
    /// `(deviation / distance)^2` beyond the rim and of `(error / cosine)^2`.
    pub fn odds(&self, points: &PointSet, model: &Model, deviation: f64) -> Vec<f64> {
        let least = if is_noisy(deviation) { LEAST_ODDS_IN_DOUBT } else { LEAST_ODDS };
        let normalized = Subset::normalized(points.points, points.normalization);
        let [xs, ys, zs] = normalized.columns();
        let points = xs.iter().zip(ys).zip(zs).map(|((x, y), z)| Vector3::new(*x, *y, *z));
        let seen: Vec<Seen> = points.map(|point| self.seen(point)).collect();
        let odds = |(seen, is_away): (&Seen, bool)| {
            let away = if is_away { seen.away(model, deviation) } else { None };
            let Some((distance, cosine)) = away else { return 1.0 };
            let inverse = (deviation / distance).powi(2) + (COSINE_ERROR / cosine).powi(2);
            (-0.5 / inverse).exp().max(least)
        };
        seen.iter().zip(are_turned_away(&seen, model)).map(odds).collect()
    }

    /// The same in the frame of a model, as homogeneous coordinates: a place and 1, or a direction
    /// and 0.
    pub fn in_frame_of(&self, model: &Model) -> ([f64; 3], f64) {
        match self {
            Self::Viewpoint(place) => (model.pose.model_from_world(place).into(), 1.0),
            Self::Direction(direction) => {
                ((model.pose.rotation().inverse() * direction).into(), 0.0)
            }
        }
    }

    /// The unit vector from a point towards the sensor.
    pub fn direction_from(&self, point: Vector3<f64>) -> Vector3<f64> {
        self.seen(point).to_sensor
    }

    fn seen(&self, point: Vector3<f64>) -> Seen {
        let to_sensor = match self {
            Self::Direction(direction) => *direction,
            // At the viewpoint itself any direction will do.
            Self::Viewpoint(place) => (place - point).try_normalize(0.0).unwrap_or(Vector3::x()),
        };
        Seen { point, to_sensor }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::recover::descent::tests::bare;
    use crate::shape::Superellipsoid;

    const DEVIATION: f64 = 0.02;

    fn odds(side: Side, shape: &Superellipsoid, points: &[[f64; 3]]) -> Vec<f64> {
        let columns = [0, 1, 2].map(|k| points.iter().map(|x| x[k]).collect::<Vec<f64>>());
        let points = bare([&columns[0], &columns[1], &columns[2]]);
        side.odds(&points, &Model { shape: *shape, pose: Pose::identity() }, DEVIATION)
    }

    /// Points of the unit sphere at these heights above the rim, as it is seen along z.
    fn of_sphere(side: Side, heights: &[f64]) -> Vec<f64> {
        let point = |z: &f64| [(1.0 - z * z).sqrt() * 0.6, (1.0 - z * z).sqrt() * 0.8, *z];
        let points: Vec<[f64; 3]> = heights.iter().map(point).collect();
        odds(side, &Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap(), &points)
    }

    #[test]
    fn what_is_beyond_the_rim_by_more_than_noise_is_hardly_seen() {
        let heights = [0.9, 0.01, -0.9 * DEVIATION, -0.1, -0.15, -0.9];
        let odds = of_sphere(Side::Direction(Vector3::z()), &heights);
        assert_eq!(odds[..3], [1.0; 3]);
        assert!(odds[3] < 0.8 && odds[3] > odds[4], "{odds:?}");
        assert!(odds[4] > LEAST_ODDS_IN_DOUBT, "{odds:?}");
        assert_eq!(odds[5], LEAST_ODDS_IN_DOUBT);
    }

    #[test]
    fn from_a_near_viewpoint_less_is_seen_than_from_far_off() {
        let seen = |side| of_sphere(side, &[0.2])[0];
        assert_eq!(seen(Side::Direction(Vector3::z())), 1.0);
        assert_eq!(seen(Side::Viewpoint(Vector3::z() * 1e3)), 1.0);
        // The rim is at a height of 1/2.
        assert!(seen(Side::Viewpoint(Vector3::z() * 2.0)) < 0.3);
    }

    #[test]
    fn a_flat_side_seen_edgewise_is_not_taken_for_the_shade() {
        let cube = Superellipsoid::new([1.0; 3], [0.1; 2]).unwrap();
        let sides = |tilt: f64| {
            let to_sensor = Vector3::new(-tilt, 0.0, 1.0).normalize();
            odds(Side::Direction(to_sensor), &cube, &[[1.0, 0.2, -0.3]])[0]
        };
        assert!(sides(0.03) > 0.9, "{}", sides(0.03));
        assert_eq!(sides(0.5), LEAST_ODDS_IN_DOUBT);
    }

    #[test]
    fn a_point_at_the_viewpoint_has_odds() {
        let odds = of_sphere(Side::Viewpoint(Vector3::new(0.0, 0.0, 1.0)), &[1.0]);
        assert!(odds[0] > 0.0 && odds[0] <= 1.0);
    }
}
