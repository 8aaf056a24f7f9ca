//! Masses and area of the solid of three exponents.

use super::ThreeExponent;
use crate::math::beta;
use crate::shape::arc::{ArcNode, arc_nodes};
use crate::shape::mass::MassProperties;

impl ThreeExponent {
    /// In closed form, by Dirichlet's integral.
    pub(super) fn masses(&self) -> MassProperties {
        let inverse = self.exponents.map(f64::recip);
        let box_volume = 8.0 * self.size.iter().product::<f64>();
        let squares = std::array::from_fn(|axis| {
            let mut orders = inverse;
            orders[axis] *= 3.0;
            box_volume * self.size[axis].powi(2) / 3.0 * dirichlet(orders)
        });
        MassProperties::of_symmetric(box_volume * dirichlet(inverse), squares)
    }

    /// Area of the surface, by quadrature in the log-odds of `|x/a1|^n1` against `|y/a2|^n2` and of
    /// both against `|z/a3|^n3`: relative error below 1e-9 for exponents from 1 to 40 and aspects
    /// up to 1:100.
    pub(super) fn area(&self) -> f64 {
        let unit = self.size.into_iter().fold(0.0, f64::max);
        let size = self.size.map(|a| a / unit);
        let least_order = 1.0 / self.exponents.into_iter().fold(0.0, f64::max);
        let nodes: Vec<ArcNode> = arc_nodes(2.0 * least_order).collect();
        let strip = |north: &ArcNode| {
            let sum: f64 = nodes.iter().map(|east| self.area_element(&size, north, east)).sum();
            north.weight * sum
        };
        let sum = nodes.iter().map(strip).sum::<f64>();
        // From slopes to log-odds, twice.
        8.0 * unit * unit * sum / least_order.powi(2)
    }

    /// `|r_alpha x r_beta|` for log-odds alpha and beta, times the weight of beta.
    fn area_element(&self, size: &[f64; 3], north: &ArcNode, east: &ArcNode) -> f64 {
        let [radial, axial] = north.shares;
        let [share_x, share_y] = east.shares;
        let [n1, n2, n3] = self.exponents;
        let x = size[0] * (radial * share_x).powf(1.0 / n1);
        let y = size[1] * (radial * share_y).powf(1.0 / n2);
        let z = size[2] * axial.powf(1.0 / n3);
        let projections = [
            y * z * radial * share_x / (n2 * n3),
            x * z * radial * share_y / (n1 * n3),
            x * y * axial / (n1 * n2),
        ];
        east.weight * projections.iter().map(|p| p * p).sum::<f64>().sqrt()
    }
}

/// Dirichlet's `G(1+a) G(1+b) G(1+c) / G(1+a+b+c)`, with G the Gamma function.
fn dirichlet([a, b, c]: [f64; 3]) -> f64 {
    a * beta(a, 1.0 + b) * c * beta(c, 1.0 + a + b)
}
