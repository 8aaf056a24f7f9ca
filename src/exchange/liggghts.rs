//! LIGGGHTS: commands of an input script for `atom_style superquadric`, and dumps.
//!
//! Semi-axes; blockiness `n1 = 2 / e1`, `n2 = 2 / e2`, refused by LIGGGHTS below 2; the rotation
//! by axis and degrees in commands, by a quaternion w x y z in dumps.

use std::collections::BTreeMap;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::dump;
use super::error::ImportError;
use super::line::{Line, lines};
use super::particle::{Particle, blockiness, quaternion_wxyz, spaced};
use crate::model::Model;

pub(super) const EXPECTED: &str = "commands `create_atoms TYPE single X Y Z` and `set atom ID \
                                   shape .. blockiness .. quat ..`, or a dump with columns \
                                   shapex, quat1 and blockiness1";

/// Domain: exponents up to 1.
pub(super) fn write(model: &Model) -> String {
    let (axis, degrees) = axis_and_degrees(model);
    format!(
        "# A superquadric for LIGGGHTS, atom_style superquadric: include it after create_box.\n\
         # Where there are atoms already, set its own ID in place of 1.\n\
         create_atoms 1 single {} units box\n\
         set atom 1 shape {} blockiness {} quat {} {degrees:?}\n",
        spaced(model.pose.translation().as_slice()),
        spaced(&model.shape.size()),
        spaced(&blockiness(model.shape.exponents())),
        spaced(axis.as_slice()),
    )
}

/// The rotation as a unit axis and an angle in degrees.
fn axis_and_degrees(model: &Model) -> (Vector3<f64>, f64) {
    let [w, x, y, z] = quaternion_wxyz(model);
    let sine = Vector3::new(x, y, z);
    let axis = sine.try_normalize(0.0).unwrap_or(Vector3::z());
    (axis, 2.0 * sine.norm().atan2(w).to_degrees())
}

pub(super) fn read(text: &str) -> Result<Vec<Model>, ImportError> {
    if dump::is_dump(text) { read_dump(text) } else { read_commands(text) }
}

fn read_dump(text: &str) -> Result<Vec<Model>, ImportError> {
    let table = dump::last_snapshot(text, EXPECTED)?;
    let columns = table.columns([
        &["x"],
        &["y"],
        &["z"],
        &["shapex"],
        &["shapey"],
        &["shapez"],
        &["quat1"],
        &["quat2"],
        &["quat3"],
        &["quat4"],
        &["blockiness1"],
        &["blockiness2"],
    ])?;
    let model = |row| {
        let [x, y, z, a1, a2, a3, qw, qx, qy, qz, n1, n2] = table.numbers(row, columns)?;
        let particle = Particle {
            semi_axes: [a1, a2, a3],
            exponents: blockiness([n1, n2]),
            quaternion_wxyz: [qw, qx, qy, qz],
            centre: [x, y, z],
        };
        particle.model(row)
    };
    table.rows.iter().map(model).collect()
}

/// Follows the commands that make atoms: each is a sphere of no size until it is set.
fn read_commands(text: &str) -> Result<Vec<Model>, ImportError> {
    let mut atoms: BTreeMap<usize, (Particle, Line<'_>)> = BTreeMap::new();
    for line in lines(text, '#') {
        match line.words[..] {
            ["create_atoms", _, "single", ..] => {
                let particle = Particle {
                    semi_axes: [0.0; 3],
                    exponents: [1.0; 2],
                    quaternion_wxyz: [1.0, 0.0, 0.0, 0.0],
                    centre: line.numbers(3, "create_atoms TYPE single X Y Z")?,
                };
                atoms.insert(atoms.len() + 1, (particle, line));
            }
            ["set", "atom", id, ..] => {
                let atom = id.parse().ok().and_then(|id: usize| atoms.get_mut(&id));
                let (particle, _) =
                    atom.ok_or_else(|| line.unexpected(2, "the ID of an atom created before"))?;
                set(particle, &line)?;
            }
            _ => {}
        }
    }
    atoms.values().map(|(particle, line)| particle.model(line)).collect()
}

/// Does what a command `set atom ID ..` says of the shape.
fn set(particle: &mut Particle, line: &Line<'_>) -> Result<(), ImportError> {
    if let Some(semi_axes) = line.after("shape")? {
        particle.semi_axes = semi_axes;
    }
    if let Some(block) = line.after("blockiness")? {
        particle.exponents = blockiness(block);
    }
    if let Some([x, y, z, degrees]) = line.after("quat")? {
        let (sine, cosine) = (0.5 * f64::to_radians(degrees)).sin_cos();
        let turned =
            UnitQuaternion::from_quaternion(Quaternion::new(cosine, x * sine, y * sine, z * sine));
        particle.quaternion_wxyz = [turned.w, turned.i, turned.j, turned.k];
    }
    Ok(())
}
