//! Quadrature that ends may be singular for.

use std::f64::consts::{FRAC_PI_2, PI};

/// Nodes per unit of the transformed variable: integrands with a singularity a twentieth of the
/// interval off are then good to 1e-12.
const DENSITY: i32 = 24;

/// Where the weights have fallen below rounding.
const LAST: f64 = 3.3;

/// The integral of a function over an interval, by the double exponential rule of Takahasi and
/// Mori (1974): it converges exponentially, though the function may have an infinite slope or an
/// integrable pole at the ends.
fn integral(f: impl Fn(f64) -> f64, range: [f64; 2]) -> f64 {
    let last = (LAST * f64::from(DENSITY)) as i32;
    let node = |i: i32| {
        let (x, weight) = double_exponential(f64::from(i) / f64::from(DENSITY), range);
        if weight == 0.0 { 0.0 } else { weight * f(x) }
    };
    (-last..=last).map(node).sum::<f64>() / f64::from(DENSITY)
}

/// The range of t that the double exponential rule's places are beyond for no more than rounding.
pub(crate) const DOUBLE_EXPONENTIAL: [f64; 2] = [-LAST, LAST];

/// The place x in an interval of the double exponential rule's variable t, and `dx/dt`.
pub(crate) fn double_exponential(t: f64, [from, to]: [f64; 2]) -> (f64, f64) {
    let length = to - from;
    let u = PI * t.sinh();
    // The shares of the interval on either side of the place.
    let [before, after] = [(1.0 + (-u).exp()).recip(), (1.0 + u.exp()).recip()];
    let x = if u < 0.0 { from + length * before } else { to - length * after };
    (x, length * 2.0 * FRAC_PI_2 * t.cosh() * before * after)
}

/// The integral over an interval cut where the function bends sharply; cuts outside are ignored.
pub(crate) fn integral_in_pieces(f: impl Fn(f64) -> f64, range: [f64; 2], cuts: &[f64]) -> f64 {
    let mut ends: Vec<f64> =
        cuts.iter().copied().filter(|&cut| range[0] < cut && cut < range[1]).collect();
    ends.extend(range);
    ends.sort_by(f64::total_cmp);
    let pieces = ends.windows(2).filter(|piece| piece[0] < piece[1]);
    pieces.map(|piece| integral(&f, [piece[0], piece[1]])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrals_of_smooth_singular_and_bent_functions() {
        let cases: [(f64, f64); 4] = [
            (integral(|x| x.exp(), [0.0, 1.0]), 1.0_f64.exp() - 1.0),
            (integral(|x| x.powf(-0.5), [0.0, 1.0]), 2.0),
            (integral(|x| (1.0 - x * x).sqrt(), [-1.0, 1.0]), FRAC_PI_2),
            (integral_in_pieces(|x| (x - 1.0).abs(), [0.0, 3.0], &[1.0, 7.0]), 2.5),
        ];
        for (found, expected) in cases {
            // The pole's integral lacks what lies nearer than the last node.
            let tolerance = if expected == 2.0 { 1e-8 } else { 1e-14 };
            assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
        }
    }
}
