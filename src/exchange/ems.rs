//! EMS (Liu et al. 2022): the eleven parameters of its MATLAB and Python programs.
//!
//! `e1 e2 a1 a2 a3`, the angles of `R = Rz Ry Rx` in this order, and the centre.

use nalgebra::Rotation3;

use super::error::ImportError;
use super::line::{Line, lines};
use super::particle::spaced;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Superellipsoid;

pub(super) const EXPECTED: &str = "lines of eleven numbers: e1 e2 a1 a2 a3, Euler angles ZYX, \
                                   centre";

const NUMBERS: usize = 11;

pub(super) fn write(model: &Model) -> String {
    let [e1, e2] = model.shape.exponents();
    let [a1, a2, a3] = model.shape.size();
    let [yaw, pitch, roll] = euler_zyx(model.pose.rotation());
    let [x, y, z]: [f64; 3] = (*model.pose.translation()).into();
    spaced(&[e1, e2, a1, a2, a3, yaw, pitch, roll, x, y, z]) + "\n"
}

/// The angles of `R = Rz(yaw) Ry(pitch) Rx(roll)`.
///
/// Where pitch is a quarter turn only the sum or the difference of the others is determined: roll
/// is found for whatever yaw came out, so that together they are the rotation everywhere.
fn euler_zyx(rotation: &Rotation3<f64>) -> [f64; 3] {
    let m = rotation.matrix();
    let yaw = m[(1, 0)].atan2(m[(0, 0)]);
    let pitch = (-m[(2, 0)]).atan2(m[(0, 0)].hypot(m[(1, 0)]));
    let (sine, cosine) = yaw.sin_cos();
    let roll = (sine * m[(0, 2)] - cosine * m[(1, 2)]).atan2(cosine * m[(1, 1)] - sine * m[(0, 1)]);
    [yaw, pitch, roll]
}

pub(super) fn read(text: &str) -> Result<Vec<Model>, ImportError> {
    // What MATLAB and NumPy print stands between brackets and commas.
    let text = text.replace([',', ';', '[', ']'], " ");
    lines(&text, '%').map(|line| parameters(&line)).collect()
}

fn parameters(line: &Line<'_>) -> Result<Model, ImportError> {
    let numbers: [f64; NUMBERS] = line.numbers(0, EXPECTED)?;
    if line.words.len() > NUMBERS {
        return Err(line.unexpected(NUMBERS, "no more than eleven numbers"));
    }
    let [e1, e2, a1, a2, a3, yaw, pitch, roll, x, y, z] = numbers;
    let outside =
        |source| ImportError::Parameters { place: format!("line {}", line.number), source };
    let shape = Superellipsoid::new([a1, a2, a3], [e1, e2]).map_err(outside)?;
    let rotation = Rotation3::from_euler_angles(roll, pitch, yaw);
    Ok(Model { shape, pose: Pose::new(rotation, [x, y, z].into()) })
}
