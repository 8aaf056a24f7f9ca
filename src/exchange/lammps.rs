//! LAMMPS: data files for `atom_style ellipsoid superellipsoid`.
//!
//! The shape is that of diameters; blockiness `n1 = 2 / e1`, `n2 = 2 / e2`, of which
//! `granular/superellipsoid` refuses what is below 2; quaternions are w x y z.

use std::collections::HashMap;

use super::error::ImportError;
use super::line::{Line, lines};
use super::particle::{Particle, blockiness, quaternion_wxyz, spaced};
use crate::model::Model;

pub(super) const EXPECTED: &str = "a data file with sections Atoms and Ellipsoids";

/// Domain: exponents up to 1.
pub(super) fn write(model: &Model) -> String {
    let [least, greatest] = model.bounding_box();
    let bounds: String = ["x", "y", "z"]
        .iter()
        .enumerate()
        .map(|(i, axis)| format!("{:?} {:?} {axis}lo {axis}hi\n", least[i], greatest[i]))
        .collect();
    format!(
        "LAMMPS data file of a superellipsoid: atom_style ellipsoid superellipsoid\n\n\
         1 atoms\n1 atom types\n1 ellipsoids\n\n\
         {bounds}\n\
         Atoms # ellipsoid\n\n\
         1 1 1 1.0 {}\n\n\
         Ellipsoids\n\n\
         1 {} {} {}\n",
        spaced(model.pose.translation().as_slice()),
        spaced(&model.shape.size().map(|a| 2.0 * a)),
        spaced(&quaternion_wxyz(model)),
        spaced(&blockiness(model.shape.exponents())),
    )
}

pub(super) fn read(text: &str) -> Result<Vec<Model>, ImportError> {
    let sections = sections(text);
    let mut centres: HashMap<&str, [f64; 3]> = HashMap::new();
    for line in sections.get("Atoms").into_iter().flatten() {
        centres.insert(line.words[0], line.numbers(4, "ID type 1 density x y z")?);
    }
    let ellipsoids = sections.get("Ellipsoids").into_iter().flatten();
    ellipsoids.map(|line| ellipsoid(line, &centres)).collect()
}

/// The lines below each heading. The first line of a data file is a comment.
fn sections(text: &str) -> HashMap<&str, Vec<Line<'_>>> {
    let mut sections: HashMap<&str, Vec<Line<'_>>> = HashMap::new();
    let mut heading = None;
    for line in lines(text, '#').filter(|line| line.number > 1) {
        if line.words[0].starts_with(char::is_alphabetic) {
            heading = Some(line.words[0]);
        } else if let Some(heading) = heading {
            sections.entry(heading).or_default().push(line);
        }
    }
    sections
}

/// The model of a line `ID shapex shapey shapez quatw quati quatj quatk [block1 block2]`.
fn ellipsoid(line: &Line<'_>, centres: &HashMap<&str, [f64; 3]>) -> Result<Model, ImportError> {
    let [d1, d2, d3, qw, qx, qy, qz] = line.numbers(1, "ID shape quaternion")?;
    let block = if line.words.len() == 8 { [2.0; 2] } else { line.numbers(8, "block")? };
    let particle = Particle {
        semi_axes: [d1, d2, d3].map(|diameter| 0.5 * diameter),
        exponents: blockiness(block),
        quaternion_wxyz: [qw, qx, qy, qz],
        centre: *centres
            .get(line.words[0])
            .ok_or_else(|| line.unexpected(0, "the ID of one of the Atoms"))?,
    };
    particle.model(line)
}
