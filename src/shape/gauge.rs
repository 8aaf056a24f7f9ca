//! The gauge of a superellipsoid, `H = F^(e1/2)`, and its logarithmic derivatives.
//!
//! The inside-outside function F (JLS Eq. 2.16) overflows and cancels; its power H is
//! homogeneous of degree one, and needs only ratios of coordinates raised to powers, all of
//! them at most one. With `p(u, v; e) = max (1 + (min/max)^(2/e))^(e/2)`,
//! `H(x) = p(p(|x|/a1, |y|/a2; e2), |z|/a3; e1)`.

use crate::math::lane::Lane;

/// Smallest `|x_i| / a_i` that is told from zero: its square is still far from underflow.
pub(crate) const TINY: f64 = f64::TINY;

/// Lowest logarithm of a ratio's power that is kept: `exp` of it is normal, and vanishes
/// beside one.
pub(crate) const LOG_FLOOR: f64 = f64::LOG_FLOOR;

/// The gauge at a point, and what its derivatives are made of.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GaugeTerms {
    /// Magnitudes of the coordinates, none below a tiny share of its semi-axis.
    pub magnitudes: [f64; 3],
    /// `1 / H`: the factor that moves the point onto the surface along its ray (JLS Eq. 2.42).
    pub inverse: f64,
    /// `d ln H / d ln |x_i|`: not negative, and their sum is one, H being homogeneous.
    pub weights: [f64; 3],
    /// `2 d ln H / d e_k`, each in `[0, ln 2]`.
    pub exponent_slopes: [f64; 2],
    /// Shares of `|x/a1|^(2/e2)` and `|y/a2|^(2/e2)` in their sum.
    pub equator_shares: [f64; 2],
    /// Shannon entropy of the equatorial shares, in `[0, ln 2]`.
    pub equator_entropy: f64,
    /// Log-odds of the shares: of the equatorial against the axial, of x against y.
    pub log_odds: [f64; 2],
}

impl GaugeTerms {
    /// Evaluates the gauge at `x`, in the model's frame.
    pub fn at(x: [f64; 3], size: &[f64; 3], [e1, e2]: &[f64; 2]) -> Self {
        let magnitudes: [f64; 3] = std::array::from_fn(|i| x[i].abs().max(TINY * size[i]));
        let [u, v, w]: [f64; 3] = std::array::from_fn(|i| magnitudes[i] / size[i]);
        let (greatest, least) = if u >= v { (u, v) } else { (v, u) };

        let equator = PowerSum::of_log_ratio((least / greatest).ln(), *e2);
        // ln of the equatorial norm over the axial magnitude.
        let log_ratio = (greatest / w).ln() + 0.5 * e2 * equator.log_sum;
        let meridian = PowerSum::of_log_ratio(-log_ratio.abs(), *e1);

        let (equatorial, axial) = if log_ratio >= 0.0 {
            (meridian.share_greatest, meridian.share_least)
        } else {
            (meridian.share_least, meridian.share_greatest)
        };
        let (share_x, share_y) = if u >= v {
            (equator.share_greatest, equator.share_least)
        } else {
            (equator.share_least, equator.share_greatest)
        };
        let log_norm = 0.5 * e1 * meridian.log_sum;
        let inverse = if log_ratio >= 0.0 {
            (-log_norm - 0.5 * e2 * equator.log_sum).exp() / greatest
        } else {
            (-log_norm).exp() / w
        };
        Self {
            magnitudes,
            inverse,
            weights: [equatorial * share_x, equatorial * share_y, axial],
            exponent_slopes: [meridian.entropy, equatorial * equator.entropy],
            equator_shares: [share_x, share_y],
            equator_entropy: equator.entropy,
            log_odds: [
                (-meridian.log_power).copysign(log_ratio),
                if u >= v { -equator.log_power } else { equator.log_power },
            ],
        }
    }
}

/// A sum `1 + t` of the powers `1` and `t = (least/greatest)^(2/e)`.
struct PowerSum {
    /// `ln t`.
    log_power: f64,
    /// `ln(1 + t)`.
    log_sum: f64,
    /// `1 / (1 + t)`.
    share_greatest: f64,
    /// `t / (1 + t)`.
    share_least: f64,
    /// The Shannon entropy of the two shares, in `[0, ln 2]`.
    entropy: f64,
}

impl PowerSum {
    /// From `ln(least / greatest) <= 0`.
    fn of_log_ratio(log_ratio: f64, e: f64) -> Self {
        let log_power = (2.0 / e * log_ratio).max(LOG_FLOOR);
        let power = log_power.exp();
        let log_sum = power.ln_1p();
        let share_greatest = 1.0 / (1.0 + power);
        let share_least = power * share_greatest;
        let entropy = log_sum - share_least * log_power;
        Self { log_power, log_sum, share_greatest, share_least, entropy }
    }
}
