use super::*;
use crate::deform::Chain;
use crate::shape::{LevelSet, Shape, Solid};
use crate::surface::families::examples;
use crate::surface::{Resolution, sample_shape_surface, tessellate_shape};

const COUNT: usize = 10_000;

/// Bins along the z axis, and around it.
const LEVELS: usize = 6;
const SECTORS: usize = 12;

/// The bin of a point of a box: by its share of the height, and its angle around the axis.
fn bin([least, greatest]: &[Vector3<f64>; 2], x: &Vector3<f64>) -> usize {
    let share = |of: f64, bins: usize| ((of * bins as f64) as usize).min(bins - 1);
    let level = share((x.z - least.z) / (greatest.z - least.z), LEVELS);
    let angle = (x.y / greatest.y).atan2(x.x / greatest.x) / std::f64::consts::TAU + 0.5;
    level * SECTORS + share(angle, SECTORS)
}

/// The shares of the area that bins have on a fine mesh.
fn shares(shape: &Shape) -> Vec<f64> {
    let mesh = tessellate_shape(shape, Resolution::new(64).unwrap());
    let sides = shape.bounding_box();
    let mut shares = vec![0.0; LEVELS * SECTORS];
    let whole = mesh.area();
    for [a, b, c] in mesh.corners() {
        // In quarters, so that fewer are cut by the edge of a bin.
        let [d, e, f] = [0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)];
        let area = 0.5 * (b - a).cross(&(c - a)).norm() / whole;
        for corners in [[a, d, f], [d, b, e], [f, e, c], [d, e, f]] {
            shares[bin(&sides, &(corners.iter().sum::<Vector3<f64>>() / 3.0))] += 0.25 * area;
        }
    }
    shares
}

#[test]
fn points_of_every_family_are_on_the_boundary_and_uniform_by_area() {
    let mut families = std::collections::HashSet::new();
    for (shape, _) in examples().step_by(2) {
        let points = sample_shape_surface(&shape, COUNT, 3);
        assert_eq!(points.len(), COUNT);
        let sides = shape.bounding_box();
        let mut counts = vec![0.0; LEVELS * SECTORS];
        for x in &points {
            assert!((shape.level((*x).into()) - 1.0).abs() < 1e-11, "{shape:?} {x}");
            counts[bin(&sides, x)] += 1.0;
        }
        // Pearson's chi-square, bins of few points put together.
        let expected = shares(&shape).into_iter().map(|share| share * COUNT as f64);
        let (mut sum, mut bins, mut rest) = (0.0, 0.0, [0.0; 2]);
        for (found, expected) in counts.into_iter().zip(expected) {
            if expected < 20.0 {
                rest = [rest[0] + found, rest[1] + expected];
            } else {
                sum += (found - expected).powi(2) / expected;
                bins += 1.0;
            }
        }
        assert!((rest[0] - rest[1]).abs() < 6.0 * rest[1].sqrt() + 6.0, "{shape:?} {rest:?}");
        // Six standard deviations, and what the mesh's bins are off by.
        assert!(sum < bins + 6.0 * (2.0_f64 * bins).sqrt() + 10.0, "{shape:?} {sum} {bins}");
        families.insert(shape.family());
    }
    assert_eq!(families.len(), 5);
}

#[test]
fn patches_sample_superellipsoids_as_their_cones_do() {
    // Mean and deviation of the coordinates' magnitudes, by both ways.
    for (shape, _) in examples().filter(|(shape, _)| shape.family() == "superellipsoid") {
        let surface = Covering { shape: &shape, chain: &Chain::default() };
        let [by_patches, by_cones] =
            [sample(&surface, COUNT, 1), sample_shape_surface(&shape, COUNT, 2)];
        for axis in 0..3 {
            let [a, b] = [&by_patches, &by_cones]
                .map(|points| points.iter().map(|x| x[axis].abs()).sum::<f64>() / COUNT as f64);
            // Magnitudes from 0 to the semi-axis deviate by half of it at most.
            let semi_axis = shape.bounding_box()[1][axis];
            let bound = 5.0 * 0.5 * semi_axis * (2.0 / COUNT as f64).sqrt();
            assert!((a - b).abs() < bound, "{shape:?} {axis} {a} {b}");
        }
    }
}

#[test]
fn bounds_are_rarely_exceeded_and_most_draws_are_kept() {
    for (shape, _) in examples().step_by(2) {
        let surface = Covering { shape: &shape, chain: &Chain::default() };
        let mut patches = patches(&surface);
        let mut exceeded = 0;
        while let Err((patch, element)) = draw(&surface, &patches, COUNT, 5) {
            patches[patch].bound = MARGIN * element;
            exceeded += 1;
        }
        assert!(exceeded < 20, "{shape:?} {exceeded}");
        // The mean of the elements over a patch is its area, twice.
        let bounds: f64 = patches.iter().map(|patch| 0.5 * patch.bound).sum();
        let kept = shape.surface_area() / bounds;
        assert!(kept > 0.4, "{shape:?} {kept}");
    }
}

#[test]
fn seeds_determine_the_points() {
    for (shape, _) in examples().step_by(7) {
        assert_eq!(sample_shape_surface(&shape, 10, 5), sample_shape_surface(&shape, 10, 5));
        assert_ne!(sample_shape_surface(&shape, 10, 5), sample_shape_surface(&shape, 10, 6));
        assert!(sample_shape_surface(&shape, 0, 5).is_empty());
    }
}
