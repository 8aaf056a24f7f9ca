//! Free space: a ray of the sensor that came through is not blocked by the solid before its end.
//!
//! Where the ray runs through the solid, a row holds the first-order geometric distance of its
//! deepest point; a ray that is free has none. A ray that ended on the object itself must have
//! entered the solid there: one that has come through the solid before is blocked. Such a ray
//! is as noisy as its point, and weighs no more.

use nalgebra::Vector3;

use super::deepest::{Line, deepest_points, not_entering};
use crate::cloud::PointColumns;
use crate::model::Model;
use crate::recover::kernel::{self, Gram, ModelView};
use crate::recover::normalization::Normalization;
use crate::recover::sight::{Sight, SightLine};

/// Weight of all rays beside the object in that of all points: as in a view of 600 points and
/// 200 rays each of which weighs 100 times a point.
const WEIGHT_BESIDE: f64 = 33.0;

/// Rays of a sensor that came through, in normalised coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FreeSpace {
    viewpoint: Vector3<f64>,
    /// Those beside the object.
    beside: Vec<Ray>,
    /// Those that ended on it.
    onto: Vec<Ray>,
    /// Weight of each of these: the rays that it stands for.
    weight_onto: f64,
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
            weight_onto: 1.0,
        }
    }

    /// Where the sensor stood.
    pub fn viewpoint(&self) -> Vector3<f64> {
        self.viewpoint
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
            weight_onto: self.weight_onto,
        }
    }

    /// Without the rays that ended on the object.
    pub fn beside_only(&self) -> Self {
        Self { onto: Vec::new(), ..self.clone() }
    }

    /// With one ray in so many.
    pub fn thinned(&self, every: usize) -> Self {
        let some = |rays: &[Ray]| rays.iter().step_by(every).copied().collect();
        Self {
            beside: some(&self.beside),
            onto: some(&self.onto),
            weight_onto: self.weight_onto * every as f64,
            ..*self
        }
    }

    /// Adds a row for each ray that the model blocks.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        let weight_beside = WEIGHT_BESIDE * weight / self.beside.len() as f64;
        self.add_rows(&self.beside, weight_beside, gram, model);
        self.add_rows(&self.onto, self.weight_onto, gram, model);
    }

    fn add_rows(&self, rays: &[Ray], weight: f64, gram: &mut Gram, model: &Model) {
        let shape = &model.shape;
        let origin = model.pose.model_from_world(&self.viewpoint);
        let turn = model.pose.rotation().inverse();
        let within = |ray: &Ray| Line::within_box(shape, origin, turn * ray.direction, ray.reach);
        let lines: Vec<Line> = rays.iter().filter_map(within).collect();
        let view = ModelView::of_shape(shape);
        let deepest = deepest_points(&view, not_entering(&view, lines));
        let deepest = deepest.columns();
        let roots = vec![weight.sqrt(); deepest[0].len()];
        gram.add_evidence(&kernel::gram(&view, deepest, Some(&roots), false));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::shape::Superellipsoid;

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
    fn of_rays_alike_a_part_weighs_as_much_as_all() {
        let sight = Sight {
            viewpoint: [0.0, 0.0, -5.0],
            free: vec![SightLine { direction: [0.0, 0.0, 1.0], reach: f64::INFINITY }; 6],
        };
        let hits = [0.0; 6];
        let all = FreeSpace::new(&sight, [&hits, &hits, &[2.0; 6]], &Normalization::identity());
        let [of_all, of_some] =
            [all.clone(), all.thinned(3)].map(|rays| squares(&rays, &sphere(0.1)));
        assert!(of_all > 0.0 && (of_some / of_all - 1.0).abs() < 1e-12, "{of_some} {of_all}");
        assert_eq!((all.thinned(3).beside.len(), all.thinned(3).onto.len()), (2, 2));
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
