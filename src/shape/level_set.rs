//! The inside of a shape, in any numbers.

use super::{
    Shape, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
    ThreeExponent,
};
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

impl<L: LevelSet> LevelSet for &L {
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        (**self).level(x)
    }
}

impl LevelSet for Superellipsoid {
    /// The gauge.
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        let [e1, e2] = self.exponents();
        let [u, v, w] = magnitudes(x, &self.size());
        S::superellipse_norm(S::superellipse_norm(u, v, e2), w, e1)
    }
}

impl LevelSet for SuperhyperboloidOneSheet {
    /// The greater of `rho / (1 + |z/a3|^(2/e1))^(e1/2)` and `|z| / clip`, rho being the norm of
    /// the equator.
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        let [e1, e2] = self.exponents();
        let [u, v, w] = magnitudes(x, &self.size());
        let waist = S::superellipse_norm(S::constant(1.0), w, e1);
        let round = S::superellipse_norm(u, v, e2) * waist.recip();
        round.max(x[2].abs() * self.clip().recip())
    }
}

impl LevelSet for SuperhyperboloidTwoSheets {
    /// The greater of `1 + (|y/a2|^(2/e2) + (1 + |z/a3|^(2/e1))^(e1/e2))^(e2/2) - |x/a1|` and
    /// `|x| / clip`.
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        let [e1, e2] = self.exponents();
        let [u, v, w] = magnitudes(x, &self.size());
        let upright = S::superellipse_norm(S::constant(1.0), w, e1);
        let bowl = S::superellipse_norm(v, upright, e2) - u + 1.0;
        bowl.max(x[0].abs() * self.clip().recip())
    }
}

impl LevelSet for Supertoroid {
    /// The norm of the tube.
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        let [e1, e2] = self.exponents();
        let [u, v, w] = magnitudes(x, &self.size());
        let across = S::superellipse_norm(u, v, e2) + -self.ring();
        S::superellipse_norm(across.abs(), w, e1)
    }
}

impl LevelSet for ThreeExponent {
    /// The inside-outside function.
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        let [u, v, w] = magnitudes(x, &self.size());
        let [n1, n2, n3] = self.exponents();
        u.power(n1) + v.power(n2) + w.power(n3)
    }
}

impl LevelSet for Shape {
    fn level<S: Scalar>(&self, x: [S; 3]) -> S {
        match self {
            Self::Superellipsoid(shape) => shape.level(x),
            Self::SuperhyperboloidOneSheet(shape) => shape.level(x),
            Self::SuperhyperboloidTwoSheets(shape) => shape.level(x),
            Self::Supertoroid(shape) => shape.level(x),
            Self::ThreeExponent(shape) => shape.level(x),
        }
    }
}

/// `|x_i| / a_i`.
fn magnitudes<S: Scalar>(x: [S; 3], size: &[f64; 3]) -> [S; 3] {
    std::array::from_fn(|i| (x[i] * size[i].recip()).abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Dual, Interval};
    use nalgebra::Vector3;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

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

    fn shapes() -> Vec<Shape> {
        let size = [1.2, 0.8, 0.5];
        let mut shapes = Vec::new();
        for e in [[0.1, 0.4], [1.0, 1.0], [1.5, 0.7], [2.0, 2.5]] {
            shapes.push(Superellipsoid::new(size, e).unwrap().into());
            shapes.push(SuperhyperboloidOneSheet::new(size, e, 0.9).unwrap().into());
            shapes.push(SuperhyperboloidTwoSheets::new(size, e, 2.5).unwrap().into());
            shapes.push(Supertoroid::new(size, e, 2.0).unwrap().into());
        }
        shapes.push(ThreeExponent::new(size, [0.8, 3.0, 2.0]).unwrap().into());
        shapes
    }

    #[test]
    fn the_level_is_below_one_where_a_shape_of_any_family_is() {
        use super::super::Solid;
        let mut rng = ChaCha8Rng::seed_from_u64(9);
        for shape in shapes() {
            let mut inside = 0;
            for _ in 0..4000 {
                let x = [3.0, 2.0, 1.0].map(|half| half * (2.0 * rng.random::<f64>() - 1.0));
                let is_inside = shape.contains(&x.into());
                assert_eq!(shape.level(x) < 1.0, is_inside, "{shape:?} {x:?}");
                inside += u32::from(is_inside);
            }
            assert!(inside > 20, "{shape:?}");
        }
    }

    #[test]
    fn levels_and_slopes_along_a_line_hold_those_of_its_points() {
        let mut rng = ChaCha8Rng::seed_from_u64(10);
        let mut draw = || Vector3::from_fn(|_, _| 2.0 * rng.random::<f64>() - 1.0);
        for shape in shapes() {
            for _ in 0..200 {
                let (x, direction) = (2.0 * draw(), draw());
                let at = |t: f64| shape.level((x + t * direction).into());
                let t = Dual::variable(Interval::new(0.0, 0.5));
                let over = shape.level(std::array::from_fn(|i| t * direction[i] + x[i]));
                for (before, after) in [(0.0, 0.5), (0.1, 0.2), (0.3, 0.31)] {
                    let slack = 1e-12 * over.value.hi().abs();
                    assert!(over.value.widened(slack).contains(at(before)), "{shape:?}");
                    let quotient = (at(after) - at(before)) / (after - before);
                    let slack = 1e-10 * (1.0 + over.value.hi().abs());
                    assert!(over.slope.widened(slack).contains(quotient), "{shape:?} {over:?}");
                }
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
