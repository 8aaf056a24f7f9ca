//! Models to start from: frames along the principal axes, sizes from the scatter.

use std::f64::consts::FRAC_PI_4;

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::normalization::Moments;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Superellipsoid;

/// Semi-axis over standard deviation: exact for a sphere's surface, between the 1.4 of a
/// cylinder's round and the 1.7 of a box's long sides.
const SIZE_OVER_DEVIATION: f64 = 1.732_050_807_568_877_2;

/// Least size of a start as a share of the greatest, for flat clouds.
const LEAST_ASPECT: f64 = 1e-3;

/// Exponents to start from: an ellipsoid, from which box and octahedron are equally far.
const EXPONENTS: [f64; 2] = [1.0, 1.0];

/// Two principal deviations nearer to each other than this leave the frame between them open.
const AMBIGUOUS_RATIO: f64 = 0.63;

/// A frame to start in: axes as columns, and the deviations of the points along them.
#[derive(Debug, Clone, Copy)]
struct Frame {
    axes: Rotation3<f64>,
    deviations: [f64; 3],
}

/// Starts along the principal axes: each in turn is the model's axis z.
pub(crate) fn principal_starts(moments: &Moments) -> Vec<Model> {
    let frame = Frame { axes: moments.axes, deviations: moments.deviations };
    axis_orders(&frame)
}

/// Starts in frames between those principal axes that the scatter hardly tells apart.
pub(crate) fn ambiguous_starts(moments: &Moments) -> Vec<Model> {
    let [first, second, third] = moments.deviations;
    let is_ambiguous = |greater: f64, less: f64| less > AMBIGUOUS_RATIO * greater;
    let mut turns = Vec::new();
    if is_ambiguous(first, second) {
        turns.push(Rotation3::from_axis_angle(&Vector3::z_axis(), FRAC_PI_4));
    }
    if is_ambiguous(second, third) {
        turns.push(Rotation3::from_axis_angle(&Vector3::x_axis(), FRAC_PI_4));
    }
    if is_ambiguous(first, third) {
        turns.push(Rotation3::from_axis_angle(&Vector3::y_axis(), FRAC_PI_4));
        turns.push(Rotation3::new(Vector3::new(1.0, 1.0, 1.0).normalize() * FRAC_PI_4));
        turns.push(Rotation3::new(Vector3::new(1.0, -1.0, 1.0).normalize() * FRAC_PI_4));
    }
    turns.iter().flat_map(|turn| axis_orders(&turned(moments, turn))).collect()
}

/// The principal frame, turned within itself, and the deviations along its new axes.
fn turned(moments: &Moments, turn: &Rotation3<f64>) -> Frame {
    let variances = Vector3::from(moments.deviations.map(|d| d * d));
    let deviations = std::array::from_fn(|k| {
        let axis = turn.matrix().column(k);
        axis.component_mul(&axis).dot(&variances).sqrt()
    });
    Frame { axes: moments.axes * turn, deviations }
}

/// The three starts of a frame.
fn axis_orders(frame: &Frame) -> Vec<Model> {
    [[1, 2, 0], [2, 0, 1], [0, 1, 2]].iter().filter_map(|order| start(frame, *order)).collect()
}

/// The start whose axes x, y, z are those of the frame in this (cyclic) order.
fn start(frame: &Frame, order: [usize; 3]) -> Option<Model> {
    let greatest = frame.deviations.into_iter().fold(0.0, f64::max);
    let size =
        order.map(|k| SIZE_OVER_DEVIATION * frame.deviations[k].max(LEAST_ASPECT * greatest));
    let shape = Superellipsoid::new(size, EXPONENTS).ok()?;
    let axes = order.map(|k| frame.axes.matrix().column(k).into_owned());
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&axes));
    Some(Model { shape, pose: Pose::new(rotation, Vector3::zeros()) })
}
