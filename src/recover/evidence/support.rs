//! Support: an object that stands on a plane reaches down to it and not below.
//!
//! The lowest point of the solid above the plane `n.x + delta = 0` is `n.p + delta - s(R'n)` away
//! from it, s being the support function, which is even. One row holds that distance.

use nalgebra::Vector3;

use crate::model::Model;
use crate::recover::kernel::Gram;
use crate::recover::normalization::Normalization;
use crate::recover::plane::Plane;
use crate::recover::radial::PARAMETERS;
use crate::shape::GaugeTerms;

/// Weight of the row in that of all points.
const WEIGHT: f64 = 0.1;

/// Least exponent of the polar: at 0 its gauge has edges everywhere.
const LEAST_EXPONENT: f64 = 1e-6;

/// The plane on which the object stands, in normalised coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Support {
    /// Unit vector to the object's side.
    pub normal: Vector3<f64>,
    offset: f64,
}

impl Support {
    /// A plane of the cloud's coordinates.
    pub fn new(plane: &Plane, normalization: &Normalization) -> Self {
        let normal = Vector3::from(plane.normal());
        let height = plane.height(normalization.centroid);
        Self { normal, offset: height * normalization.inverse_radius }
    }

    /// In the coordinates of another normalisation of the same cloud.
    pub fn renormalized(&self, from: &Normalization, to: &Normalization) -> Self {
        let centroid = from.normalized(to.centroid);
        let height = self.normal.dot(&centroid) + self.offset;
        Self { offset: height * from.radius * to.inverse_radius, ..*self }
    }

    /// Adds the row of a model.
    pub fn add_to(&self, gram: &mut Gram, model: &Model, weight: f64) {
        let root = (WEIGHT * weight).sqrt();
        let (gap, gradient) = self.gap(model);
        gram.add_row(root * gap, &gradient.map(|slope| root * slope));
    }

    /// The distance of the solid's lowest point from the plane, and its derivatives by the local
    /// parameters of the rows.
    fn gap(&self, model: &Model) -> (f64, [f64; PARAMETERS]) {
        let n = model.pose.rotation().inverse() * self.normal;
        let polar_size = model.shape.size().map(f64::recip);
        let polar_exponents = model.shape.exponents().map(|e| (2.0 - e).max(LEAST_EXPONENT));
        let terms = GaugeTerms::at(n.into(), &polar_size, &polar_exponents);
        let support = terms.inverse.recip();
        let shares = Vector3::from(terms.weights);
        let foot =
            Vector3::from_fn(|i, _| if n[i] == 0.0 { 0.0 } else { support * shares[i] / n[i] });
        let turn = n.cross(&foot);
        let [by_e1, by_e2] = terms.exponent_slopes.map(|slope| 0.5 * support * slope);
        let gap = self.normal.dot(model.pose.translation()) + self.offset - support;
        let by_size = -support * shares;
        let gradient =
            [by_size.x, by_size.y, by_size.z, by_e1, by_e2, turn.x, turn.y, turn.z, n.x, n.y, n.z];
        (gap, gradient)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::recover::chart::Chart;
    use crate::recover::constraints::NormalizedConstraints;
    use crate::shape::Superellipsoid;
    use crate::surface::sample_surface;

    fn plane() -> Support {
        let plane = Plane::new([0.2, -0.3, 0.9], 0.4).unwrap();
        Support::new(&plane, &Normalization::identity())
    }

    fn model() -> Model {
        Model {
            shape: Superellipsoid::new([1.2, 0.7, 0.4], [0.3, 1.4]).unwrap(),
            pose: Pose::from_euler_zyz([0.5, 1.0, -2.0], Vector3::new(0.2, -0.1, 0.3)),
        }
    }

    #[test]
    fn the_gap_is_the_least_height_of_the_surface() {
        let (plane, model) = (plane(), model());
        let heights = sample_surface(&model.shape, 50_000, 1)
            .into_iter()
            .map(|x| plane.normal.dot(&model.pose.world_from_model(&x)) + plane.offset);
        let least = heights.fold(f64::INFINITY, f64::min);
        let (gap, _) = plane.gap(&model);
        assert!(gap <= least && gap > least - 0.01, "{gap} {least}");
    }

    #[test]
    fn the_gradient_is_that_of_the_gap() {
        let (chart, origin) = Chart::around(&model(), &NormalizedConstraints::NONE);
        let (_, gradient) = plane().gap(&model());
        let local = chart.local_from_coordinates(&origin, model().pose.rotation());
        let gradient = local.transpose() * nalgebra::SVector::from(gradient);
        for k in 0..PARAMETERS {
            let at = |step: f64| {
                let mut moved = origin;
                moved[k] += step;
                plane().gap(&chart.model(&moved).unwrap()).0
            };
            let quotient = (at(1e-6) - at(-1e-6)) / 2e-6;
            assert!((gradient[k] - quotient).abs() < 1e-7, "{k}: {gradient} {quotient}");
        }
    }

    #[test]
    fn another_normalisation_has_the_same_plane() {
        let from = Normalization { centroid: [1.0, 2.0, 3.0], radius: 2.0, inverse_radius: 0.5 };
        let to = Normalization { centroid: [-1.0, 0.0, 3.5], radius: 4.0, inverse_radius: 0.25 };
        let plane = Plane::new([0.2, -0.3, 0.9], 0.4).unwrap();
        let direct = Support::new(&plane, &to);
        let indirect = Support::new(&plane, &from).renormalized(&from, &to);
        assert!((direct.offset - indirect.offset).abs() < 1e-14);
    }
}
