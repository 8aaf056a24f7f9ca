//! OVITO: dumps whose columns have the names of its own properties.
//!
//! Roundness is (Phi, Theta), Phi east-west, so `(e2, e1)`; quaternions are x y z w; the shape is
//! that of semi-axes. OVITO takes them for its properties without being told, but whoever looks
//! at them must choose the shape "Superquadric" in the particles' visual element.

use super::dump;
use super::error::ImportError;
use super::particle::{Particle, quaternion_wxyz};
use crate::model::Model;

pub(super) const EXPECTED: &str =
    "a dump with columns AsphericalShape, Orientation and SuperquadricRoundness";

const COLUMNS: &str = "x y z AsphericalShape.X AsphericalShape.Y AsphericalShape.Z \
                       Orientation.X Orientation.Y Orientation.Z Orientation.W \
                       SuperquadricRoundness.Phi SuperquadricRoundness.Theta";

/// The same columns, with the names that OVITO itself writes besides.
const NAMES: [&[&str]; 12] = [
    &["x"],
    &["y"],
    &["z"],
    &["AsphericalShape.X", "AsphericalShapeX", "c_shape[1]"],
    &["AsphericalShape.Y", "AsphericalShapeY", "c_shape[2]"],
    &["AsphericalShape.Z", "AsphericalShapeZ", "c_shape[3]"],
    &["Orientation.X", "OrientationX", "quati"],
    &["Orientation.Y", "OrientationY", "quatj"],
    &["Orientation.Z", "OrientationZ", "quatk"],
    &["Orientation.W", "OrientationW", "quatw"],
    &["SuperquadricRoundness.Phi", "SuperquadricRoundnessPhi"],
    &["SuperquadricRoundness.Theta", "SuperquadricRoundnessTheta"],
];

pub(super) fn write(model: &Model) -> String {
    let [x, y, z]: [f64; 3] = (*model.pose.translation()).into();
    let [a1, a2, a3] = model.shape.size();
    let [e1, e2] = model.shape.exponents();
    let [qw, qx, qy, qz] = quaternion_wxyz(model);
    dump::write(model, COLUMNS, &[x, y, z, a1, a2, a3, qx, qy, qz, qw, e2, e1])
}

pub(super) fn read(text: &str) -> Result<Vec<Model>, ImportError> {
    let table = dump::last_snapshot(text, EXPECTED)?;
    let columns = table.columns(NAMES)?;
    let model = |row| {
        let [x, y, z, a1, a2, a3, qx, qy, qz, qw, phi, theta] = table.numbers(row, columns)?;
        let particle = Particle {
            semi_axes: [a1, a2, a3],
            exponents: [theta, phi],
            quaternion_wxyz: [qw, qx, qy, qz],
            centre: [x, y, z],
        };
        particle.model(row)
    };
    table.rows.iter().map(model).collect()
}
