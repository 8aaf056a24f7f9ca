//! Method 4: the series with a table of logarithms.

use super::Method;
use super::series::Binomial;
use super::square::Square;
use crate::math::elementary::exp;
use crate::shape::LOG_FLOOR;

/// The series of [`Series`](super::Series), `x^(2/e2)` being `exp(2/e2 ln x)` with `ln x` looked
/// up: two exponentials a point, and another power where the exponents differ.
#[derive(Debug, Clone)]
pub struct LogTable {
    square: Square,
    binomial: Binomial,
    /// `ln x_i`. It does not depend on the exponents but by the side of the square.
    logs: Vec<f64>,
}

impl LogTable {
    /// The method for exponents `[e1, e2]` above 0 and so many steps.
    pub fn new(exponents: [f64; 2], steps: usize) -> Self {
        let square = Square::new(exponents, steps);
        let logs = square.coordinates.iter().map(|x| x.ln()).collect();
        Self { binomial: Binomial::new(square.outer), logs, square }
    }
}

impl Method for LogTable {
    fn steps(&self) -> usize {
        self.logs.len()
    }

    fn point(&self, i: usize, j: usize) -> [f64; 3] {
        let Square { coordinates, inner, .. } = &self.square;
        let sum = (inner * self.logs[i]).exp() + (inner * self.logs[j]).exp();
        let share = self.square.share(sum);
        [coordinates[i], coordinates[j], self.binomial.sum::<false>(share)]
    }

    #[inline(always)]
    fn row_for<const FMA: bool>(&self, j: usize, [xs, ys, zs]: [&mut [f64]; 3]) {
        let Square { coordinates, inner, .. } = &self.square;
        let power = |log: f64| {
            let log_power = inner * log;
            exp::<FMA, _>(if log_power > LOG_FLOOR { log_power } else { LOG_FLOOR })
        };
        let row_power = power(self.logs[j]);
        xs.copy_from_slice(coordinates);
        ys.fill(coordinates[j]);
        for (z, &log) in zs.iter_mut().zip(&self.logs) {
            *z = power(log) + row_power;
        }
        self.square.shares::<FMA>(zs);
        for z in zs {
            *z = self.binomial.sum::<FMA>(*z);
        }
    }
}
