//! Method 5: the spherical product of superellipses calculated before.

use super::Method;

/// `(m1 h1, m1 h2, m2)` with points `m = (m1, m2)` of the meridian by j and `h = (h1, h2)` of
/// the equator by i (B81's spherical product): three look-ups and two products a point.
#[derive(Debug, Clone)]
pub struct SphericalProduct {
    meridian: [Vec<f64>; 2],
    equator: [Vec<f64>; 2],
}

impl SphericalProduct {
    /// The method for exponents `[e1, e2]` above 0 and so many steps, equal ones of the angle
    /// whose sine and cosine are raised to the exponents, as [`RawParametric`] takes them.
    ///
    /// [`RawParametric`]: super::RawParametric
    pub fn new([e1, e2]: [f64; 2], steps: usize) -> Self {
        Self { meridian: quarter(e1, steps), equator: quarter(e2, steps) }
    }
}

/// The coordinates `cos^e` and `sin^e` in the first quadrant.
fn quarter(e: f64, steps: usize) -> [Vec<f64>; 2] {
    let angle = |i: usize| std::f64::consts::FRAC_PI_2 * (i as f64 + 0.5) / steps as f64;
    [
        (0..steps).map(|i| angle(i).cos().powf(e)).collect(),
        (0..steps).map(|i| angle(i).sin().powf(e)).collect(),
    ]
}

impl Method for SphericalProduct {
    fn steps(&self) -> usize {
        self.equator[0].len()
    }

    fn point(&self, i: usize, j: usize) -> [f64; 3] {
        let [m1, m2] = [self.meridian[0][j], self.meridian[1][j]];
        [m1 * self.equator[0][i], m1 * self.equator[1][i], m2]
    }

    #[inline(always)]
    fn row_for<const FMA: bool>(&self, j: usize, [xs, ys, zs]: [&mut [f64]; 3]) {
        let m1 = self.meridian[0][j];
        for (column, equator) in [xs, ys].into_iter().zip(&self.equator) {
            for (coordinate, h) in column.iter_mut().zip(equator) {
                *coordinate = m1 * h;
            }
        }
        zs.fill(self.meridian[1][j]);
    }
}
