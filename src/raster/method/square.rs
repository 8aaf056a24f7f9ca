//! The square of x and y over which the explicit methods calculate z, one step apart.

use crate::math::elementary::power;

/// Greatest share `s = F - (z/a3)^(2/e1)` at the square's far corner: with equal exponents that
/// is the corner x = y = z of the 48-fold part.
pub(super) const CORNER_SHARE: f64 = 2.0 / 3.0;

/// Equal steps of x and y, and the powers of the explicit equation
/// `z = (1 - (x^(2/e2) + y^(2/e2))^(e2/e1))^(e1/2)`.
#[derive(Debug, Clone)]
pub(super) struct Square {
    /// `x_i`, which are also the `y_i`: middles of the steps.
    pub coordinates: Vec<f64>,
    /// `2/e2`.
    pub inner: f64,
    /// `e2/e1`.
    pub middle: f64,
    /// `e1/2`.
    pub outer: f64,
}

impl Square {
    /// So many steps along each side, for the exponents `[e1, e2]`.
    pub fn new([e1, e2]: [f64; 2], steps: usize) -> Self {
        let middle = e2 / e1;
        let side = (0.5 * CORNER_SHARE.powf(1.0 / middle)).powf(0.5 * e2);
        let coordinates = (0..steps).map(|i| side * (i as f64 + 0.5) / steps as f64).collect();
        Self { coordinates, inner: 2.0 / e2, middle, outer: 0.5 * e1 }
    }

    /// The share s of a sum `x^(2/e2) + y^(2/e2)`.
    pub fn share(&self, sum: f64) -> f64 {
        if self.middle == 1.0 { sum } else { sum.powf(self.middle) }
    }

    /// [`share`](Self::share) of every sum, in place.
    #[inline(always)]
    pub fn shares<const FMA: bool>(&self, sums: &mut [f64]) {
        if self.middle != 1.0 {
            for sum in sums {
                *sum = power::<FMA>(*sum, self.middle);
            }
        }
    }
}
