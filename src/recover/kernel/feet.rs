//! Feet of points on a model along the rays of a sensor, whose noise is greater along them than
//! across.
//!
//! Noise of the covariance S makes the distance of a point x from its foot y the Mahalanobis one,
//! `sqrt((x - y)' S^-1 (x - y))`. From x itself the foot is `y = x - d S n / n'S n` to first order, d
//! being the geometric distance and n the normal; around y the distance is, to second,
//! `(d_y + n_y (x - y)) / sqrt(n_y' S n_y)`. That is the geometric distance of a point on the normal
//! through the foot, times a factor: such points take the place of those given.
//!
//! The slope of the surface at the foot does not depend on the noise of the point, so that it errs in
//! no direction, as that at the point itself does.

use super::block::{Scratch, write_powers};
use super::gram::BLOCK;
use super::point::Point;
use super::view::ModelView;
use crate::machine::Products;
use crate::machine::vectorized::Kernel;
use crate::math::lane::{Lane, greater};
use crate::recover::options::Precision;

/// How the noise of a sensor spreads points, in a model's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spread<L = f64> {
    /// Where the sensor is, and 1; or a direction towards it, and 0.
    pub sensor: ([L; 3], L),
    /// Variances along the rays and across them, in any unit: that of the rows' is its root.
    pub along: L,
    pub across: L,
}

/// Points that take the place of others, in the model's frame, and the factors of their rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Feet {
    pub points: [Vec<f64>; 3],
    pub factors: Vec<f64>,
}

/// The feet of some points.
pub(super) struct FeetOf<'a> {
    pub view: &'a ModelView,
    pub spread: &'a Spread,
    pub points: [&'a [f64]; 3],
}

impl Kernel for FeetOf<'_> {
    type Output = Feet;

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) -> Feet {
        match self.view.precision {
            Precision::Single => self.find::<f32, FMA>(),
            Precision::Double => self.find::<f64, FMA>(),
        }
    }
}

impl FeetOf<'_> {
    #[inline(always)]
    fn find<L: Lane, const FMA: bool>(self) -> Feet {
        let Self { view, spread, points: [xs, ys, zs] } = self;
        let in_frame = view.in_model_frame();
        let spread = spread.in_lanes::<L>();
        let count = xs.len();
        let mut feet =
            Feet { points: [0, 1, 2].map(|_| vec![0.0; count]), factors: vec![0.0; count] };
        let mut scratch = Scratch::<L>::new();
        let mut points = [[L::default(); 3]; BLOCK];
        let mut block = [[0.0; BLOCK]; 3];
        for start in (0..count).step_by(BLOCK) {
            let end = count.min(start + BLOCK);
            let given = [&xs[start..end], &ys[start..end], &zs[start..end]];
            write_powers::<L, FMA>(view, given, &mut scratch);
            for (i, x) in points.iter_mut().enumerate() {
                let point = Point::at(view, &scratch, i);
                *x = [scratch.x[0][i], scratch.x[1][i], scratch.x[2][i]];
                let foot = spread.foot(*x, point.normal(), point.geometric_distance());
                write(&mut block, i, foot);
            }
            write_powers::<L, FMA>(&in_frame, block.each_ref().map(|c| &c[..]), &mut scratch);
            for (i, x) in points.iter().enumerate() {
                let normal = Point::at(view, &scratch, i).normal();
                let foot = [scratch.x[0][i], scratch.x[1][i], scratch.x[2][i]];
                write(&mut block, i, onto_normal(*x, foot, normal));
                if let Some(factor) = feet.factors.get_mut(start + i) {
                    *factor = spread.factor(*x, normal).to_f64();
                }
            }
            for (column, block) in feet.points.iter_mut().zip(&block) {
                column[start..end].copy_from_slice(&block[..end - start]);
            }
        }
        feet
    }
}

impl Spread {
    /// The same in the numbers of a pass.
    #[inline(always)]
    fn in_lanes<L: Lane>(&self) -> Spread<L> {
        let ([x, y, z], nearness) = self.sensor;
        Spread {
            sensor: ([L::of(x), L::of(y), L::of(z)], L::of(nearness)),
            along: L::of(self.along),
            across: L::of(self.across),
        }
    }
}

impl<L: Lane> Spread<L> {
    /// `S n` at a point x; at the sensor itself there is no ray.
    #[inline(always)]
    fn times(&self, x: [L; 3], n: [L; 3]) -> [L; 3] {
        let (s, nearness) = self.sensor;
        let ray = [s[0] - nearness * x[0], s[1] - nearness * x[1], s[2] - nearness * x[2]];
        let square = greater(dot(ray, ray), L::TINY * L::TINY);
        let share = (self.along - self.across) * dot(ray, n) / square;
        [
            self.across * n[0] + share * ray[0],
            self.across * n[1] + share * ray[1],
            self.across * n[2] + share * ray[2],
        ]
    }

    #[inline(always)]
    fn foot(&self, x: [L; 3], n: [L; 3], distance: L) -> [L; 3] {
        let spread = self.times(x, n);
        let step = distance / dot(n, spread);
        [x[0] - step * spread[0], x[1] - step * spread[1], x[2] - step * spread[2]]
    }

    #[inline(always)]
    fn factor(&self, x: [L; 3], n: [L; 3]) -> L {
        L::of(1.0) / dot(n, self.times(x, n)).sqrt()
    }
}

/// The projection of a point on the normal through a foot.
#[inline(always)]
fn onto_normal<L: Lane>(x: [L; 3], foot: [L; 3], n: [L; 3]) -> [L; 3] {
    let height = dot(n, [x[0] - foot[0], x[1] - foot[1], x[2] - foot[2]]);
    [foot[0] + height * n[0], foot[1] + height * n[1], foot[2] + height * n[2]]
}

#[inline(always)]
fn dot<L: Lane>(a: [L; 3], b: [L; 3]) -> L {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn write<L: Lane>(block: &mut [[f64; BLOCK]; 3], i: usize, point: [L; 3]) {
    for (column, x) in block.iter_mut().zip(point) {
        column[i] = x.to_f64();
    }
}
