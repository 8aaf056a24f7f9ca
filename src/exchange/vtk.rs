//! VTK: a Python program that builds the surface by either of VTK's sources.
//!
//! `vtkParametricSuperEllipsoid` has `N1 = e1`, `N2 = e2` and semi-axes; `vtkSuperquadricSource`
//! has `PhiRoundness = e1`, `ThetaRoundness = e2`, semi-axes `Scale * Size`, and its axis along y
//! unless told otherwise.

use super::particle::joined;
use crate::model::Model;

const PROGRAM: &str = include_str!("vtk.py");

pub(super) fn write(model: &Model) -> String {
    let rotation = model.pose.rotation().matrix();
    let centre = model.pose.translation();
    let rows = [0, 1, 2]
        .map(|i| joined(&[rotation[(i, 0)], rotation[(i, 1)], rotation[(i, 2)], centre[i]], ", "));
    PROGRAM
        .replace("@SIZE@", &joined(&model.shape.size(), ", "))
        .replace("@EXPONENTS@", &joined(&model.shape.exponents(), ", "))
        .replace("@WORLD_FROM_MODEL@", &rows.join(",\n    "))
}
