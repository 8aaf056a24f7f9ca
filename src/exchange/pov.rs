//! POV-Ray: a scene with the solid, to be rendered or included.
//!
//! Its `superellipsoid` is the unit shape with `<e2, e1>`, which is scaled, turned and moved. Its
//! root finder breaks below 0.1. Its world is left-handed only by the usual camera's: with
//! `right` reversed the picture is that of ours.

use super::particle::joined;
use crate::model::Model;

/// The scene is drawn to a unit: POV-Ray drops intersections nearer than 1e-4.
const SCENE: &str = include_str!("scene.pov");

/// Domain: exponents from 0.1.
pub(super) fn write(model: &Model) -> String {
    let [e1, e2] = model.shape.exponents();
    // POV-Ray's matrix has the images of the axes as rows: nalgebra's columns, one by one.
    let axes = model.pose.rotation().matrix().as_slice();
    SCENE
        .replace("@EXPONENTS@", &joined(&[e2, e1], ", "))
        .replace("@SIZE@", &joined(&model.shape.size(), ", "))
        .replace("@AXES@", &joined(axes, ", "))
        .replace("@CENTRE@", &joined(model.pose.translation().as_slice(), ", "))
        .replace("@RADIUS@", &format!("{:?}", half_diagonal(model.shape.size())))
}

/// Half the diagonal of the solid's box, with neither overflow nor underflow.
fn half_diagonal([a1, a2, a3]: [f64; 3]) -> f64 {
    a1.hypot(a2).hypot(a3)
}
