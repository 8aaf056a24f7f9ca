//! Which axes of one model are which of another's, and what is left to differ.
//!
//! One solid has many descriptions: its axes in another order or sign, or turned by 45 degrees
//! where exponent e2 is near 0 or 2. The labellings of `b` are the ways to lay its axes on those
//! of `a`; they are told apart by how well the solids agree, not by their parameters.

use std::f64::consts::FRAC_PI_4;

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::model::Model;
use crate::shape::Superellipsoid;
use crate::surface::{Resolution, tessellate};

/// Mean relative difference of radii up to which solids count as the same: labellings that are
/// worse than the best by less are equally good, and a solid that differs by less from itself,
/// turned about an axis, is one of revolution.
const SAME_SHAPE: f64 = 0.01;

/// Segments of the mesh whose vertices are the directions that are compared.
const COMPARED_SEGMENTS: usize = 8;

/// The greatest relative error of a semi-axis, `max |b_i / a_i - 1|`, after matching axes.
///
/// `b_i` is the half-extent of b's solid along the axis that is laid on the i-th of a: b is laid
/// on a, concentric, in each of the 24 rotations of a cube, and in these turned by 45 degrees
/// about b's z axis; of those in which the solids agree best, to within 1 % of their radius on
/// average, the one with the least error counts. Pose does not enter.
pub fn size_error(a: &Model, b: &Model) -> f64 {
    best_labellings(&a.shape, &b.shape)
        .map(|b_from_a| greatest_relative_error(&a.shape, &b.shape, &b_from_a))
        .fold(f64::INFINITY, f64::min)
}

/// The least angle, in radians, by which `b` must be turned to be oriented as `a`.
///
/// The least over the labellings of [`size_error`]. About an axis of revolution of `a` any turn
/// is free, and only the angle between the axes is left; with two such axes it is a sphere,
/// and the error 0. An axis is one of revolution if turns about it change the radius by less
/// than 1 % on average.
pub fn rotation_error(a: &Model, b: &Model) -> f64 {
    let b_to_a = a.pose.rotation().inverse() * b.pose.rotation();
    let turns = best_labellings(&a.shape, &b.shape).map(|b_from_a| b_to_a * b_from_a);
    let axes = axes_of_revolution(&a.shape);
    let angle_of = |turn: Rotation3<f64>| match axes[..] {
        [] => rotation_angle(&turn),
        [axis] => angle_between(&axis, &(turn * axis)),
        _ => 0.0,
    };
    turns.map(angle_of).fold(f64::INFINITY, f64::min)
}

/// The rotations from a's frame to b's in which the solids agree as well as in any.
fn best_labellings(a: &Superellipsoid, b: &Superellipsoid) -> impl Iterator<Item = Rotation3<f64>> {
    let surface = compared_points(a);
    let candidates: Vec<(Rotation3<f64>, f64)> =
        labellings().map(|b_from_a| (b_from_a, mean_difference(&surface, b, &b_from_a))).collect();
    let least = candidates.iter().map(|(_, difference)| *difference).fold(f64::INFINITY, f64::min);
    candidates
        .into_iter()
        .filter(move |(_, difference)| *difference <= least + SAME_SHAPE)
        .map(|(b_from_a, _)| b_from_a)
}

/// The rotations of a cube, and the same followed by 45 degrees about z.
fn labellings() -> impl Iterator<Item = Rotation3<f64>> {
    let eighth = Rotation3::from_axis_angle(&Vector3::z_axis(), FRAC_PI_4);
    cube_rotations().flat_map(move |rotation| [rotation, eighth * rotation])
}

/// The 24 rotations that map a cube onto itself.
fn cube_rotations() -> impl Iterator<Item = Rotation3<f64>> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let signed = axes.into_iter().flat_map(|axis| [axis, -axis]);
    let pairs = signed.clone().flat_map(move |x| signed.clone().map(move |y| [x, y]));
    pairs
        .filter(|[x, y]| x.dot(y) == 0.0)
        .map(|[x, y]| Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, y, x.cross(&y)])))
}

/// Points all over the surface, dense where it bends.
fn compared_points(shape: &Superellipsoid) -> Vec<Vector3<f64>> {
    let resolution = Resolution::new(COMPARED_SEGMENTS).unwrap_or_default();
    tessellate(shape, resolution).vertices().to_vec()
}

/// Mean of `|ln H(R x)|` over points x of another surface: the relative difference of radii.
fn mean_difference(
    surface: &[Vector3<f64>],
    shape: &Superellipsoid,
    rotation: &Rotation3<f64>,
) -> f64 {
    let differences = surface.iter().map(|x| shape.gauge(&(rotation * x)).ln().abs());
    differences.sum::<f64>() / surface.len() as f64
}

/// The greatest `|b_i / a_i - 1|`, b_i being b's half-extent along a's i-th axis.
fn greatest_relative_error(
    a: &Superellipsoid,
    b: &Superellipsoid,
    b_from_a: &Rotation3<f64>,
) -> f64 {
    let columns = b_from_a.matrix().column_iter();
    let errors =
        columns.zip(a.size()).map(|(axis, size)| (b.support(&axis.into()) / size - 1.0).abs());
    errors.fold(0.0, f64::max)
}

/// The axes about which any turn leaves the solid as it is.
fn axes_of_revolution(shape: &Superellipsoid) -> Vec<Vector3<f64>> {
    let surface = compared_points(shape);
    let is_unchanged = |axis: &Vector3<f64>| {
        // The symmetry is otherwise of order 2 or 4: an eighth of a turn is furthest from it.
        [0.5, 1.0, 2.0].iter().all(|eighths| {
            let turn = Rotation3::new(axis * (eighths * FRAC_PI_4));
            mean_difference(&surface, shape, &turn) <= SAME_SHAPE
        })
    };
    [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().filter(is_unchanged).collect()
}

/// Angle of a rotation in [0, pi], exact also where it is small.
fn rotation_angle(rotation: &Rotation3<f64>) -> f64 {
    let m = rotation.matrix();
    let twice_sine =
        Vector3::new(m[(2, 1)] - m[(1, 2)], m[(0, 2)] - m[(2, 0)], m[(1, 0)] - m[(0, 1)]).norm();
    twice_sine.atan2(m.trace() - 1.0)
}

/// Angle between unit vectors in [0, pi], exact also where it is small.
fn angle_between(u: &Vector3<f64>, v: &Vector3<f64>) -> f64 {
    u.cross(v).norm().atan2(u.dot(v))
}

#[cfg(test)]
mod tests;
