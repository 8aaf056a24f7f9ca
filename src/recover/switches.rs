//! Jumps between the minima in which a superellipsoid can hide from its true parameters: the
//! wrong axis for z, the dual turned by 45 degrees, and of what is seen on one side the giant.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use nalgebra::{Matrix3, Rotation3};

use super::chart::EXPONENT_BOUNDS;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Superellipsoid;

/// How far inside their bounds the exponents of a switched model are kept.
const MARGIN: f64 = 0.05;

/// How much smaller a deflated model is, and how much of its exponents' difference from one is left.
const DEFLATION: f64 = 0.7;
const EDGE_LEFT: f64 = 0.6;

/// The models to try beside a model that a descent has ended in.
pub(crate) fn switches(model: &Model) -> Vec<Model> {
    axis_switches(model).into_iter().chain(dual_switch(model)).collect()
}

/// All other frames that a model may hide in: its switches, and the duals of other axes as z.
pub(crate) fn other_frames(model: &Model) -> Vec<Model> {
    let duals = axis_switches(model).into_iter().filter_map(|other| dual_switch(&other));
    switches(model).into_iter().chain(duals).collect()
}

fn axis_switches(model: &Model) -> Vec<Model> {
    [[1, 2, 0], [2, 0, 1]].into_iter().filter_map(|order| axis_switch(model, order)).collect()
}

/// The model shrunk towards the points' centroid, the origin, and rounded: descents grow sizes and
/// sharpen edges more readily than they take them back.
pub(crate) fn deflated(model: &Model) -> Option<Model> {
    let exponents = model.shape.exponents().map(|e| 1.0 + EDGE_LEFT * (e - 1.0));
    let shape = Superellipsoid::new(model.shape.size().map(|a| DEFLATION * a), exponents).ok()?;
    let pose = Pose::new(*model.pose.rotation(), model.pose.translation() * DEFLATION);
    Some(Model { shape, pose })
}

/// The model whose axes x, y, z are those of `model` in this (cyclic) order, with the exponents
/// exchanged: a box or cylinder lying on the wrong axis has its sharp edges counted under the
/// wrong one.
fn axis_switch(model: &Model, order: [usize; 3]) -> Option<Model> {
    let size = model.shape.size();
    let [e1, e2] = model.shape.exponents();
    let axes = order.map(|k| model.pose.rotation().matrix().column(k).into_owned());
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&axes));
    build(model, order.map(|k| size[k]), [e2, e1], rotation)
}

/// The model turned by 45 degrees about z with `e2 -> 2 - e2`, `a1, a2 -> sqrt(a1 a2) 2^((1 -
/// e2)/2)`: the same cross-section where e2 is 0 or 2, and nearly the same between.
fn dual_switch(model: &Model) -> Option<Model> {
    let [a1, a2, a3] = model.shape.size();
    let [e1, e2] = model.shape.exponents();
    let side = (a1 * a2).sqrt() * SQRT_2.powf(1.0 - e2);
    let eighth_turn = Rotation3::from_matrix_unchecked(Matrix3::new(
        FRAC_1_SQRT_2,
        -FRAC_1_SQRT_2,
        0.0,
        FRAC_1_SQRT_2,
        FRAC_1_SQRT_2,
        0.0,
        0.0,
        0.0,
        1.0,
    ));
    build(model, [side, side, a3], [e1, 2.0 - e2], model.pose.rotation() * eighth_turn)
}

fn build(
    model: &Model,
    size: [f64; 3],
    exponents: [f64; 2],
    rotation: Rotation3<f64>,
) -> Option<Model> {
    let [low, high] = EXPONENT_BOUNDS;
    let exponents = exponents.map(|e| e.clamp(low + MARGIN, high - MARGIN));
    let shape = Superellipsoid::new(size, exponents).ok()?;
    Some(Model { shape, pose: Pose::new(rotation, *model.pose.translation()) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn model(size: [f64; 3], exponents: [f64; 2]) -> Model {
        Model {
            shape: Superellipsoid::new(size, exponents).unwrap(),
            pose: Pose::from_euler_zyz([0.3, 0.7, 1.9], Vector3::new(1.0, 2.0, 3.0)),
        }
    }

    fn greatest_gauge_difference(a: &Model, b: &Model) -> f64 {
        let mut greatest: f64 = 0.0;
        for i in 0..50 {
            for j in 0..50 {
                let (eta, omega) = (f64::from(i) * 0.06 - 1.5, f64::from(j) * 0.12 - 3.0);
                let x_world = a.pose.world_from_model(&a.shape.position(eta, omega));
                greatest = greatest.max((b.gauge(&x_world) - 1.0).abs());
            }
        }
        greatest
    }

    #[test]
    fn an_ellipsoid_is_the_same_on_every_axis() {
        let ellipsoid = model([1.0, 2.0, 3.0], [1.0, 1.0]);
        for order in [[1, 2, 0], [2, 0, 1]] {
            let switched = axis_switch(&ellipsoid, order).unwrap();
            assert!(greatest_gauge_difference(&ellipsoid, &switched) < 1e-14);
        }
    }

    #[test]
    fn the_dual_of_a_square_section_is_nearly_the_section_itself() {
        let cylinder = model([1.0, 1.0, 3.0], [0.5, 1.0]);
        assert!(greatest_gauge_difference(&cylinder, &dual_switch(&cylinder).unwrap()) < 1e-14);
        let square = model([1.0, 1.0, 3.0], [0.5, 0.1]);
        // The corner of e2 = 0.1 reaches to 2^-0.05, that of e2 = 1.9 to its apex.
        assert!(greatest_gauge_difference(&square, &dual_switch(&square).unwrap()) < 0.05);
    }
}
