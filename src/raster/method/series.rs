//! Method 3: three terms of the binomial series.

use super::Method;
use super::square::Square;
use crate::math::elementary::{mul_add, power};

/// `z = 1 - s/n - (n-1)/(2n^2) s^2 - (n-1)(2n-1)/(6n^3) s^3` with `n = 2/e1` and
/// `s = (x^(2/e2) + y^(2/e2))^(e2/e1)`, x by i and y by j in equal steps: two powers a point,
/// three where the exponents differ.
#[derive(Debug, Clone)]
pub struct Series {
    square: Square,
    binomial: Binomial,
}

impl Series {
    /// The method for exponents `[e1, e2]` above 0 and so many steps.
    pub fn new(exponents: [f64; 2], steps: usize) -> Self {
        let square = Square::new(exponents, steps);
        Self { binomial: Binomial::new(square.outer), square }
    }
}

impl Method for Series {
    fn steps(&self) -> usize {
        self.square.coordinates.len()
    }

    fn point(&self, i: usize, j: usize) -> [f64; 3] {
        let Square { coordinates, inner, .. } = &self.square;
        let [x, y] = [coordinates[i], coordinates[j]];
        let sum = x.powf(*inner) + y.powf(*inner);
        [x, y, self.binomial.sum::<false>(self.square.share(sum))]
    }

    #[inline(always)]
    fn row_for<const FMA: bool>(&self, j: usize, [xs, ys, zs]: [&mut [f64]; 3]) {
        let Square { coordinates, inner, .. } = &self.square;
        let row_power = power::<FMA>(coordinates[j], *inner);
        xs.copy_from_slice(coordinates);
        ys.fill(coordinates[j]);
        for (z, &x) in zs.iter_mut().zip(coordinates) {
            *z = power::<FMA>(x, *inner) + row_power;
        }
        self.square.shares::<FMA>(zs);
        for z in zs {
            *z = self.binomial.sum::<FMA>(*z);
        }
    }
}

/// Coefficients of s, s^2 and s^3 in `(1 - s)^p`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Binomial([f64; 3]);

impl Binomial {
    /// The series of the power p.
    pub fn new(p: f64) -> Self {
        let second = -p * (1.0 - p) / 2.0;
        Self([-p, second, second * (2.0 - p) / 3.0])
    }

    /// One and three terms of the series.
    #[inline(always)]
    pub fn sum<const FMA: bool>(&self, s: f64) -> f64 {
        let [first, second, third] = self.0;
        let tail = mul_add::<FMA, _>(third, s, second);
        mul_add::<FMA, _>(mul_add::<FMA, _>(tail, s, first), s, 1.0)
    }
}
