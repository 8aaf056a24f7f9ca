//! A quarter of the unit superellipse as nodes of a quadrature.
//!
//! In the logarithm of the slope, `t = ln(y/x)`, everything on the quarter is smooth and falls
//! off exponentially at both ends, though powers of sines and cosines are neither: `x =
//! (1 + exp(2t/e))^(-e/2)`. A hyperbolic sine spreads the nodes from the diagonal, where small
//! exponents bend within `|t| < e`, to the ends; there the trapezoidal rule converges
//! exponentially.

/// Nodes on either side of the diagonal: areas of aspect 1:100 are then good to 1e-12.
const HALF_NODES: i32 = 80;

/// Slopes `exp(-t)` at which the rule ends vanish beside one.
const LAST_LOG_SLOPE: f64 = 40.0;

/// A node of the quadrature over a quarter of the unit superellipse.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArcNode {
    /// The coordinates `cos^e`, `sin^e`.
    pub point: [f64; 2],
    /// Their `2/e`-th powers, `cos^2` and `sin^2`, of sum one.
    pub shares: [f64; 2],
    /// `dt` of the node; `dx = -x share_y dt` and `dy = y share_x dt`.
    pub weight: f64,
}

/// The parameter v at which a quarter of the unit superellipse ends, at its y axis but for
/// rounding; at `-v` it begins. Domain: `e > 0`.
pub(crate) fn greatest_arc_parameter(e: f64) -> f64 {
    let spread = 0.5 * e;
    (LAST_LOG_SLOPE * spread.max(1.0) / spread).asinh()
}

/// The point `(cos^e, sin^e)` of slope `exp(e/2 sinh v)`. Domain: `e > 0`.
pub(crate) fn quarter_point(e: f64, v: f64) -> [f64; 2] {
    let power = v.sinh();
    [power, -power].map(|power| (-0.5 * e * log_sum(power)).exp())
}

/// The nodes of a quarter of the unit superellipse. Domain: `e > 0`.
pub(crate) fn arc_nodes(e: f64) -> impl Iterator<Item = ArcNode> + Clone {
    arc_rule(e, HALF_NODES)
}

/// So many nodes on either side of the diagonal, and the diagonal; every other of them, with
/// twice the weight, is the rule of half as many. Domain: `e > 0`.
fn arc_rule(e: f64, half_nodes: i32) -> impl Iterator<Item = ArcNode> + Clone {
    let step = greatest_arc_parameter(e) / f64::from(half_nodes);
    (-half_nodes..=half_nodes).map(move |i| {
        let node = arc_node(e, step * f64::from(i));
        ArcNode { weight: step * node.weight, ..node }
    })
}

/// The point at the parameter v, its weight that of `dv`. Domain: `e > 0`.
pub(crate) fn arc_node(e: f64, v: f64) -> ArcNode {
    let spread = 0.5 * e;
    let power = v.sinh(); // ln of (y/x)^(2/e)
    let (log_x, log_y) = (-log_sum(power), -log_sum(-power));
    ArcNode {
        point: [(spread * log_x).exp(), (spread * log_y).exp()],
        shares: [log_x.exp(), log_y.exp()],
        weight: spread * v.cosh(),
    }
}

/// `ln(1 + exp(u))`, without overflow.
fn log_sum(u: f64) -> f64 {
    u.max(0.0) + (-u.abs()).exp().ln_1p()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::superellipse::{unit_area, unit_second_moment};

    #[test]
    fn nodes_integrate_area_and_moment_of_the_superellipse() {
        for e in [0.05, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0, 10.0] {
            let integral = |f: &dyn Fn(ArcNode) -> f64| arc_nodes(e).map(f).sum::<f64>();
            // Area between axis and curve, and the moment of such columns.
            let area = integral(&|n| n.weight * n.point[0] * n.point[1] * n.shares[0]);
            let moment =
                integral(&|n| n.weight * n.point[0].powi(3) / 3.0 * n.point[1] * n.shares[0]);
            assert!((4.0 * area / unit_area(e) - 1.0).abs() < 1e-12, "{e} {area}");
            assert!((4.0 * moment / unit_second_moment(e) - 1.0).abs() < 1e-12, "{e}");
        }
    }
}
