//! The axes of a solid, as lines that reach out of it.

use nalgebra::Vector3;

use crate::solid::{Primitive, Tree};

/// How far the axes reach, in what the solid reaches along them.
const REACH: f64 = 1.3;

/// The axes x, y and z of the one primitive that a solid is, as lines from its centre, in the
/// frame of the solid; none for solids of several.
pub fn axes(solid: &Tree) -> Option<[[Vector3<f64>; 2]; 3]> {
    let Tree::Leaf(Primitive { deformed, pose }) = solid else { return None };
    let axis = |axis: Vector3<f64>| {
        let tip = REACH * deformed.support(&axis) * axis;
        [Vector3::zeros(), tip].map(|x| pose.world_from_model(&x))
    };
    Some([Vector3::x(), Vector3::y(), Vector3::z()].map(axis))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::pose::Pose;
    use crate::shape::{Shape, Superellipsoid, Supertoroid};

    #[test]
    fn axes_reach_out_of_the_solid_along_its_own_directions() {
        let pose = Pose::from_euler_zyz([0.3, 1.2, -0.5], Vector3::new(1.0, 2.0, 3.0));
        let of = |shape: Shape| axes(&Primitive::from(Model { shape, pose }).into()).unwrap();
        let torus = Supertoroid::new([1.0, 2.0, 0.5], [1.0, 1.0], 3.0).unwrap();
        let ball = Superellipsoid::new([4.0, 8.0, 0.5], [0.3, 1.0]).unwrap();
        for shape in [torus.into(), ball.into()] {
            for (i, reach) in [4.0, 8.0, 0.5].into_iter().enumerate() {
                let [start, tip] = of(shape)[i];
                assert_eq!(start, *pose.translation());
                let expected = 1.3 * reach * pose.rotation().matrix().column(i);
                assert!((tip - start - expected).norm() < 1e-12);
            }
        }
    }

    #[test]
    fn solids_of_several_have_no_axes() {
        assert_eq!(axes(&Tree::Union(Vec::new())), None);
    }
}
