//! The one form of B81's four inside-outside functions, and its derivatives.
//!
//! With `u v w` the coordinates over the semi-axes, each is
//! `F = s(rho - a4) +- |w|^(2/e1)`, where `rho = (|u|^(2/e2) +- |v|^(2/e2))^(e2/2)` is of degree
//! one and `s` is the signed power `2/e1` where rho has a minus, else that of the magnitude.
//! Ratios keep small exponents from overflowing.

use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

use super::curve::{Jet, sign, times};

/// The parameters of one of the four functions.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BarrForm {
    pub size: [f64; 3],
    pub exponents: [f64; 2],
    /// The offset a4: 0 for all but the supertoroid.
    pub ring: f64,
    /// The signs of y and z.
    pub signs: [f64; 2],
}

/// The derivatives of F in the model's coordinates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FormDerivatives {
    pub gradient: Vector3<f64>,
    pub hessian: Matrix3<f64>,
}

impl BarrForm {
    /// F at a point.
    pub fn value(&self, x: &Vector3<f64>) -> f64 {
        let [u, v, w] = self.ratios(x);
        let [e1, e2] = self.exponents;
        let rho = equator_norm(u.abs(), v.abs(), e2, self.signs[0]);
        let power = magnitude_power(rho - self.ring, 2.0 / e1).value;
        let equatorial = if rho < 0.0 { -power } else { power };
        equatorial + self.signs[1] * w.abs().powf(2.0 / e1)
    }

    /// The derivatives of F at a point.
    pub fn derivatives(&self, x: &Vector3<f64>) -> FormDerivatives {
        let [u, v, w] = self.ratios(x);
        let power = 2.0 / self.exponents[0];
        let axial = magnitude_power(w, power);
        let (slopes, bends) = self.equatorial(u, v, power);
        let s = self.signs[1];
        let slopes = Vector3::new(slopes.x, slopes.y, s * axial.first);
        let mut hessian = Matrix3::zeros();
        hessian.fixed_view_mut::<2, 2>(0, 0).copy_from(&bends);
        hessian[(2, 2)] = s * axial.second;
        let scale = self.size.map(f64::recip);
        FormDerivatives {
            gradient: Vector3::from_fn(|i, _| slopes[i] * scale[i]),
            hessian: Matrix3::from_fn(|i, j| hessian[(i, j)] * (scale[i] * scale[j])),
        }
    }

    fn ratios(&self, x: &Vector3<f64>) -> [f64; 3] {
        std::array::from_fn(|i| x[i] / self.size[i])
    }

    /// First and second derivatives of the equatorial term by u and v.
    fn equatorial(&self, u: f64, v: f64, power: f64) -> (Vector2<f64>, Matrix2<f64>) {
        let sigma = self.signs[0];
        if sigma < 0.0 && v.abs() > u.abs() {
            // Odd in the exchange of u and v.
            let (slopes, bends) = self.equatorial(v, u, power);
            let exchanged =
                Matrix2::new(bends[(1, 1)], bends[(0, 1)], bends[(0, 1)], bends[(0, 0)]);
            return (-Vector2::new(slopes.y, slopes.x), -exchanged);
        }
        let rho = equator_norm(u.abs(), v.abs(), self.exponents[1], sigma);
        let outer = magnitude_power(rho - self.ring, power);
        if rho == 0.0 {
            return self.where_rho_vanishes(u, v, outer);
        }
        let (slopes, bends) = norm_derivatives(u, v, rho, 2.0 / self.exponents[1] - 1.0, sigma);
        let gradient = slopes.map(|slope| times(outer.first, slope));
        let hessian = Matrix2::from_fn(|i, j| {
            times(outer.second, slopes[i] * slopes[j]) + times(outer.first, bends[(i, j)])
        });
        (gradient, hessian)
    }

    /// The derivatives where rho vanishes: on the axis, or on the asymptotes of the function
    /// with a minus.
    fn where_rho_vanishes(&self, u: f64, v: f64, outer: Jet) -> (Vector2<f64>, Matrix2<f64>) {
        if u == 0.0 {
            // The tip of rho's cone, of which the outer power makes a smooth bottom or not.
            let bend = if self.ring > 0.0 { f64::NEG_INFINITY } else { outer.second };
            return (Vector2::zeros(), Matrix2::from_diagonal_element(bend));
        }
        let [e1, e2] = self.exponents;
        let [along_u, along_v] = [u, v].map(|t| magnitude_power(t, 2.0 / e2));
        let slope = e2 / e1 * 0.0_f64.powf(e2 / e1 - 1.0);
        let gradient = Vector2::new(along_u.first, -along_v.first).map(|d| times(slope, d));
        let bends = Vector2::new(along_u.second, -along_v.second).map(|d| times(slope, d));
        (gradient, Matrix2::from_diagonal(&bends))
    }
}

/// `rho` of magnitudes u and v; with a minus it is odd in their exchange.
pub(crate) fn equator_norm(u: f64, v: f64, e: f64, sigma: f64) -> f64 {
    if sigma > 0.0 {
        return crate::math::superellipse_norm(u, v, e);
    }
    if v > u { -hyperbola_norm(v, u, e) } else { hyperbola_norm(u, v, e) }
}

/// `(u^(2/e) - v^(2/e))^(e/2)` for `u >= v >= 0`, without overflow and cancellation.
pub(crate) fn hyperbola_norm(u: f64, v: f64, e: f64) -> f64 {
    if v == 0.0 {
        return u;
    }
    u * (-(2.0 / e * (v / u).ln()).exp_m1()).powf(0.5 * e)
}

/// First and second derivatives of `rho > 0` by u and v, `k = 2/e2 - 1`.
fn norm_derivatives(u: f64, v: f64, rho: f64, k: f64, sigma: f64) -> (Vector2<f64>, Matrix2<f64>) {
    let [ru, rv] = [u.abs() / rho, v.abs() / rho];
    let [du, dv] = [ru.powf(k), sigma * rv.powf(k)];
    let bend = |ratio: f64, other: f64| times(times(k, ratio.powf(k - 1.0)), other) / rho;
    let mixed = -k * times(times(sign(u), du), times(sign(v), dv)) / rho;
    let slopes = Vector2::new(times(sign(u), du), times(sign(v), dv));
    (slopes, Matrix2::new(bend(ru, times(rv, dv)), mixed, mixed, sigma * bend(rv, times(ru, du))))
}

/// `|t|^p` with its derivatives; at 0 the first is 0, t being even.
pub(crate) fn magnitude_power(t: f64, p: f64) -> Jet {
    let magnitude = t.abs();
    Jet {
        value: magnitude.powf(p),
        first: times(sign(t), p * magnitude.powf(p - 1.0)),
        second: times(p * (p - 1.0), magnitude.powf(p - 2.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_sheets(exponents: [f64; 2]) -> BarrForm {
        BarrForm { size: [1.0; 3], exponents, ring: 0.0, signs: [-1.0, -1.0] }
    }

    #[test]
    fn on_the_asymptote_a_quadric_has_its_own_derivatives() {
        let form = two_sheets([1.0, 1.0]);
        let derivatives = form.derivatives(&Vector3::new(2.0, -2.0, 0.5));
        assert_eq!(derivatives.gradient, Vector3::new(4.0, 4.0, -1.0));
        let bends = Vector3::new(2.0, -2.0, -2.0);
        assert_eq!(derivatives.hessian, Matrix3::from_diagonal(&bends));
        // Nearby they are those of the same polynomial.
        let near = form.derivatives(&Vector3::new(2.0, -2.0 + 1e-9, 0.5));
        assert!((near.gradient - Vector3::new(4.0, 4.0, -1.0)).amax() < 1e-8);
    }

    #[test]
    fn between_the_sheets_the_function_is_odd_in_the_exchange_of_x_and_y() {
        for exponents in [[0.5, 1.0], [1.0, 1.5], [2.0, 0.3]] {
            let form = two_sheets(exponents);
            let [there, here] = [Vector3::new(0.3, 0.8, 0.0), Vector3::new(0.8, 0.3, 0.0)];
            assert!((form.value(&there) + form.value(&here)).abs() < 1e-15);
            let [a, b] = [there, here].map(|x| form.derivatives(&x).gradient);
            assert!((a.x + b.y).abs() < 1e-13 && (a.y + b.x).abs() < 1e-13);
        }
    }

    #[test]
    fn kilometres_and_micrometres_of_small_exponents_do_not_overflow() {
        let form = BarrForm { size: [1e-6; 3], exponents: [1.0, 0.05], ring: 0.0, signs: [1.0; 2] };
        let x = Vector3::new(1e3, -1e3, 1e3);
        let derivatives = form.derivatives(&x);
        assert!((form.value(&x) / (2e18 * 2.0_f64.powf(0.05) / 2.0 + 1e18) - 1.0).abs() < 1e-12);
        assert!(derivatives.gradient.iter().all(|d| d.is_finite() && *d != 0.0));
        assert!(derivatives.hessian.iter().all(|d| d.is_finite()));
    }
}
