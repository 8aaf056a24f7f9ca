//! How far apart two surfaces are on average.

use rayon::prelude::*;

use super::RelativePose;
use super::nearest::EuclideanProjection;
use crate::model::Model;
use crate::surface::sample_surface;

/// Mean distance of two surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceDistance {
    /// Mean distance, over the mean semi-axis of the first model.
    pub relative_mean: f64,
    /// Standard error of `relative_mean`.
    pub standard_error: f64,
}

/// The symmetric mean surface distance (Chamfer distance) of two models, relative to the mean
/// semi-axis of `a`; the same for the same seed.
///
/// The mean of two means, each of the Euclidean distances from `samples` points of one surface,
/// uniform by area, to the other surface. Domain: exponents up to 2.
pub fn surface_distance(a: &Model, b: &Model, samples: usize, seed: u64) -> SurfaceDistance {
    let means = [(a, b), (b, a)].map(|(from, to)| directed_mean(from, to, samples, seed));
    let unit = a.shape.mean_semi_axis();
    SurfaceDistance {
        relative_mean: 0.5 * (means[0].mean + means[1].mean) / unit,
        standard_error: 0.5 * means[0].standard_error.hypot(means[1].standard_error) / unit,
    }
}

struct DirectedMean {
    mean: f64,
    standard_error: f64,
}

/// Mean distance from points of one surface to another surface.
fn directed_mean(from: &Model, to: &Model, samples: usize, seed: u64) -> DirectedMean {
    let to_from_from = RelativePose::new(to, from);
    let projection = EuclideanProjection::new(&to.shape);
    let distances: Vec<f64> = sample_surface(&from.shape, samples.max(2), seed)
        .par_iter()
        .map(|x| projection.distance(&to_from_from.apply(x)))
        .collect();
    let count = distances.len() as f64;
    let mean = distances.iter().sum::<f64>() / count;
    let squares: f64 = distances.iter().map(|distance| (distance - mean).powi(2)).sum();
    DirectedMean { mean, standard_error: (squares / (count * (count - 1.0))).sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::shape::Superellipsoid;
    use nalgebra::Vector3;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn model(size: [f64; 3], exponents: [f64; 2], angles: [f64; 3], p: [f64; 3]) -> Model {
        Model {
            shape: Superellipsoid::new(size, exponents).unwrap(),
            pose: Pose::from_euler_zyz(angles, Vector3::from(p)),
        }
    }

    #[test]
    fn equivalent_descriptions_are_at_no_distance() {
        for unit in [1e-6, 1.0, 1e6] {
            let size = [2.0 * unit, unit, 0.03 * unit];
            let at = [3e3 * unit, -2e3 * unit, 1e3 * unit];
            let a = model(size, [0.2, 1.4], [0.3, 1.1, -0.8], at);
            let swapped = [size[1], size[0], size[2]];
            for b in [
                a,
                model(swapped, [0.2, 1.4], [0.3, 1.1, -0.8 + FRAC_PI_2], at),
                model(size, [0.2, 1.4], [0.3 + PI, PI - 1.1, 0.8], at),
            ] {
                // Tolerance of the projection; coordinates are rounded to 1e-15 of the size.
                assert!(surface_distance(&a, &b, 300, 1).relative_mean < 1e-10);
            }
        }
    }

    #[test]
    fn concentric_spheres_are_as_far_apart_as_their_radii() {
        let at = [1e5, 2e5, -3e5];
        let a = model([2.0; 3], [1.0, 1.0], [0.0; 3], at);
        for radius in [0.3, 1.0, 1.999, 2.5, 9.0] {
            let b = model([radius; 3], [1.0, 1.0], [1.0, 2.0, 3.0], at);
            let distance = surface_distance(&a, &b, 300, 1);
            // Tolerance of the projection.
            assert!((distance.relative_mean - (radius - 2.0_f64).abs() / 2.0).abs() < 1e-9);
            assert!(distance.standard_error < 1e-9);
        }
    }

    #[test]
    fn a_box_in_a_larger_one_is_at_the_closed_form_distance() {
        // Exponent 1e-3 leaves a box up to corners of 3e-4 of its size.
        let exponents = [1e-3, 1e-3];
        let a = model([1.0, 2.0, 3.0], exponents, [0.0; 3], [0.0; 3]);
        let b = model([1.1, 2.1, 3.1], exponents, [0.0; 3], [0.0; 3]);
        // From inside everywhere h = 0.1. From outside h over the faces [2a, 2b] of the inner
        // box, hypot(h, t) over strips along its edges, and |(h, s, t)| over the corners.
        let h = 0.1;
        let strip = 0.5 * h * h * (2.0_f64.sqrt() + 1.0_f64.asinh());
        let corner = h * h * h * corner_mean();
        let (faces, edges) = (8.0 * (2.0 + 3.0 + 6.0), 8.0 * (1.0 + 2.0 + 3.0));
        let outer_area = 8.0 * (1.1 * 2.1 + 1.1 * 3.1 + 2.1 * 3.1);
        let outwards = (faces * h + 2.0 * edges * strip + 24.0 * corner) / outer_area;
        let distance = surface_distance(&a, &b, 20_000, 1);
        let expected = 0.5 * (h + outwards) / 2.0;
        // Five standard errors, and the corners.
        let bound = 5.0 * distance.standard_error + 3e-4;
        assert!((distance.relative_mean - expected).abs() < bound, "{distance:?} {expected}");
        assert!(distance.standard_error < 1e-4);
    }

    /// Mean of `|(1, s, t)|` over the unit square, by the midpoint rule.
    fn corner_mean() -> f64 {
        let at = |i: u32| (f64::from(i) + 0.5) / 100.0;
        let row = |i: u32| (0..100).map(move |j| (1.0 + at(i).powi(2) + at(j).powi(2)).sqrt());
        (0..100).flat_map(row).sum::<f64>() / 1e4
    }

    #[test]
    fn distance_is_symmetric_up_to_its_unit() {
        let a = model([2.0, 1.0, 0.5], [0.4, 1.3], [0.3, 1.1, -0.8], [0.0; 3]);
        let b = model([1.8, 1.1, 0.6], [0.8, 1.0], [0.2, 1.2, -0.8], [0.2, 0.1, 0.0]);
        let [ab, ba] = [(a, b), (b, a)].map(|(a, b)| {
            surface_distance(&a, &b, 500, 4).relative_mean * a.shape.mean_semi_axis()
        });
        // The same points both ways, summed in another order.
        assert!((ab - ba).abs() < 1e-14);
    }
}
