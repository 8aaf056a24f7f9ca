//! The inside of a shape, in any numbers.

use super::{Shape, Superellipsoid};
use crate::math::Scalar;

/// A shape that is told by a continuous function of the point: below 1 inside, 1 on the surface,
/// above 1 outside.
///
/// Over a box of [`Interval`](crate::math::Interval)s it encloses the function's values, over
/// [`Dual`](crate::math::Dual) numbers its slopes along a curve, too.
pub trait LevelSet {
    /// The function at a point.
    fn level<S: Scalar>(&self, x: [S; 3]) -> S;
}

impl LevelSet for Superellipsoid {
    /// The gauge.
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        let [a1, a2, a3] = self.size();
        let [e1, e2] = self.exponents();
        let [u, v, w] = [x[0] * a1.recip(), x[1] * a2.recip(), x[2] * a3.recip()].map(S::abs);
        S::superellipse_norm(S::superellipse_norm(u, v, e2), w, e1)
    }
}

impl LevelSet for Shape {
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        match self {
            Self::Superellipsoid(shape) => shape.level(x),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Dual, Interval};
    use nalgebra::Vector3;

    #[test]
    fn the_level_is_the_gauge_and_its_slopes_are_those_of_the_gradient() {
        for exponents in [[0.1, 0.1], [0.5, 1.5], [1.0, 1.0], [2.0, 0.3], [1.9, 1.9]] {
            let shape = Superellipsoid::new([2.0, 1.0, 0.5], exponents).unwrap();
            for x in [[0.3, -0.2, 0.4], [-3.0, 0.5, 0.1], [1.0, 1.0, -1.0]] {
                let point = Vector3::from(x);
                assert!((shape.level(x) / shape.gauge(&point) - 1.0).abs() < 1e-14);
                let direction = Vector3::new(0.2, 0.7, -0.4);
                let t = Dual::variable(Interval::ZERO);
                let along = shape.level(std::array::from_fn(|i| t * direction[i] + x[i]));
                let expected = shape.gauge_gradient(&point).dot(&direction);
                assert!(along.slope.widened(1e-12).contains(expected), "{exponents:?} {x:?}");
                assert!(along.slope.width() < 1e-10);
            }
        }
    }

    #[test]
    fn levels_over_boxes_hold_those_of_their_points() {
        let shape = Superellipsoid::new([2.0, 1.0, 0.5], [0.3, 1.4]).unwrap();
        for lower in [[-0.1, -0.1, -0.1], [0.5, -0.3, 0.2], [-3.0, 1.0, 0.0]] {
            let region = lower.map(|low| Interval::new(low, low + 0.5));
            let level = shape.level(region);
            for share in [[0.0, 0.0, 0.0], [0.2, 0.2, 0.2], [1.0, 0.5, 0.1], [1.0, 1.0, 1.0]] {
                let x = std::array::from_fn(|i| lower[i] + 0.5 * share[i]);
                assert!(level.contains(shape.level(x)), "{region:?} {x:?}");
            }
        }
    }
}
