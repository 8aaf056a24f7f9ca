//! What is seen faces the sensor.
//!
//! A point on a side that is turned away was seen through the solid, however near it is to the
//! surface: the distance from the surface does not tell that a side is in the shade. What was seen is
//! beyond the rim by noise alone. So each point is first moved by one deviation of the noise along the
//! surface towards the sensor. If the cosine c between normal and direction to the sensor is still
//! negative, a row holds the distance to the rim to first order, `-c / (|grad c| - c)`, up to a
//! few deviations: a flat side has no slope that told how far its edge is.

use nalgebra::Vector3;

use crate::cloud::PointColumns;
use crate::model::Model;
use crate::recover::descent::PointSet;
use crate::recover::geometric::normal_log_gradient;
use crate::recover::kernel::{self, Gram, ModelView, Residual};
use crate::recover::normalization::Normalization;
use crate::recover::radial::PARAMETERS;
use crate::recover::subset::Subset;
use crate::shape::GaugeTerms;

/// Points that stand for all.
const POINTS: usize = 300;

/// The most that a row holds, in deviations of the noise.
const MOST_DEVIATIONS: f64 = 2.0;

/// Share of the points turned away from any direction, from which on they are not of one side.
const MOST_AWAY: f64 = 0.2;

/// Length of the mean normal below which they face all directions: over a hemisphere it is 0.5.
const CANCELLED: f64 = 0.1;

/// Steps in the search for a direction, and the first one.
const STEPS: usize = 40;
const FIRST_STEP: f64 = 4.0;

/// Coordinates in the model's frame nearer to a plane of symmetry than this count as so near: the
/// normal of a ridge turns there at once.
const RIDGE: f64 = 0.03;

/// Points, and from where each was seen, in normalised coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Facing(Vec<Seen>);

/// A point, and the unit vector from it towards the sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seen {
    pub point: Vector3<f64>,
    pub to_sensor: Vector3<f64>,
}

impl Facing {
    /// Of points seen from a viewpoint, all in the cloud's coordinates.
    pub fn from_viewpoint(
        viewpoint: [f64; 3],
        points: PointColumns,
        normalization: &Normalization,
    ) -> Self {
        let viewpoint = normalization.normalized(viewpoint);
        let seen = |point: Vector3<f64>| {
            let to_sensor = (viewpoint - point).try_normalize(0.0)?;
            Some(Seen { point, to_sensor })
        };
        Self(sample(points, normalization).filter_map(seen).collect())
    }

    /// Of points all of which were seen from far off in one direction, if around a model most of them
    /// face one: that from which they are turned away the least.
    pub fn one_side(model: &Model, points: &PointSet) -> Option<Self> {
        let to_sensor = direction_faced_around(model, points)?;
        let seen = |point| Seen { point, to_sensor };
        Some(Self(sample(points.points, points.normalization).map(seen).collect()))
    }

    /// In the coordinates of another normalisation of the same cloud.
    pub fn renormalized(&self, from: &Normalization, to: &Normalization) -> Self {
        let there = |seen: &Seen| Seen { point: to.point_of(from, &seen.point), ..*seen };
        Self(self.0.iter().map(there).collect())
    }

    /// Of one point in so many.
    pub fn thinned(&self, every: usize) -> Self {
        Self(self.0.iter().step_by(every).copied().collect())
    }

    /// Adds a row for each point that is on a side turned away: together the points stand for others
    /// of that weight, whose distances are in the Gram matrix.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        let root = (weight / self.0.len() as f64).sqrt();
        let deviation = (gram.geometric_squares / weight).sqrt();
        // Few are: the others need no more than their normals.
        let is_away = are_turned_away(&self.0, model);
        for (seen, _) in self.0.iter().zip(is_away).filter(|(_, is_away)| *is_away) {
            if let Some((beyond_rim, gradient)) = seen.beyond_rim(model, deviation) {
                gram.add_row(root * beyond_rim, &gradient.map(|slope| root * slope));
            }
        }
    }
}

/// Whether each point is on a side of a model that is turned away, be it by noise.
pub(super) fn are_turned_away(seen: &[Seen], model: &Model) -> Vec<bool> {
    let in_frame = |seen: &Seen| off_planes(model.pose.model_from_world(&seen.point));
    let points: Subset = seen.iter().map(in_frame).collect();
    let view = ModelView::of_shape(&model.shape);
    let normals = kernel::normals(&view, points.columns());
    let turn = model.pose.rotation().inverse();
    let is_away = |(seen, normal): (&Seen, [f64; 3])| {
        Vector3::from(normal).dot(&(turn * seen.to_sensor)) < 0.0
    };
    seen.iter().zip(normals).map(is_away).collect()
}

/// Points that stand for all, in normalised coordinates.
fn sample(
    points: PointColumns,
    normalization: &Normalization,
) -> impl Iterator<Item = Vector3<f64>> {
    let few = Subset::stratified(points, POINTS, 0);
    let few = Subset::normalized(few.columns(), normalization);
    (0..few.columns()[0].len()).map(move |i| few.columns().map(|column| column[i]).into())
}

/// The direction from which points around a model are turned away the least, if most of them face it.
pub(super) fn direction_faced_around(model: &Model, points: &PointSet) -> Option<Vector3<f64>> {
    let few = Subset::stratified(points.points, POINTS, 0);
    let view = ModelView::new(points.normalization, model, Residual::Geometric);
    let normals: Vec<Vector3<f64>> =
        kernel::normals(&view, few.columns()).into_iter().map(Vector3::from).collect();
    let to_sensor = direction_faced(&normals)?;
    let away = normals.iter().filter(|normal| normal.dot(&to_sensor) < 0.0).count();
    let is_faced = (away as f64) < MOST_AWAY * normals.len() as f64;
    is_faced.then(|| model.pose.rotation() * to_sensor)
}

/// The direction from which normals are turned away the least, by the sum of their cosines: steps
/// along the sum of those that are. None if they cancel.
fn direction_faced(normals: &[Vector3<f64>]) -> Option<Vector3<f64>> {
    let least_sum = CANCELLED * normals.len() as f64;
    let mut direction = normals.iter().sum::<Vector3<f64>>().try_normalize(least_sum)?;
    let mut best = (f64::INFINITY, direction);
    for step in 1..=STEPS {
        let is_away = |normal: &&Vector3<f64>| normal.dot(&direction) < 0.0;
        let away: Vector3<f64> = normals.iter().filter(is_away).sum();
        let cosines = -away.dot(&direction);
        if cosines < best.0 {
            best = (cosines, direction);
        }
        let length = FIRST_STEP / (step * normals.len()) as f64;
        direction = (direction + length * away).try_normalize(0.0)?;
    }
    Some(best.1)
}

impl Seen {
    /// How far beyond the rim of a model the point is, less one deviation of the noise, and its
    /// derivatives by the local parameters while the slope of the cosine stays. None on this side.
    fn beyond_rim(&self, model: &Model, deviation: f64) -> Option<(f64, [f64; PARAMETERS])> {
        let away = self.still_away(model, deviation)?;
        let by_cosine = away.gradient(model);
        let slope = away.slope(&by_cosine);
        let distance = -away.cosine / slope;
        // Saturates as d / (1 + (d / most)^2)^(1/2).
        let saturation = 1.0 + (distance / (MOST_DEVIATIONS * deviation)).powi(2);
        let of_cosine = -1.0 / (slope * saturation * saturation.sqrt());
        Some((distance / saturation.sqrt(), by_cosine.map(|by| of_cosine * by)))
    }

    /// How far beyond the rim of a model the point is, less one deviation of the noise, to first order,
    /// and the cosine there, which is negative. None on this side.
    pub(super) fn away(&self, model: &Model, deviation: f64) -> Option<(f64, f64)> {
        let away = self.still_away(model, deviation)?;
        Some((-away.cosine / away.slope(&away.gradient(model)), away.cosine))
    }

    /// The point moved by one deviation along the surface towards the sensor, if it and the place where
    /// it is then are turned away.
    fn still_away(&self, model: &Model, deviation: f64) -> Option<Turned> {
        let x = model.pose.model_from_world(&self.point);
        let to_sensor = model.pose.rotation().inverse() * self.to_sensor;
        let here = Turned::at(x, model, to_sensor);
        if here.cosine >= 0.0 {
            return None;
        }
        let along_surface = (to_sensor - here.cosine * here.normal).try_normalize(0.0)?;
        let moved = Turned::at(x + deviation * along_surface, model, to_sensor);
        (moved.cosine < 0.0).then_some(moved)
    }
}

/// How the normal at a point is turned to the sensor, in the model's frame.
struct Turned {
    x: Vector3<f64>,
    terms: GaugeTerms,
    normal: Vector3<f64>,
    to_sensor: Vector3<f64>,
    cosine: f64,
}

/// The place beside the planes of symmetry whose normal stands for a point's, in the model's frame.
fn off_planes(x: Vector3<f64>) -> Vector3<f64> {
    x.map(|x| x.abs().max(RIDGE).copysign(x))
}

impl Turned {
    fn at(x: Vector3<f64>, model: &Model, to_sensor: Vector3<f64>) -> Self {
        let x = off_planes(x);
        let terms = GaugeTerms::at(x.into(), &model.shape.size(), &model.shape.exponents());
        let normal = Vector3::from_fn(|i, _| terms.weights[i] / x[i]).normalize();
        Self { x, terms, normal, to_sensor, cosine: normal.dot(&to_sensor) }
    }

    /// Change of the cosine on the way to the rim, by length.
    fn slope(&self, by_cosine: &[f64; PARAMETERS]) -> f64 {
        Vector3::from_column_slice(&by_cosine[8..]).norm() - self.cosine
    }

    /// Derivatives of the cosine by the local parameters: `d c = sum w_i d ln |n_i| + n . d v`, with
    /// `w_i = n_i (v_i - c n_i)`.
    fn gradient(&self, model: &Model) -> [f64; PARAMETERS] {
        let Self { x, terms, normal, to_sensor, cosine } = self;
        let weights = normal.component_mul(&(to_sensor - *cosine * normal));
        let exponents = model.shape.exponents();
        let mut gradient = normal_log_gradient(terms, (*x).into(), &exponents, weights.into());
        for (slope, turn) in gradient[5..8].iter_mut().zip(&normal.cross(to_sensor)) {
            *slope += turn;
        }
        gradient
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Rotation3;

    use super::*;
    use crate::pose::Pose;
    use crate::shape::Superellipsoid;

    /// After a step of one local parameter.
    fn stepped(model: &Model, k: usize, step: f64) -> Model {
        let (mut size, mut exponents) = (model.shape.size(), model.shape.exponents());
        let (mut rotation, mut translation) = (*model.pose.rotation(), *model.pose.translation());
        match k {
            0..3 => size[k] *= step.exp(),
            3..5 => exponents[k - 3] += step,
            5..8 => rotation *= Rotation3::new(Vector3::ith(k - 5, step)),
            _ => translation += rotation * Vector3::ith(k - 8, step),
        }
        let shape = Superellipsoid::new(size, exponents).unwrap();
        Model { shape, pose: Pose::new(rotation, translation) }
    }

    #[test]
    fn derivatives_of_the_cosine_are_difference_quotients() {
        const STEP: f64 = 1e-6;
        let model = Model {
            shape: Superellipsoid::new([1.0, 0.7, 1.4], [0.6, 1.5]).unwrap(),
            pose: Pose::from_euler_zyz([0.3, 0.7, 0.2], Vector3::new(0.2, -0.1, 0.3)),
        };
        let turned = |model: &Model| {
            let x = model.pose.model_from_world(&Vector3::new(0.9, 0.5, 0.8));
            let to_sensor = Vector3::new(0.3, -1.0, 0.4).normalize();
            Turned::at(x, model, model.pose.rotation().inverse() * to_sensor)
        };
        for (k, slope) in turned(&model).gradient(&model).into_iter().enumerate() {
            let cosine = |step: f64| turned(&stepped(&model, k, step)).cosine;
            let expected = (cosine(STEP) - cosine(-STEP)) / (2.0 * STEP);
            assert!((slope - expected).abs() < 1e-7, "{k}: {slope} {expected}");
        }
    }

    fn sphere() -> Model {
        let shape = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        Model { shape, pose: Pose::identity() }
    }

    #[test]
    fn what_faces_the_sensor_has_no_row_and_what_is_turned_away_its_distance_from_the_rim() {
        const DEVIATION: f64 = 0.01;
        let to_sensor = Vector3::new(1.0, 1.0, 1.0).normalize();
        let across = Vector3::new(0.8, -0.3, -0.5).normalize();
        let seen = |height: f64| {
            let point = (1.0 - height * height).sqrt() * across + height * to_sensor;
            Seen { point, to_sensor }.beyond_rim(&sphere(), DEVIATION)
        };
        assert!(seen(0.5).is_none());
        // Noise alone may have moved it there.
        assert!(seen(-0.9 * DEVIATION).is_none());
        let (distance, _) = seen(-1.5 * DEVIATION).unwrap();
        let saturated = 0.5 * DEVIATION / (1.0_f64 + (0.25_f64).powi(2)).sqrt();
        assert!((distance - saturated).abs() < 0.02 * DEVIATION, "{distance} {saturated}");
        let (far, _) = seen(-0.9).unwrap();
        assert!(far < MOST_DEVIATIONS * DEVIATION && far > 0.9 * MOST_DEVIATIONS * DEVIATION);
    }

    #[test]
    fn the_direction_that_all_normals_face_is_found() {
        let (tilted, wide) = (Vector3::new(1.0, 0.2, 0.1), Vector3::new(-0.9, 1.0, 0.0));
        // One kind is turned away from their mean.
        let normals = [[tilted.normalize(); 60].to_vec(), [wide.normalize(); 25].to_vec()].concat();
        let direction = direction_faced(&normals).unwrap();
        let least = normals.iter().map(|normal| normal.dot(&direction)).fold(1.0, f64::min);
        assert!(least > -0.02, "{least}");
        assert!(direction_faced(&[Vector3::x(), -Vector3::x()]).is_none());
    }
}
