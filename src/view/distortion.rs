//! Lens distortion after Brown (1966) and Conrady (1919), in OpenCV's form and order.

use serde::{Deserialize, Serialize};

/// Slope `x/z` beyond which no camera's rational polynomial is looked at: 84 degrees off axis.
const GREATEST_SLOPE: f64 = 10.0;

/// Steps in which the slopes are searched for the one at which the image folds back.
const SLOPE_STEPS: u32 = 4096;

/// Newton's steps, at most: it doubles its digits a step.
const NEWTON_STEPS: usize = 50;

/// Largest error, in `x/z`, of a ray whose distortion was undone: far below a pixel.
const INVERSE_TOLERANCE: f64 = 1e-12;

/// Distortion of normalised image coordinates `x/z, y/z`: with `r^2 = x^2 + y^2`
///
/// `x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)`
///
/// and `y'` likewise with `p1 (r^2 + 2 y^2) + 2 p2 x y` (OpenCV, "Camera Calibration and 3D
/// Reconstruction").
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<f64>", into = "Vec<f64>")]
pub struct Distortion {
    /// `k1 k2 p1 p2 k3 k4 k5 k6`.
    coefficients: [f64; 8],
    /// Least `r` at which the image folds back onto itself; infinite if it never does.
    fold: f64,
}

impl Default for Distortion {
    /// None at all.
    fn default() -> Self {
        Self { coefficients: [0.0; 8], fold: f64::INFINITY }
    }
}

impl TryFrom<Vec<f64>> for Distortion {
    type Error = String;

    fn try_from(coefficients: Vec<f64>) -> Result<Self, String> {
        Self::new(&coefficients)
    }
}

impl From<Distortion> for Vec<f64> {
    fn from(distortion: Distortion) -> Self {
        distortion.coefficients.to_vec()
    }
}

impl Distortion {
    /// Distortion of OpenCV's coefficients `k1 k2 p1 p2 [k3 [k4 k5 k6]]`; of none, no distortion.
    /// Further ones, of thin prisms and tilted sensors, must be 0.
    ///
    /// # Errors
    /// If they are not finite, of another number, or further ones are not 0.
    pub fn new(coefficients: &[f64]) -> Result<Self, String> {
        let count = coefficients.len();
        if !matches!(count, 0 | 4 | 5 | 8 | 12 | 14) {
            return Err(format!(
                "distortion coefficients k1 k2 p1 p2 [k3 [k4 k5 k6]], found {count} numbers"
            ));
        }
        if let Some(value) = coefficients.iter().find(|value| !value.is_finite()) {
            return Err(format!("finite distortion coefficients, found {value}"));
        }
        if coefficients.iter().skip(8).any(|value| *value != 0.0) {
            return Err("0 for the distortion of thin prisms and tilted sensors, which is \
                        not modelled"
                .to_owned());
        }
        let of = |k| coefficients.get(k).copied().unwrap_or(0.0);
        let mut distortion = Self { coefficients: std::array::from_fn(of), fold: f64::INFINITY };
        distortion.fold = distortion.find_fold();
        Ok(distortion)
    }

    /// The coefficients `k1 k2 p1 p2 k3 k4 k5 k6`.
    pub fn coefficients(&self) -> [f64; 8] {
        self.coefficients
    }

    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        self.coefficients == [0.0; 8]
    }

    /// The distorted coordinates of `[x/z, y/z]`; none beyond the radius at which the polynomial
    /// folds the image back onto itself, which no lens does.
    pub fn distort(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let [_, _, p1, p2, ..] = self.coefficients;
        let s = x * x + y * y;
        if s.sqrt() >= self.fold {
            return None;
        }
        let (radial, _) = self.radial(s);
        Some([
            x * radial + 2.0 * p1 * x * y + p2 * (s + 2.0 * x * x),
            y * radial + p1 * (s + 2.0 * y * y) + 2.0 * p2 * x * y,
        ])
    }

    /// The coordinates `[x/z, y/z]` that are seen at distorted ones, to 1e-12; none where no ray
    /// is seen.
    pub fn undistort(&self, seen: [f64; 2]) -> Option<[f64; 2]> {
        if self.is_none() {
            return Some(seen);
        }
        let mut at = self.within_fold(seen);
        for _ in 0..NEWTON_STEPS {
            let found = self.distort(at)?;
            let error = [seen[0] - found[0], seen[1] - found[1]];
            if error[0].hypot(error[1]) <= INVERSE_TOLERANCE * (1.0 + seen[0].hypot(seen[1])) {
                return Some(at);
            }
            let [[a, b], [c, d]] = self.jacobian(at);
            let determinant = a * d - b * c;
            at = self.within_fold([
                at[0] + (d * error[0] - b * error[1]) / determinant,
                at[1] + (a * error[1] - c * error[0]) / determinant,
            ]);
        }
        None
    }

    /// The radial factor at `s = r^2`, and its derivative by `s`.
    fn radial(&self, s: f64) -> (f64, f64) {
        let [k1, k2, _, _, k3, k4, k5, k6] = self.coefficients;
        let numerator = 1.0 + s * (k1 + s * (k2 + s * k3));
        let numerator_slope = k1 + s * (2.0 * k2 + s * 3.0 * k3);
        let denominator = 1.0 + s * (k4 + s * (k5 + s * k6));
        let denominator_slope = k4 + s * (2.0 * k5 + s * 3.0 * k6);
        let factor = numerator / denominator;
        (factor, (numerator_slope - factor * denominator_slope) / denominator)
    }

    /// Derivatives of the distorted by the undistorted coordinates.
    fn jacobian(&self, [x, y]: [f64; 2]) -> [[f64; 2]; 2] {
        let [_, _, p1, p2, ..] = self.coefficients;
        let (radial, slope) = self.radial(x * x + y * y);
        let mixed = 2.0 * (x * y * slope + p1 * x + p2 * y);
        [
            [radial + 2.0 * x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x, mixed],
            [mixed, radial + 2.0 * y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x],
        ]
    }

    /// The least radius at which that of the image grows no more.
    fn find_fold(&self) -> f64 {
        let grows = |r: f64| {
            let (radial, slope) = self.radial(r * r);
            radial > 0.0 && radial + 2.0 * r * r * slope > 0.0
        };
        let step = GREATEST_SLOPE / f64::from(SLOPE_STEPS);
        let Some(first) = (1..=SLOPE_STEPS).find(|&i| !grows(step * f64::from(i))) else {
            return f64::INFINITY;
        };
        let (mut low, mut high) = (step * f64::from(first - 1), step * f64::from(first));
        while high - low > INVERSE_TOLERANCE {
            let middle = 0.5 * (low + high);
            if grows(middle) { low = middle } else { high = middle }
        }
        low
    }

    /// The point itself, or the one on its ray from the middle just within the fold.
    fn within_fold(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let r = x.hypot(y);
        let shrink = if r < self.fold { 1.0 } else { (1.0 - 1e-3) * self.fold / r };
        [shrink * x, shrink * y]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lenses() -> [Distortion; 4] {
        [
            Distortion::new(&[-0.28, 0.07, 1e-3, -5e-4]).unwrap(), // barrel
            Distortion::new(&[0.15, -0.2, -2e-3, 1e-3, 0.05]).unwrap(),
            Distortion::new(&[0.1, 0.02, 0.0, 1e-3, 0.001, 0.3, 0.05, 0.0]).unwrap(),
            Distortion::default(),
        ]
    }

    #[test]
    fn is_opencvs_formula() {
        // cv2.projectPoints((0.3, -0.2, 1)) with the identity as camera matrix.
        let lens = Distortion::new(&[-0.28, 0.07, 1e-3, -5e-4, 0.01, 0.02, -0.03, 0.04]).unwrap();
        let [x, y] = lens.distort([0.3, -0.2]).unwrap();
        let s: f64 = 0.13;
        let radial = (1.0 - 0.28 * s + 0.07 * s.powi(2) + 0.01 * s.powi(3))
            / (1.0 + 0.02 * s - 0.03 * s.powi(2) + 0.04 * s.powi(3));
        let expected_x = 0.3 * radial + 2.0 * 1e-3 * 0.3 * -0.2 - 5e-4 * (s + 2.0 * 0.09);
        let expected_y = -0.2 * radial + 1e-3 * (s + 2.0 * 0.04) + 2.0 * -5e-4 * 0.3 * -0.2;
        assert!((x - expected_x).abs() < 1e-15 && (y - expected_y).abs() < 1e-15);
    }

    #[test]
    fn what_is_seen_comes_from_one_ray_and_none_beyond_the_fold() {
        for lens in lenses() {
            for i in -20..=20 {
                for j in -20..=20 {
                    let at = [f64::from(i) * 0.04, f64::from(j) * 0.04];
                    let Some(seen) = lens.distort(at) else { continue };
                    let back = lens.undistort(seen).expect("a ray that is seen");
                    let error = (back[0] - at[0]).hypot(back[1] - at[1]);
                    // Near the fold the image hardly grows with the slope.
                    assert!(error < 1e-9, "{lens:?} {at:?} {error:e}");
                }
            }
        }
        let barrel = Distortion::new(&[-0.28, 0.0, 0.0, 0.0]).unwrap();
        let fold = (1.0_f64 / (3.0 * 0.28)).sqrt();
        assert!(barrel.distort([fold - 1e-9, 0.0]).is_some());
        assert!(barrel.distort([fold + 1e-9, 0.0]).is_none());
        assert!(barrel.undistort([0.8, 0.0]).is_none(), "beyond {}", fold * 2.0 / 3.0);
    }

    #[test]
    fn jacobian_is_its_difference_quotient() {
        let step = 1e-6;
        for lens in lenses() {
            let [[a, b], [c, d]] = lens.jacobian([0.21, -0.34]);
            for (k, by) in [[a, c], [b, d]].into_iter().enumerate() {
                let at = |t: f64| {
                    let mut at = [0.21, -0.34];
                    at[k] += t;
                    lens.distort(at).unwrap()
                };
                for (i, derivative) in by.into_iter().enumerate() {
                    let quotient = (at(step)[i] - at(-step)[i]) / (2.0 * step);
                    assert!((quotient - derivative).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn other_coefficients_are_refused() {
        for (coefficients, expected) in [
            (&[0.1; 3][..], "found 3 numbers"),
            (&[f64::NAN; 4], "finite"),
            (&[0.1; 12], "thin prisms"),
        ] {
            assert!(Distortion::new(coefficients).unwrap_err().contains(expected));
        }
    }
}
