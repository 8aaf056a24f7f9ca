//! Solids, lights and a camera in one world.

use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;

use super::half_line::Ray;
use super::render::{Rays, Rendering, render};
use super::shading::{Light, Material, Shading};
use super::solid_target::SolidTarget;
use crate::pose::Pose;
use crate::solid::Tree;
use crate::view::AnyCamera;

impl Rays for AnyCamera {
    fn ray(&self, column: f64, row: f64) -> Option<Ray> {
        match self {
            Self::Pinhole(camera) => Rays::ray(camera, column, row),
            Self::Orthographic(camera) => Rays::ray(camera, column, row),
        }
    }

    fn size(&self) -> [u32; 2] {
        self.size()
    }
}

/// A solid and what it is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// The solid, in the world's frame.
    pub solid: Tree,
    /// How it takes light.
    pub material: Material,
}

/// Lights of a world.
#[derive(Debug, Clone, PartialEq)]
pub struct Lighting {
    /// The lights, in the world's frame.
    pub lights: Vec<Light>,
    /// Red, green and blue of the light that comes from everywhere.
    pub ambient: [f64; 3],
}

/// Solids, lights and a camera in one world.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The solids; where several are, the nearest to the camera is seen.
    pub items: Vec<Item>,
    /// The camera.
    pub camera: Option<AnyCamera>,
    /// The motion from the world to the camera's frame.
    pub camera_from_world: Pose,
    /// The lights; if there are none, those of [`Shading::default`], which go with the camera.
    pub lighting: Option<Lighting>,
    /// Red, green and blue where nothing is hit.
    pub background: [u8; 3],
}

impl From<Tree> for Scene {
    /// A solid in a camera's frame.
    fn from(solid: Tree) -> Self {
        Self {
            items: vec![Item { solid, material: Material::default() }],
            camera: None,
            camera_from_world: Pose::identity(),
            lighting: None,
            background: Shading::default().background,
        }
    }
}

impl Scene {
    /// All solids as one, in the world's frame.
    pub fn solid(&self) -> Tree {
        match self.items.as_slice() {
            [item] => item.solid.clone(),
            items => Tree::Union(items.iter().map(|item| item.solid.clone()).collect()),
        }
    }

    /// What a camera in the scene's place sees; `on_row` is called after every row.
    pub fn rendering(&self, camera: &AnyCamera, on_row: impl Fn() + Sync) -> Rendering {
        render(&self.targets_after(&self.camera_from_world), camera, on_row)
    }

    /// The solids, in the world's frame, for rays to be shot at.
    pub fn targets(&self) -> Vec<SolidTarget> {
        self.targets_after(&Pose::identity())
    }

    fn targets_after(&self, motion: &Pose) -> Vec<SolidTarget> {
        let target = |item: &Item| SolidTarget::new(&item.solid.moved(motion));
        self.items.par_iter().map(target).collect()
    }

    /// The light on what the camera sees.
    pub fn shading(&self) -> Shading {
        let materials = self.items.iter().map(|item| item.material).collect();
        let background = self.background;
        match &self.lighting {
            None => Shading { materials, background, ..Shading::default() },
            Some(Lighting { lights, ambient }) => {
                let in_camera = |light: &Light| light.moved(&self.camera_from_world);
                let lights = lights.iter().map(in_camera).collect();
                Shading { lights, ambient: *ambient, materials, background }
            }
        }
    }
}

/// The motion from the world to the frame of a camera that stands at `eye` and looks at `target`,
/// with `up` upwards in the picture; none if they are all on a line.
pub fn camera_looking_at(
    eye: &Vector3<f64>,
    target: &Vector3<f64>,
    up: &Vector3<f64>,
) -> Option<Pose> {
    let forward = (target - eye).try_normalize(0.0)?;
    // Whatever the length of `up`, only its direction counts.
    let right = forward.cross(&up.try_normalize(0.0)?).try_normalize(f64::EPSILON)?;
    let down = forward.cross(&right);
    let rows = [right.transpose(), down.transpose(), forward.transpose()];
    let world_from_camera = Matrix3::from_rows(&rows).transpose();
    Some(Pose::from_matrix(world_from_camera, *eye).ok()?.inverse())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_sees_its_target_ahead_and_up_above() {
        let [eye, target, up] =
            [[3.0, -2.0, 1.5], [0.5, 0.25, -1.0], [0.1, 0.2, 3.0]].map(Vector3::from);
        let camera_from_world = camera_looking_at(&eye, &target, &up).unwrap();
        assert!(camera_from_world.world_from_model(&eye).norm() < 1e-15);
        let ahead = Vector3::new(0.0, 0.0, (target - eye).norm());
        assert!((camera_from_world.world_from_model(&target) - ahead).norm() < 1e-14);
        let above = camera_from_world.rotation() * up;
        assert!(above.x.abs() < 1e-15 && above.y < 0.0, "{above}");
    }

    #[test]
    fn without_a_direction_or_an_up_there_is_no_view() {
        let [eye, target] = [Vector3::zeros(), Vector3::x()];
        assert_eq!(camera_looking_at(&eye, &eye, &Vector3::z()), None);
        assert_eq!(camera_looking_at(&eye, &target, &Vector3::x()), None);
        assert_eq!(camera_looking_at(&eye, &target, &Vector3::zeros()), None);
        assert_eq!(camera_looking_at(&eye, &Vector3::from_element(f64::NAN), &Vector3::z()), None);
    }
}
