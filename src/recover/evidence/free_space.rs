//! Free space: a ray of the sensor that came through is not blocked by the solid before its end.
//!
//! Where the ray runs through the solid, a row holds the first-order geometric distance of its
//! deepest point; a ray that is free has none. A ray that ended on the object itself must have
//! entered the solid there: one that has come through the solid before is blocked. Such a ray
//! is as noisy as its point, and weighs no more.

use nalgebra::Vector3;

use crate::cloud::PointColumns;
use crate::model::Model;
use crate::recover::geometric::geometric_row;
use crate::recover::kernel::Gram;
use crate::recover::normalization::Normalization;
use crate::recover::sight::{Sight, SightLine};
use crate::shape::Superellipsoid;

/// Weight of all rays beside the object in that of all points: as in a view of 600 points and
/// 200 rays each of which weighs 100 times a point.
const WEIGHT_BESIDE: f64 = 33.0;

/// Rounds of the golden section that finds the deepest point.
const ROUNDS: usize = 30;

/// Rays of a sensor that came through, in normalised coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FreeSpace {
    viewpoint: Vector3<f64>,
    /// Those beside the object.
    beside: Vec<Ray>,
    /// Those that ended on it.
    onto: Vec<Ray>,
}

/// A ray by its direction, a unit vector, and the length over which it is free.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ray {
    direction: Vector3<f64>,
    reach: f64,
}

impl FreeSpace {
    /// That of a sensor whose other rays ended on these points of the object, in normalised
    /// coordinates.
    pub fn new(sight: &Sight, hits: PointColumns, normalization: &Normalization) -> Self {
        let viewpoint = normalization.normalized(sight.viewpoint);
        let beside = |line: &SightLine| {
            let direction = Vector3::from(line.direction).try_normalize(0.0)?;
            Some(Ray { direction, reach: line.reach * normalization.inverse_radius })
        };
        let onto = |i: usize| {
            let offset = normalization.normalized(hits.map(|column| column[i])) - viewpoint;
            Some(Ray { direction: offset.try_normalize(0.0)?, reach: offset.norm() })
        };
        Self {
            viewpoint,
            beside: sight.free.iter().filter_map(beside).collect(),
            onto: (0..hits[0].len()).filter_map(onto).collect(),
        }
    }

    /// In the coordinates of another normalisation of the same cloud.
    pub fn renormalized(&self, from: &Normalization, to: &Normalization) -> Self {
        let ratio = from.radius * to.inverse_radius;
        let scaled = |rays: &[Ray]| {
            rays.iter().map(|ray| Ray { reach: ray.reach * ratio, ..*ray }).collect()
        };
        Self {
            viewpoint: to.point_of(from, &self.viewpoint),
            beside: scaled(&self.beside),
            onto: scaled(&self.onto),
        }
    }

    /// Without the rays that ended on the object.
    pub fn beside_only(&self) -> Self {
        Self { onto: Vec::new(), ..self.clone() }
    }

    /// Adds a row for each ray that the model blocks.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        let weight_beside = WEIGHT_BESIDE * weight / self.beside.len() as f64;
        self.add_rows(&self.beside, weight_beside, gram, model);
        self.add_rows(&self.onto, 1.0, gram, model);
    }

    fn add_rows(&self, rays: &[Ray], weight: f64, gram: &mut Gram, model: &Model) {
        let root = weight.sqrt();
        let (size, exponents) = (model.shape.size(), model.shape.exponents());
        let origin = model.pose.model_from_world(&self.viewpoint);
        let turn = model.pose.rotation().inverse();
        for ray in rays {
            let line = Line { shape: &model.shape, origin, direction: turn * ray.direction };
            if let Some(deepest) = line.deepest_point(ray.reach) {
                let row = geometric_row(deepest.into(), &size, &exponents);
                gram.add_row(root * row.distance, &row.gradient.map(|slope| root * slope));
            }
        }
    }
}

/// A ray in a shape's frame.
struct Line<'a> {
    shape: &'a Superellipsoid,
    origin: Vector3<f64>,
    direction: Vector3<f64>,
}

impl Line<'_> {
    fn at(&self, t: f64) -> Vector3<f64> {
        self.origin + self.direction * t
    }

    /// The deepest point by the first-order geometric distance, if the solid has been entered and
    /// is being left, or has been left, where the ray ends.
    fn deepest_point(&self, reach: f64) -> Option<Vector3<f64>> {
        const GOLDEN: f64 = 0.618_033_988_749_895;
        let [mut low, mut high] = self.within_box(reach)?;
        let is_entering = self.shape.gauge_gradient(&self.at(high)).dot(&self.direction) <= 0.0;
        if is_entering && high == reach {
            return None;
        }
        let distance = |t: f64| {
            let x = self.at(t);
            (self.shape.gauge(&x) - 1.0) / self.shape.gauge_gradient(&x).norm()
        };
        let (mut left, mut right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        let (mut at_left, mut at_right) = (distance(left), distance(right));
        for _ in 0..ROUNDS {
            if at_left < at_right {
                (high, right, at_right) = (right, left, at_left);
                left = high - GOLDEN * (high - low);
                at_left = distance(left);
            } else {
                (low, left, at_left) = (left, right, at_right);
                right = low + GOLDEN * (high - low);
                at_right = distance(right);
            }
        }
        let (t, deepest) = if at_left < at_right { (left, at_left) } else { (right, at_right) };
        (deepest < 0.0).then(|| self.at(t))
    }

    /// From where to where the ray is within the shape's box.
    fn within_box(&self, reach: f64) -> Option<[f64; 2]> {
        let (mut low, mut high) = (0.0_f64, reach);
        for (k, side) in self.shape.size().into_iter().enumerate() {
            if self.direction[k] == 0.0 {
                if self.origin[k].abs() > side {
                    return None;
                }
                continue;
            }
            let ends = [-side, side].map(|end| (end - self.origin[k]) / self.direction[k]);
            low = low.max(ends[0].min(ends[1]));
            high = high.min(ends[0].max(ends[1]));
        }
        (low < high).then_some([low, high])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;

    fn sphere(x: f64) -> Model {
        let shape = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        let pose = Pose::new(*Pose::identity().rotation(), Vector3::new(x, 0.0, 0.0));
        Model { shape, pose }
    }

    fn along_z(reach: f64) -> FreeSpace {
        let free = vec![SightLine { direction: [0.0, 0.0, 2.0], reach }];
        let sight = Sight { viewpoint: [0.0, 0.0, -5.0], free };
        FreeSpace::new(&sight, [&[]; 3], &Normalization::identity())
    }

    fn onto_z(z: f64) -> FreeSpace {
        let sight = Sight::from_viewpoint([0.0, 0.0, -5.0]);
        FreeSpace::new(&sight, [&[0.0], &[0.0], &[z]], &Normalization::identity())
    }

    fn squares(space: &FreeSpace, model: &Model) -> f64 {
        let mut gram = Gram::zero();
        space.add_to(&mut gram, model, 1.0 / WEIGHT_BESIDE);
        assert_eq!(gram.evidence_squares, gram.residual_squares());
        gram.evidence_squares
    }

    #[test]
    fn a_ray_through_a_sphere_is_blocked_by_its_depth() {
        // The ray passes at distance 0.75 of the centre.
        for x in [0.75, -0.75] {
            let square = squares(&along_z(f64::INFINITY), &sphere(x));
            assert!((square.sqrt() - 0.25).abs() < 1e-9, "{square}");
        }
        assert_eq!(squares(&along_z(f64::INFINITY), &sphere(1.001)), 0.0);
    }

    #[test]
    fn a_ray_may_enter_where_it_ends_but_not_before() {
        // The sphere about the origin begins at z = -1 and is deepest at 0.
        assert_eq!(squares(&onto_z(-1.1), &sphere(0.1)), 0.0);
        assert_eq!(squares(&onto_z(-0.5), &sphere(0.1)), 0.0);
        for end in [0.5, 2.0] {
            let square = squares(&onto_z(end), &sphere(0.1));
            assert!((square.sqrt() - 0.9).abs() < 1e-6, "{square}");
        }
        assert_eq!(squares(&along_z(3.9), &sphere(0.1)), 0.0);
    }

    #[test]
    fn the_gradient_is_that_of_the_distance() {
        let space = along_z(f64::INFINITY);
        let shape = Superellipsoid::new([1.0, 0.8, 1.3], [0.6, 1.4]).unwrap();
        let at = |x: f64, size: f64| {
            let pose = Pose::from_euler_zyz([0.3, 0.7, 0.2], Vector3::new(x, 0.1, 0.2));
            let model = Model { shape: shape.scaled(size), pose };
            let mut gram = Gram::zero();
            space.add_to(&mut gram, &model, 1.0 / WEIGHT_BESIDE);
            (gram, model)
        };
        let (gram, model) = at(0.6, 1.0);
        assert!(gram.evidence_squares > 0.0);
        const STEP: f64 = 1e-5;
        // Half the derivative of the square. The deepest point moves, which does not count.
        let by_scale = (at(0.6, 1.0 + STEP).0.evidence_squares
            - at(0.6, 1.0 - STEP).0.evidence_squares)
            / (4.0 * STEP);
        let sum: f64 = gram.matrix[0][1..4].iter().sum();
        assert!((sum - by_scale).abs() < 1e-5, "{sum} {by_scale}");
        let by_x = (at(0.6 + STEP, 1.0).0.evidence_squares
            - at(0.6 - STEP, 1.0).0.evidence_squares)
            / (4.0 * STEP);
        let local = Vector3::from_column_slice(&gram.matrix[0][9..12]);
        let slope = (model.pose.rotation() * local).x;
        assert!((slope - by_x).abs() < 1e-5, "{slope} {by_x}");
    }
}
