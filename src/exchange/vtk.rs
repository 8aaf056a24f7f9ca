//! VTK: a Python program that builds the surface by either of VTK's sources.
//!
//! `vtkParametricSuperEllipsoid` has `N1 = e1`, `N2 = e2` and semi-axes; `vtkSuperquadricSource`
//! has `PhiRoundness = e1`, `ThetaRoundness = e2`, semi-axes `Scale * Size`, and its axis along y
//! unless told otherwise. Of a supertoroid `vtkParametricSuperToroid` has the exponents the other
//! way round, and `vtkSuperquadricSource` the outer semi-axes and the ring as `1 / Thickness`.

use super::error::ExportError;
use super::particle::joined;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Supertoroid;

const COMMON: &str = include_str!("vtk/common.py");
const SUPERELLIPSOID: &str = include_str!("vtk/superellipsoid.py");
const SUPERTOROID: &str = include_str!("vtk/supertoroid.py");

/// The greatest ring: VTK's least thickness is 1e-4.
const GREATEST_RING: f64 = 1e4;

/// The program of a superellipsoid.
pub(super) fn write(model: &Model) -> String {
    program(SUPERELLIPSOID, &model.shape.size(), &model.shape.exponents(), &model.pose)
}

/// The program of a supertoroid.
pub(super) fn write_toroid(shape: &Supertoroid, pose: &Pose) -> Result<String, ExportError> {
    let ring = shape.ring();
    if ring > GREATEST_RING {
        return Err(ExportError::Ring { program: "VTK", greatest: GREATEST_RING, value: ring });
    }
    let sources = SUPERTOROID.replace("@RING@", &format!("{ring:?}"));
    Ok(program(&sources, &shape.size(), &shape.exponents(), pose))
}

fn program(sources: &str, size: &[f64; 3], exponents: &[f64; 2], pose: &Pose) -> String {
    let rotation = pose.rotation().matrix();
    let centre = pose.translation();
    let rows = [0, 1, 2]
        .map(|i| joined(&[rotation[(i, 0)], rotation[(i, 1)], rotation[(i, 2)], centre[i]], ", "));
    COMMON
        .replace("@SOURCES@\n", sources)
        .replace("@SIZE@", &joined(size, ", "))
        .replace("@EXPONENTS@", &joined(exponents, ", "))
        .replace("@WORLD_FROM_MODEL@", &rows.join(",\n    "))
}
