//! How far points are from a solid, for a person to see.

use nalgebra::Vector3;

use super::part::convex;
use crate::math::{Dual, Interval};
use crate::model::Model;
use crate::shape::LevelSet;
use crate::solid::Tree;

/// Signed distances from a solid, negative inside: the radial one (JLS Eq. 2.43) from a convex
/// superellipsoid, which is what fits are told by; from any other the first-order one,
/// `(L - 1) / |grad L|` with L the solid's level, whose caps and cuts count too.
#[derive(Debug, Clone, Copy)]
pub enum Residual<'a> {
    /// From a convex superellipsoid.
    Radial(Model),
    /// From any solid.
    FirstOrder(&'a Tree),
}

impl<'a> Residual<'a> {
    /// The distances from a solid.
    pub fn of(solid: &'a Tree) -> Self {
        convex(solid).map_or(Self::FirstOrder(solid), Self::Radial)
    }

    /// What the distances are called.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Radial(_) => "radial distance",
            Self::FirstOrder(_) => "distance",
        }
    }

    /// The distance of a point of the solid's frame.
    pub fn at(&self, x: &Vector3<f64>) -> f64 {
        match self {
            Self::Radial(model) => model.radial_distance(x),
            Self::FirstOrder(solid) => {
                let excess = solid.level((*x).into()) - 1.0;
                if excess == 0.0 { 0.0 } else { excess / gradient(solid, x).norm() }
            }
        }
    }
}

fn gradient(solid: &Tree, x: &Vector3<f64>) -> Vector3<f64> {
    Vector3::from_fn(|axis, _| {
        let along = std::array::from_fn(|i| {
            let slope = if i == axis { Interval::point(1.0) } else { Interval::ZERO };
            Dual { value: Interval::point(x[i]), slope }
        });
        solid.level(along).slope.middle()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::ray::outward_normal;
    use crate::shape::{Shape, Superellipsoid, SuperhyperboloidOneSheet, Supertoroid};
    use crate::solid::Primitive;
    use crate::surface::{Resolution, tessellate_shape};

    #[test]
    fn a_little_off_the_surface_the_distance_is_the_offset() {
        let size = [1.0, 0.7, 0.4];
        let shapes: [Shape; 3] = [
            Superellipsoid::new([0.8; 3], [1.0; 2]).unwrap().into(),
            SuperhyperboloidOneSheet::new(size, [1.0, 0.8], 1.0).unwrap().into(),
            Supertoroid::new(size, [1.0, 1.0], 2.0).unwrap().into(),
        ];
        let pose = Pose::from_euler_zyz([0.3, 1.2, -0.5], Vector3::new(1.0, 2.0, 3.0));
        for shape in shapes {
            let solid = Tree::from(Primitive::from(Model { shape, pose }));
            let residual = Residual::of(&solid);
            let mesh = tessellate_shape(&shape, Resolution::new(8).unwrap()).transformed(&pose);
            // Within the triangles, where no two faces meet.
            for corners in mesh.corners() {
                let middle = corners.iter().sum::<Vector3<f64>>() / 3.0;
                let normal = outward_normal(&solid, &middle);
                let x = middle - residual.at(&middle) * normal;
                let foot = x - residual.at(&x) * normal;
                for offset in [-1e-4, 1e-4] {
                    let off = residual.at(&(foot + offset * normal)) / offset;
                    assert!((off - 1.0).abs() < 0.02, "{off} at {foot:?} of {shape:?}");
                }
            }
        }
    }
}
