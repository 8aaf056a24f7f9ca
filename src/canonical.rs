//! The canonical form: one parameter vector for each shape.

use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Superellipsoid;

/// Relative difference up to which two lengths or exponents count as the same: far below any
/// fit's own error, well above rounding.
const SAME: f64 = 1e-9;

impl Model {
    /// The same solid, described by the one parameter vector that stands for all equivalent ones.
    ///
    /// - Where e1 = e2 any axis may be z: the semi-axes are put in falling order. Else only x
    ///   and y can change places: `a1 >= a2`.
    /// - Half turns about the model's own axes change nothing: of the four, the rotation nearest
    ///   to the identity is taken.
    /// - A solid of revolution (a1 = a2, e2 = 1) has psi = 0, its z axis in the half space `z >=
    ///   0` of the world; a sphere is not rotated at all.
    ///
    /// Lengths and exponents are the same where they agree to 1e-9.
    pub fn canonical(&self) -> Model {
        let ordered = in_axis_order(self, axis_order(&self.shape));
        if is_sphere(&ordered.shape) {
            return Model {
                pose: Pose::new(Rotation3::identity(), *self.pose.translation()),
                ..ordered
            };
        }
        if is_of_revolution(&ordered.shape) {
            return Model { pose: unturned(&ordered.pose), ..ordered };
        }
        Model { pose: nearest_to_identity(&ordered), ..ordered }
    }
}

fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}

fn is_of_revolution(shape: &Superellipsoid) -> bool {
    let ([a1, a2, _], [_, e2]) = (shape.size(), shape.exponents());
    is_same(a1, a2) && is_same(e2, 1.0)
}

fn is_sphere(shape: &Superellipsoid) -> bool {
    let [_, a2, a3] = shape.size();
    is_of_revolution(shape) && is_same(a2, a3) && is_same(shape.exponents()[0], 1.0)
}

/// The order in which a shape's axes become x, y, z of its canonical form.
pub(crate) fn axis_order(shape: &Superellipsoid) -> [usize; 3] {
    let [e1, e2] = shape.exponents();
    let size = shape.size();
    let mut order = [0, 1, 2];
    let interchangeable = if is_same(e1, e2) { 3 } else { 2 };
    // Equal semi-axes keep their places: the sort is stable.
    order[..interchangeable].sort_by(|&i, &j| {
        if is_same(size[i], size[j]) {
            std::cmp::Ordering::Equal
        } else {
            size[j].total_cmp(&size[i])
        }
    });
    if interchangeable == 3 { revolution_last(order, size, e1) } else { order }
}

/// An ellipsoid with two equal semi-axes turns about the third: that one becomes z.
fn revolution_last(order: [usize; 3], size: [f64; 3], e: f64) -> [usize; 3] {
    let [first, second, third] = order;
    let turns_about_first = is_same(e, 1.0) && is_same(size[second], size[third]);
    if turns_about_first { [second, third, first] } else { order }
}

/// The same solid with its axes in another order; an odd order reverses one axis, which the
/// solid does not notice.
fn in_axis_order(model: &Model, order: [usize; 3]) -> Model {
    let size = model.shape.size();
    let mut axes = order.map(|k| model.pose.rotation().matrix().column(k).into_owned());
    if axes[0].cross(&axes[1]).dot(&axes[2]) < 0.0 {
        axes[2] = -axes[2];
    }
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&axes));
    Model {
        shape: model.shape.with_size(order.map(|k| size[k])),
        pose: Pose::new(rotation, *model.pose.translation()),
    }
}

/// The pose whose z axis is that of another (or its reverse), without a turn about it.
fn unturned(pose: &Pose) -> Pose {
    let axis = pose.rotation().matrix().column(2).into_owned();
    let axis = if axis.z < 0.0 { -axis } else { axis };
    let theta = axis.x.hypot(axis.y).atan2(axis.z);
    let phi = if theta == 0.0 { 0.0 } else { axis.y.atan2(axis.x) };
    Pose::from_euler_zyz([phi, theta, 0.0], *pose.translation())
}

/// Of the equivalent rotations that of least angle: the one of greatest trace.
fn nearest_to_identity(model: &Model) -> Pose {
    let rotation = model.pose.rotation();
    let best = symmetries(&model.shape)
        .map(|symmetry| rotation * symmetry)
        .reduce(
            |best, other| {
                if other.matrix().trace() > best.matrix().trace() { other } else { best }
            },
        )
        .unwrap_or(*rotation);
    Pose::new(best, *model.pose.translation())
}

/// The rotations that take axes to axes and leave the shape as it is: the half turns about its
/// axes, and more where semi-axes are equal.
fn symmetries(shape: &Superellipsoid) -> impl Iterator<Item = Rotation3<f64>> {
    let size = shape.size();
    let [e1, e2] = shape.exponents();
    let leaves_shape = move |order: [usize; 3]| {
        (is_same(e1, e2) || order[2] == 2) && (0..3).all(|k| is_same(size[k], size[order[k]]))
    };
    AXIS_ORDERS.into_iter().filter(move |&(order, _)| leaves_shape(order)).flat_map(
        |(order, parity)| {
            SIGNS.map(|[x, y]| {
                let unit = |k: usize, sign: f64| Vector3::ith(order[k], sign);
                let axes = [unit(0, x), unit(1, y), unit(2, x * y * parity)];
                Rotation3::from_matrix_unchecked(Matrix3::from_columns(&axes))
            })
        },
    )
}

/// Orders of three axes and their parities.
const AXIS_ORDERS: [([usize; 3], f64); 6] = [
    ([0, 1, 2], 1.0),
    ([1, 2, 0], 1.0),
    ([2, 0, 1], 1.0),
    ([1, 0, 2], -1.0),
    ([0, 2, 1], -1.0),
    ([2, 1, 0], -1.0),
];

/// Directions of the first two axes.
const SIGNS: [[f64; 2]; 4] = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn model(size: [f64; 3], exponents: [f64; 2], euler: [f64; 3]) -> Model {
        Model {
            shape: Superellipsoid::new(size, exponents).unwrap(),
            pose: Pose::from_euler_zyz(euler, Vector3::new(1.0, -2.0, 3.0)),
        }
    }

    fn assert_same_parameters(a: &Model, b: &Model) {
        for (x, y) in a.parameters().into_iter().zip(b.parameters()) {
            assert!((x - y).abs() < 1e-12, "{:?}\n{:?}", a.parameters(), b.parameters());
        }
    }

    fn assert_same_solid(a: &Model, b: &Model) {
        for (eta, omega) in [(0.2, 0.3), (-0.9, 1.0), (0.5, -2.5), (1.3, 2.0)] {
            let x_world = a.pose.world_from_model(&a.shape.position(eta, omega));
            assert!((b.gauge(&x_world) - 1.0).abs() < 1e-12, "{a:?} {b:?}");
        }
    }

    /// All parameter vectors that a shape of this kind has, up to rotations about itself.
    fn equivalents(of: &Model) -> Vec<Model> {
        let interchangeable = of.shape.exponents()[0] == of.shape.exponents()[1];
        AXIS_ORDERS
            .into_iter()
            .filter(|(order, _)| interchangeable || order[2] == 2)
            .flat_map(|(order, _)| {
                let reordered = in_axis_order(of, order);
                let symmetries: Vec<_> = symmetries(&reordered.shape).collect();
                symmetries.into_iter().map(move |symmetry| Model {
                    pose: Pose::new(
                        reordered.pose.rotation() * symmetry,
                        *reordered.pose.translation(),
                    ),
                    ..reordered
                })
            })
            .collect()
    }

    #[test]
    fn equivalent_parameter_vectors_have_one_canonical_form_of_the_same_solid() {
        let models = [
            model([1.0, 2.0, 3.0], [0.3, 1.2], [0.5, 1.0, -2.0]),
            model([1.0, 1.0, 3.0], [0.3, 0.2], [0.5, 1.0, -2.0]),
            model([1.0, 2.0, 3.0], [0.3, 0.3], [2.5, 2.0, 0.1]),
            model([2.0, 2.0, 2.0], [0.1, 0.1], [0.5, 1.0, -2.0]),
            model([1.0, 2.0, 2.0], [0.1, 0.1], [0.5, 3.0, -2.0]),
        ];
        let counts = [8, 16, 24, 144, 48];
        for (model, count) in models.iter().zip(counts) {
            let canonical = model.canonical();
            let equivalents = equivalents(model);
            assert_eq!(equivalents.len(), count);
            for equivalent in equivalents {
                assert_same_solid(&equivalent, model);
                assert_same_parameters(&equivalent.canonical(), &canonical);
            }
            assert_same_solid(&canonical, model);
            assert_same_parameters(&canonical.canonical(), &canonical);
        }
    }

    #[test]
    fn solids_of_revolution_have_no_psi() {
        for exponents in [[0.2, 1.0], [1.0, 1.0]] {
            for psi in [0.0, 0.4, 2.0, -3.0] {
                let turned = model([1.0, 1.0, 3.0], exponents, [0.5, 1.0, psi]);
                let unturned = model([1.0, 1.0, 3.0], exponents, [0.5, 1.0, 0.0]);
                assert_same_parameters(&turned.canonical(), &unturned);
                let reversed = model([1.0, 1.0, 3.0], exponents, [0.5 - PI, PI - 1.0, psi]);
                assert_same_parameters(&reversed.canonical(), &unturned);
            }
        }
    }

    #[test]
    fn an_ellipsoid_of_revolution_about_x_turns_about_z_instead() {
        let about_x = model([3.0, 1.0, 1.0], [1.0, 1.0], [0.0, FRAC_PI_2, 0.3]);
        let canonical = about_x.canonical();
        assert_eq!(canonical.shape.size(), [1.0, 1.0, 3.0]);
        assert_same_solid(&canonical, &about_x);
    }

    #[test]
    fn a_sphere_is_not_rotated() {
        let sphere = model([2.0, 2.0, 2.0], [1.0, 1.0], [0.5, 1.0, -2.0]);
        assert_eq!(*sphere.canonical().pose.rotation(), Rotation3::identity());
    }
}
