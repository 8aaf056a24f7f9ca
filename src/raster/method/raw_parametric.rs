//! Method 1: the raw parametric one.

use std::f64::consts::FRAC_PI_2;

use super::Method;
use crate::math::elementary::{power, sin_cos};

/// `(cos^e1 eta cos^e2 omega, cos^e1 eta sin^e2 omega, sin^e1 eta)` (JLS Eq. 2.10), eta by j and
/// omega by i in equal steps over 0..pi/2: four sines and cosines and four powers a point.
#[derive(Debug, Clone)]
pub struct RawParametric {
    exponents: [f64; 2],
    angles: Vec<f64>,
}

impl RawParametric {
    /// The method for exponents `[e1, e2]` above 0 and so many steps.
    pub fn new(exponents: [f64; 2], steps: usize) -> Self {
        let angles = (0..steps).map(|i| FRAC_PI_2 * (i as f64 + 0.5) / steps as f64).collect();
        Self { exponents, angles }
    }
}

impl Method for RawParametric {
    fn steps(&self) -> usize {
        self.angles.len()
    }

    fn point(&self, i: usize, j: usize) -> [f64; 3] {
        let [e1, e2] = self.exponents;
        let (sin_eta, cos_eta) = self.angles[j].sin_cos();
        let (sin_omega, cos_omega) = self.angles[i].sin_cos();
        [
            cos_eta.powf(e1) * cos_omega.powf(e2),
            cos_eta.powf(e1) * sin_omega.powf(e2),
            sin_eta.powf(e1),
        ]
    }

    #[inline(always)]
    fn row_for<const FMA: bool>(&self, j: usize, [xs, ys, zs]: [&mut [f64]; 3]) {
        let [e1, e2] = self.exponents;
        let [sin_eta, cos_eta] = sin_cos::<FMA>(self.angles[j]);
        let parallel = power::<FMA>(cos_eta, e1);
        zs.fill(power::<FMA>(sin_eta, e1));
        for ((x, y), &omega) in xs.iter_mut().zip(ys.iter_mut()).zip(&self.angles) {
            [*y, *x] = sin_cos::<FMA>(omega);
        }
        for column in [xs, ys] {
            for sine_or_cosine in column {
                *sine_or_cosine = parallel * power::<FMA>(*sine_or_cosine, e2);
            }
        }
    }
}
