//! Masses and area of the solid of three exponents.

use nalgebra::Vector3;

use super::ThreeExponent;
use crate::math::beta;
use crate::shape::arc::{ArcNode, arc_nodes};
use crate::shape::mass::MassProperties;
use crate::shape::patch::SurfaceElement;

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
        let nodes: Vec<ArcNode> = arc_nodes(2.0 * self.least_order()).collect();
        let strip = |north: &ArcNode| -> f64 {
            nodes.iter().map(|east| self.element(north, east).area.norm()).sum()
        };
        8.0 * nodes.iter().map(strip).sum::<f64>()
    }

    /// The reciprocal of the greatest exponent.
    pub(crate) fn least_order(&self) -> f64 {
        1.0 / self.exponents.into_iter().fold(0.0, f64::max)
    }

    /// The point of the octant of positive coordinates, and `r_alpha x r_beta` for log-odds alpha
    /// and beta times the weights of two nodes of exponent `2 least_order`.
    pub(crate) fn element(&self, north: &ArcNode, east: &ArcNode) -> SurfaceElement {
        let [radial, axial] = north.shares;
        let [share_x, share_y] = east.shares;
        let [n1, n2, n3] = self.exponents;
        let x = self.size[0] * (radial * share_x).powf(1.0 / n1);
        let y = self.size[1] * (radial * share_y).powf(1.0 / n2);
        let z = self.size[2] * axial.powf(1.0 / n3);
        let projections = Vector3::new(
            y * z * radial * share_x / (n2 * n3),
            x * z * radial * share_y / (n1 * n3),
            x * y * axial / (n1 * n2),
        );
        // From slopes to log-odds, twice.
        let weight = north.weight * east.weight / self.least_order().powi(2);
        SurfaceElement { position: Vector3::new(x, y, z), area: weight * projections }
    }
}

/// Dirichlet's `G(1+a) G(1+b) G(1+c) / G(1+a+b+c)`, with G the Gamma function.
fn dirichlet([a, b, c]: [f64; 3]) -> f64 {
    a * beta(a, 1.0 + b) * c * beta(c, 1.0 + a + b)
}
