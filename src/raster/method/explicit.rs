//! Method 2: the exact explicit equation.

use super::Method;
use super::square::Square;
use crate::math::elementary::power;

/// `z = (1 - (x^(2/e2) + y^(2/e2))^(e2/e1))^(e1/2)`, x by i and y by j in equal steps: three
/// powers a point, four where the exponents differ.
#[derive(Debug, Clone)]
pub struct Explicit {
    square: Square,
}

impl Explicit {
    /// The method for exponents `[e1, e2]` above 0 and so many steps.
    pub fn new(exponents: [f64; 2], steps: usize) -> Self {
        Self { square: Square::new(exponents, steps) }
    }
}

impl Method for Explicit {
    fn steps(&self) -> usize {
        self.square.coordinates.len()
    }

    fn point(&self, i: usize, j: usize) -> [f64; 3] {
        let Square { coordinates, inner, outer, .. } = &self.square;
        let [x, y] = [coordinates[i], coordinates[j]];
        let sum = x.powf(*inner) + y.powf(*inner);
        [x, y, (1.0 - self.square.share(sum)).powf(*outer)]
    }

    #[inline(always)]
    fn row_for<const FMA: bool>(&self, j: usize, [xs, ys, zs]: [&mut [f64]; 3]) {
        let Square { coordinates, inner, outer, .. } = &self.square;
        let row_power = power::<FMA>(coordinates[j], *inner);
        xs.copy_from_slice(coordinates);
        ys.fill(coordinates[j]);
        for (z, &x) in zs.iter_mut().zip(coordinates) {
            *z = power::<FMA>(x, *inner) + row_power;
        }
        self.square.shares::<FMA>(zs);
        for z in zs {
            *z = power::<FMA>(1.0 - *z, *outer);
        }
    }
}
