//! Volume, inertia and surface area of a deformed shape, by quadrature over its surface.

use nalgebra::{Matrix3, SVector, Vector3};
use rayon::prelude::*;

use super::Deformed;
use crate::deform::map::Deform;
use crate::shape::arc::{ArcNode, arc_rule};
use crate::shape::{MassProperties, Superellipsoid, area_element};

/// Nodes on either side of the diagonal that the quadrature begins and ends with.
const HALF_NODES: [i32; 2] = [40, 320];

/// Volume, first and second moments about a point of the solid, and surface area.
type Integrals = SVector<f64, 11>;

/// The masses of a deformed shape, and how far they have converged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassEstimate {
    /// Volume, centroid and second moments of unit density.
    pub properties: MassProperties,
    /// Area of the surface.
    pub surface_area: f64,
    /// The greatest change of volume, area, centroid and moments when the nodes were last
    /// doubled along both directions, in units of the volume, the area and their powers. The
    /// error is far below it where the deformations are smooth, and about a third of it where they
    /// have kinks.
    pub error: f64,
}

impl Deformed<Superellipsoid> {
    /// The masses, with nodes doubled until they change by less than `tolerance`, or there are
    /// 641 along each quarter of a superellipse.
    ///
    /// By the divergence theorem, with the vector area elements carried along by the normal
    /// transform: `V = 1/3 int X . N dA`, and likewise for `x_i` and `x_i x_j`.
    pub fn mass_estimate(&self, tolerance: f64) -> MassEstimate {
        let origin = Vector3::from(self.chain.forward_of([0.0; 3]));
        let mut half_nodes = HALF_NODES[0];
        loop {
            let [coarse, fine] = self.integrals(&origin, half_nodes);
            let error = relative_change(&coarse, &fine);
            if error <= tolerance || half_nodes >= HALF_NODES[1] {
                return MassEstimate {
                    properties: properties(&fine).moved(&origin),
                    surface_area: fine[10],
                    error,
                };
            }
            half_nodes *= 2;
        }
    }

    /// The integrals by every other node, and by all.
    fn integrals(&self, origin: &Vector3<f64>, half_nodes: i32) -> [Integrals; 2] {
        let [e1, e2] = self.shape.exponents();
        let equator: Vec<ArcNode> = arc_rule(e2, half_nodes).collect();
        let meridian: Vec<ArcNode> = arc_rule(e1, half_nodes).collect();
        let strip = |north_south: &ArcNode| {
            let mut sums = [Integrals::zeros(); 2];
            for (i, east_west) in equator.iter().enumerate() {
                let part = self.integrands(origin, north_south, east_west);
                sums[1] += part;
                if i.is_multiple_of(2) {
                    sums[0] += part;
                }
            }
            sums
        };
        // Strips are added up in their order, so that results do not depend on the threads.
        let strips: Vec<[Integrals; 2]> = meridian.par_iter().map(strip).collect();
        let fine = strips.iter().map(|[_, all]| all).sum();
        let coarse: Integrals = strips.iter().step_by(2).map(|[every_other, _]| every_other).sum();
        [4.0 * coarse, fine]
    }

    /// What a node adds to the integrals in all eight octants.
    fn integrands(
        &self,
        origin: &Vector3<f64>,
        meridian: &ArcNode,
        equator: &ArcNode,
    ) -> Integrals {
        let [a1, a2, a3] = self.shape.size();
        let [radius, height] = meridian.point;
        let [x, y] = equator.point;
        let position = Vector3::new(a1 * radius * x, a2 * radius * y, a3 * height);
        let area = area_element(&[a2 * a3, a1 * a3, a1 * a2], meridian, equator);
        let octants = (0..8).map(|octant| {
            let signs = Vector3::from_fn(|i, _| if octant >> i & 1 == 0 { 1.0 } else { -1.0 });
            let undeformed = position.component_mul(&signs);
            let area = self.chain.normal_transform(&undeformed) * area.component_mul(&signs);
            let deformed = Vector3::from(self.chain.forward_of(undeformed.into()));
            moments(&(deformed - origin), &area)
        });
        octants.sum()
    }
}

/// The fluxes whose divergences are 1, `x_i` and `x_i x_j`, and the area.
fn moments(x: &Vector3<f64>, area: &Vector3<f64>) -> Integrals {
    let flux = x.dot(area);
    let (volume, first, second) = (flux / 3.0, flux / 4.0 * x, flux / 5.0 * x * x.transpose());
    Integrals::from([
        volume,
        first.x,
        first.y,
        first.z,
        second.m11,
        second.m22,
        second.m33,
        second.m12,
        second.m13,
        second.m23,
        area.norm(),
    ])
}

/// The greatest change, in units of the volume or area, and of a length where there is one.
fn relative_change(coarse: &Integrals, fine: &Integrals) -> f64 {
    let change = (fine - coarse).abs();
    let (volume, area) = (fine[0].abs(), fine[10]);
    let length = area.sqrt();
    let first = change.fixed_rows::<3>(1).max() / (volume * length);
    let second = change.fixed_rows::<6>(4).max() / (volume * length * length);
    (change[0] / volume).max(change[10] / area).max(first).max(second)
}

fn properties(sums: &Integrals) -> MassProperties {
    let first = Vector3::new(sums[1], sums[2], sums[3]);
    let second = Matrix3::new(
        sums[4], sums[7], sums[8], sums[7], sums[5], sums[9], sums[8], sums[9], sums[6],
    );
    MassProperties::of_integrals(sums[0], first, second)
}
