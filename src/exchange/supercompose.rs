//! SuperCompose: superquadrics of a scene in JSON, which SuperDec's programs write too.

use nalgebra::Matrix3;
use serde::{Deserialize, Serialize};

use super::error::ImportError;
use crate::error::ModelError;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Superellipsoid;

pub(super) const EXPECTED: &str = "{\"components\": [{scale, rotation, position, epsilon1, \
                                   epsilon2}]}";

#[derive(Debug, Serialize, Deserialize)]
struct Scene {
    components: Vec<Component>,
}

#[derive(Debug, Serialize, Deserialize)]
struct Component {
    scale: [f64; 3],
    /// Rows of the rotation from model to world.
    rotation: [[f64; 3]; 3],
    position: [f64; 3],
    epsilon1: f64,
    epsilon2: f64,
}

pub(super) fn write(model: &Model) -> String {
    let [epsilon1, epsilon2] = model.shape.exponents();
    let component = Component {
        scale: model.shape.size(),
        rotation: model.pose.rotation().matrix().transpose().into(),
        position: (*model.pose.translation()).into(),
        epsilon1,
        epsilon2,
    };
    let scene = Scene { components: vec![component] };
    // Keys are strings and values are finite numbers: that always has a JSON form.
    serde_json::to_string_pretty(&scene).expect("the scene is representable in JSON") + "\n"
}

pub(super) fn read(text: &str) -> Result<Vec<Model>, ImportError> {
    let scene: Scene = serde_json::from_str(text)
        .map_err(|source| ImportError::Json { expected: EXPECTED, source })?;
    let model = |(index, component): (usize, &Component)| {
        component.model().map_err(|source| ImportError::Parameters {
            place: format!("components[{index}]"),
            source,
        })
    };
    scene.components.iter().enumerate().map(model).collect()
}

impl Component {
    fn model(&self) -> Result<Model, ModelError> {
        let shape = Superellipsoid::new(self.scale, [self.epsilon1, self.epsilon2])?;
        let matrix = Matrix3::from_fn(|i, j| self.rotation[i][j]);
        Ok(Model { shape, pose: Pose::from_matrix(matrix, self.position.into())? })
    }
}
