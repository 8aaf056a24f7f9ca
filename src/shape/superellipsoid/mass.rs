//! Volume, inertia and surface area of the superellipsoid (JLS sections 2.4.5 and 2.4.7).

use nalgebra::Vector3;

use super::Superellipsoid;
use crate::math::beta;
use crate::shape::arc::{ArcNode, arc_nodes};
use crate::shape::mass::MassProperties;
use crate::shape::superellipse::{unit_area, unit_second_moment};

impl Superellipsoid {
    /// Volume `2 a1 a2 a3 e1 e2 B(e1/2, e1 + 1) B(e2/2, e2/2 + 1)` (JLS Eq. 2.59).
    pub fn volume(&self) -> f64 {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        a1 * a2 * a3 * unit_area(e2) * e1 * beta(0.5 * e1, e1 + 1.0)
    }

    /// Volume, centroid and second moments of unit density, in the model's frame (JLS Eqs. 2.59
    /// and 2.67-2.69).
    pub fn mass_properties(&self) -> MassProperties {
        let [a1, a2, a3] = self.size;
        let [e1, e2] = self.exponents;
        let box_volume = a1 * a2 * a3;
        let equatorial = box_volume * e1 * unit_second_moment(e2) * beta(0.5 * e1, 2.0 * e1 + 1.0);
        let axial = box_volume * e1 * unit_area(e2) * beta(1.5 * e1, e1 + 1.0);
        let squares = [a1 * a1 * equatorial, a2 * a2 * equatorial, a3 * a3 * axial];
        MassProperties::of_symmetric(self.volume(), squares)
    }

    /// Area of the surface, by quadrature.
    ///
    /// The relative error is below 1e-9 for exponents from 0.05 to 2 and aspects up to 1:100.
    pub fn surface_area(&self) -> f64 {
        let unit = self.size.into_iter().fold(0.0, f64::max);
        let [a1, a2, a3] = self.size.map(|a| a / unit);
        let faces = [a2 * a3, a1 * a3, a1 * a2];
        let [e1, e2] = self.exponents;
        let equator: Vec<ArcNode> = arc_nodes(e2).collect();
        let strip = |meridian: ArcNode| {
            equator.iter().map(|node| area_element(&faces, &meridian, node).norm()).sum::<f64>()
        };
        8.0 * unit * unit * arc_nodes(e1).map(strip).sum::<f64>()
    }
}

/// `r_eta x r_omega` (JLS Eq. 2.36) of the octant of positive coordinates, outwards, in the
/// logarithms of the slopes of both superellipses, times both weights.
///
/// `faces` are the products of two semi-axes each.
pub(crate) fn area_element(
    faces: &[f64; 3],
    meridian: &ArcNode,
    equator: &ArcNode,
) -> Vector3<f64> {
    let ([radius, height], [radial, axial]) = (meridian.point, meridian.shares);
    let ([x, y], [share_x, share_y]) = (equator.point, equator.shares);
    let upright = height * radius * radial;
    let projections = Vector3::new(
        faces[0] * upright * y * share_x,
        faces[1] * upright * x * share_y,
        faces[2] * radius * radius * axial * x * y,
    );
    meridian.weight * equator.weight * projections
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Resolution, sample_solid, tessellate};
    use std::f64::consts::PI;

    const EXPONENTS: [f64; 6] = [0.05, 0.1, 0.5, 1.0, 1.5, 2.0];
    const NEAR_ZERO: f64 = 1e-5;

    fn shape(size: [f64; 3], exponents: [f64; 2]) -> Superellipsoid {
        Superellipsoid::new(size, exponents).unwrap()
    }

    fn exponent_pairs() -> impl Iterator<Item = [f64; 2]> {
        EXPONENTS.into_iter().flat_map(|e1| EXPONENTS.map(|e2| [e1, e2]))
    }

    /// JLS Table 2.3; the cube's line is for half-sizes, 8/3 in place of 1/12.
    #[test]
    fn inertia_of_jls_table_2_3() {
        let [a, b, c] = [2.0, 0.5, 3.0];
        let sums = [b * b + c * c, a * a + c * c, a * a + b * b];
        for (e, factor) in [(1.0, 4.0 / 15.0 * PI), (NEAR_ZERO, 8.0 / 3.0)] {
            let inertia = shape([a, b, c], [e, e]).mass_properties().inertia();
            for (axis, sum) in sums.into_iter().enumerate() {
                let expected = factor * a * b * c * sum;
                // Exponent 0 is approached, the error being quadratic.
                assert!((inertia[(axis, axis)] / expected - 1.0).abs() < 1e-9, "{e}");
            }
        }
    }

    #[test]
    fn inertia_is_that_of_points_uniform_in_the_solid() {
        for exponents in exponent_pairs() {
            let shape = shape([2.0, 0.5, 3.0], exponents);
            let mass = shape.mass_properties();
            let points = sample_solid(&shape, 20_000, 3);
            for axis in 0..3 {
                let scale = shape.size()[axis].powi(2);
                let mean = points.iter().map(|x| x[axis] * x[axis]).sum::<f64>() / 20_000.0;
                let expected = mass.second_moments()[(axis, axis)] / mass.volume();
                // Squares in [0, 1] deviate by at most 1/2: five standard errors.
                assert!((mean - expected).abs() < 2.5 * scale / 20_000.0_f64.sqrt());
                assert!(expected > 0.03 * scale && expected < 0.34 * scale, "{exponents:?}");
            }
        }
    }

    #[test]
    fn masses_scale_with_powers_of_the_size() {
        for factor in [1e-6, 1e3] {
            let [small, large] = [1.0, factor].map(|f| shape([2.0 * f, 0.5 * f, f], [0.3, 1.4]));
            let [before, after] = [&small, &large].map(Superellipsoid::mass_properties);
            let ratios = [
                after.volume() / before.volume() / factor.powi(3),
                after.inertia().norm() / before.inertia().norm() / factor.powi(5),
                large.surface_area() / small.surface_area() / factor.powi(2),
            ];
            assert!(ratios.iter().all(|ratio| (ratio - 1.0).abs() < 1e-13));
        }
    }

    #[test]
    fn closed_forms_of_the_area() {
        let sqrt3 = 3.0_f64.sqrt();
        let prolate = |a: f64, c: f64| {
            let eccentricity = (1.0 - a * a / (c * c)).sqrt();
            2.0 * PI * a * a * (1.0 + c / (a * eccentricity) * eccentricity.asin())
        };
        for (size, exponents, expected) in [
            ([2.0; 3], [1.0, 1.0], 16.0 * PI),
            ([1.0, 1.0, 100.0], [1.0, 1.0], prolate(1.0, 100.0)),
            ([1.0, 2.0, 3.0], [NEAR_ZERO, NEAR_ZERO], 88.0),
            ([1.0, 1.0, 1.0], [2.0, 2.0], 4.0 * sqrt3),
            // Two cones, and a cylinder.
            ([3.0, 3.0, 4.0], [2.0, 1.0], 30.0 * PI),
            ([1.0, 1.0, 5.0], [NEAR_ZERO, 1.0], 22.0 * PI),
        ] {
            let area = shape(size, exponents).surface_area();
            // Of exponent 1e-5 in place of 0 the edges take a share of that order.
            let tolerance = if exponents[0] == NEAR_ZERO { 1e-4 } else { 1e-12 };
            assert!((area / expected - 1.0).abs() < tolerance, "{exponents:?} {area} {expected}");
        }
    }

    #[test]
    fn the_area_does_not_depend_on_which_axis_is_z() {
        for e in EXPONENTS {
            for [a, b, c] in [[1.0, 1.0, 1.0], [1.0, 2.0, 3.0], [100.0, 1.0, 30.0]] {
                let orders = [[a, b, c], [b, c, a], [c, a, b]];
                let [x, y, z] = orders.map(|size| shape(size, [e, e]).surface_area());
                assert!((x / y - 1.0).abs() < 1e-10 && (x / z - 1.0).abs() < 1e-10, "{e} {a}");
            }
        }
    }

    #[test]
    fn the_area_is_the_limit_of_inscribed_meshes() {
        for exponents in exponent_pairs() {
            let shape = shape([2.0, 0.5, 3.0], exponents);
            let area = shape.surface_area();
            let [coarse, fine] =
                [32, 64].map(|n| tessellate(&shape, Resolution::new(n).unwrap()).area());
            // A convex mesh in a convex solid has less area, short by the square of its step.
            assert!(coarse < area * (1.0 + 1e-12) && fine < area * (1.0 + 1e-12));
            assert!(fine / area > 1.0 - 5e-4, "{exponents:?} {}", fine / area);
        }
    }

    /// The cone measure: the mean of `1/(3 |grad H|)`, distance of a tangent plane over three,
    /// weighed by area, is the volume.
    #[test]
    fn volume_is_the_integral_over_the_surface_by_the_divergence_theorem() {
        for exponents in exponent_pairs() {
            let shape = shape([2.0, 0.5, 3.0], exponents);
            let points = crate::surface::sample_surface(&shape, 20_000, 5);
            let height = |x: &Vector3<f64>| 1.0 / (3.0 * shape.gauge_gradient(x).norm());
            let heights: Vec<f64> = points.iter().map(height).collect();
            let mean = heights.iter().sum::<f64>() / 20_000.0;
            let squares: f64 = heights.iter().map(|h| (h - mean).powi(2)).sum();
            let standard_error = squares.sqrt() / 20_000.0;
            let volume = mean * shape.surface_area();
            // Where all planes are equally far, only rounding is left.
            let bound = (5.0 * standard_error + 1e-13) * shape.surface_area();
            assert!((volume - shape.volume()).abs() < bound, "{exponents:?}");
        }
    }
}
