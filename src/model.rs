//! A shape in general position (JLS section 2.3).

use nalgebra::Vector3;

use crate::error::ModelError;
use crate::pose::Pose;
use crate::shape::{MassProperties, Shape, Solid, Superellipsoid};

/// A shape and where it stands in the world: a superellipsoid if nothing else is said.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Model<S = Superellipsoid> {
    /// The shape, in its own frame.
    pub shape: S,
    /// The motion from the shape's frame to the world.
    pub pose: Pose,
}

impl Model {
    /// The eleven parameters `a1 a2 a3 e1 e2 phi theta psi px py pz` (JLS Eq. 2.35).
    pub fn parameters(&self) -> [f64; 11] {
        let [a1, a2, a3] = self.shape.size();
        let [e1, e2] = self.shape.exponents();
        let [phi, theta, psi] = self.pose.euler_zyz();
        let [px, py, pz] = (*self.pose.translation()).into();
        [a1, a2, a3, e1, e2, phi, theta, psi, px, py, pz]
    }

    /// The gauge `F^(e1/2)` at a point of the world.
    pub fn gauge(&self, x_world: &Vector3<f64>) -> f64 {
        self.shape.gauge(&self.pose.model_from_world(x_world))
    }
}

impl From<Model> for Model<Shape> {
    fn from(Model { shape, pose }: Model) -> Self {
        Self { shape: shape.into(), pose }
    }
}

impl Model<Shape> {
    /// The [dual](Shape::dual) of the shape, turned as the shape is, at the origin: normals of the
    /// world, of the right length, lie on it.
    ///
    /// # Errors
    /// If the shape has no dual.
    pub fn dual(&self) -> Result<Self, ModelError> {
        let pose = Pose::new(*self.pose.rotation(), Vector3::zeros());
        Ok(Self { shape: self.shape.dual()?, pose })
    }
}

impl<S: Solid> Model<S> {
    /// The inside-outside function F at a point of the world (JLS Eq. 2.33).
    pub fn inside_outside(&self, x_world: &Vector3<f64>) -> f64 {
        self.shape.inside_outside(&self.pose.model_from_world(x_world))
    }

    /// Whether a point of the world is inside.
    pub fn contains(&self, x_world: &Vector3<f64>) -> bool {
        self.shape.contains(&self.pose.model_from_world(x_world))
    }

    /// Signed radial Euclidean distance of a point of the world (JLS Eq. 2.43).
    pub fn radial_distance(&self, x_world: &Vector3<f64>) -> f64 {
        self.shape.radial_distance(&self.pose.model_from_world(x_world))
    }

    /// The support function `max { n . x : x in the solid }` for a direction of the world.
    pub fn support(&self, n_world: &Vector3<f64>) -> f64 {
        let n_model = self.pose.rotation().inverse_transform_vector(n_world);
        n_world.dot(self.pose.translation()) + self.shape.support(&n_model)
    }

    /// Volume, centroid and second moments of unit density, in the world's frame.
    pub fn mass_properties(&self) -> MassProperties {
        self.shape.mass_properties().transformed(&self.pose)
    }

    /// The least box along the world's axes that holds the solid: `[min, max]`.
    pub fn bounding_box(&self) -> [Vector3<f64>; 2] {
        let greatest = |n: Vector3<f64>| self.support(&n);
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        [Vector3::from(axes.map(|axis| -greatest(-axis))), Vector3::from(axes.map(greatest))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model() -> Model {
        Model {
            shape: Superellipsoid::new([2.0, 1.0, 0.5], [0.4, 1.3]).unwrap(),
            pose: Pose::from_euler_zyz([0.3, 1.1, -0.8], Vector3::new(4.0, -2.0, 7.0)),
        }
    }

    #[test]
    fn surface_points_of_the_world_have_gauge_one_and_distance_zero() {
        let model = model();
        for (eta, omega) in [(0.1, 0.2), (-1.2, 3.0), (0.7, -2.0)] {
            let x_world = model.pose.world_from_model(&model.shape.position(eta, omega));
            // Rounding of coordinates near 9 against a size of 0.5.
            assert!((model.gauge(&x_world) - 1.0).abs() < 1e-13);
            assert!(model.radial_distance(&x_world).abs() < 1e-13);
        }
    }

    #[test]
    fn bounding_box_is_touched_on_all_sides_by_the_surface() {
        let model = model();
        let [min, max] = model.bounding_box();
        let (mut least, mut greatest) = (max, min);
        for i in -300..=300 {
            for j in -300..300 {
                let (eta, omega) = (f64::from(i) / 300.0, f64::from(j) / 300.0);
                let (eta, omega) =
                    (eta * std::f64::consts::FRAC_PI_2, omega * std::f64::consts::PI);
                let x_world = model.pose.world_from_model(&model.shape.position(eta, omega));
                least = least.inf(&x_world);
                greatest = greatest.sup(&x_world);
            }
        }
        let slack = 1e-3; // half a grid step off the touching point
        assert!((0..3).all(|i| min[i] <= least[i] + 1e-12 && least[i] < min[i] + slack));
        assert!((0..3).all(|i| max[i] >= greatest[i] - 1e-12 && greatest[i] > max[i] - slack));
    }
}
