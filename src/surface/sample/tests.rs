use super::*;
use std::f64::consts::FRAC_PI_2;

const COUNT: usize = 20_000;

/// Bins along either angle of the octant.
const BINS: usize = 4;

/// Cells along either angle of a bin; their flat area is short of the surface's by less than
/// 1e-3, a seventh of a bin's standard error.
const CELLS: usize = 60;

fn shapes() -> Vec<Superellipsoid> {
    let mut shapes = Vec::new();
    for size in [[1.0, 1.0, 1.0], [3.0, 1.0, 0.5], [1e-6, 2e-6, 1e-4]] {
        for e1 in [0.1, 1.0, 1.9] {
            shapes.extend([0.1, 1.0, 1.9].map(|e2| Superellipsoid::new(size, [e1, e2]).unwrap()));
        }
    }
    shapes
}

/// The surface point of the first octant whose unit-shape direction has these polar angles, in
/// cells: above the equator, and around the axis.
fn octant_point(shape: &Superellipsoid, [above, around]: [usize; 2]) -> Vector3<f64> {
    let angle = |cells: usize| FRAC_PI_2 * cells as f64 / (BINS * CELLS) as f64;
    let [e1, e2] = shape.exponents();
    let (y, x) = angle(around).sin_cos();
    let (z, r) = angle(above).sin_cos();
    let scale = r / superellipse_norm(x, y, e2) / superellipse_norm(r, z, e1);
    let unit = Vector3::new(x * scale, y * scale, z / superellipse_norm(r, z, e1));
    unit.component_mul(&Vector3::from(shape.size()))
}

/// Shares that the bins of the octant have of the sum of `measure` over flat cells.
fn shares(
    shape: &Superellipsoid,
    measure: impl Fn([Vector3<f64>; 3]) -> f64,
) -> [[f64; BINS]; BINS] {
    let mut shares = [[0.0; BINS]; BINS];
    for i in 0..BINS * CELLS {
        for j in 0..BINS * CELLS {
            let [a, b, c, d] =
                [[i, j], [i, j + 1], [i + 1, j + 1], [i + 1, j]].map(|at| octant_point(shape, at));
            shares[i / CELLS][j / CELLS] += measure([a, b, c]) + measure([a, c, d]);
        }
    }
    let sum: f64 = shares.iter().flatten().sum();
    shares.map(|row| row.map(|share| share / sum))
}

/// How many points, folded into the first octant, lie in every bin.
fn counts(shape: &Superellipsoid, points: &[Vector3<f64>]) -> [[usize; BINS]; BINS] {
    let e2 = shape.exponents()[1];
    let mut counts = [[0; BINS]; BINS];
    for point in points {
        let unit = point.component_div(&Vector3::from(shape.size())).abs();
        let above = unit.z.atan2(superellipse_norm(unit.x, unit.y, e2));
        let around = unit.y.atan2(unit.x);
        let [i, j] =
            [above, around].map(|angle| ((angle / FRAC_PI_2 * BINS as f64) as usize).min(BINS - 1));
        counts[i][j] += 1;
    }
    counts
}

/// Asserts that counts of independent points agree with the shares of their bins.
fn assert_distributed(counts: &[[usize; BINS]; BINS], shares: &[[f64; BINS]; BINS]) {
    let total = counts.iter().flatten().sum::<usize>() as f64;
    for (&count, &share) in counts.iter().flatten().zip(shares.iter().flatten()) {
        let standard_error = (total * share * (1.0 - share)).sqrt();
        // Five standard errors; the 1 allows for bins of almost no share.
        let error = count as f64 - total * share;
        assert!(error.abs() < 5.0 * standard_error + 1.0, "{count} of {}", total * share);
    }
}

#[test]
fn surface_points_are_on_the_surface_and_uniform_by_area() {
    for shape in shapes() {
        let points = sample_surface(&shape, COUNT, 7);
        assert_eq!(points.len(), COUNT);
        // A few powers and products, each of relative rounding 1e-16.
        assert!(points.iter().all(|x| (shape.gauge(x) - 1.0).abs() < 1e-14));
        let area = |[a, b, c]: [Vector3<f64>; 3]| (b - a).cross(&(c - a)).norm();
        assert_distributed(&counts(&shape, &points), &shares(&shape, area));
    }
}

#[test]
fn solid_points_are_uniform_by_volume() {
    for shape in shapes() {
        let points = sample_solid(&shape, COUNT, 8);
        let volume = |[a, b, c]: [Vector3<f64>; 3]| a.dot(&b.cross(&c));
        assert_distributed(&counts(&shape, &points), &shares(&shape, volume));
        // The cube of the gauge is uniform in [0, 1]: mean 1/2, variance 1/12.
        let mean = points.iter().map(|x| shape.gauge(x).powi(3)).sum::<f64>() / COUNT as f64;
        assert!((mean - 0.5).abs() < 5.0 * (1.0 / 12.0 / COUNT as f64).sqrt());
    }
}

#[test]
fn octants_are_equally_likely() {
    let shape = Superellipsoid::new([1.0, 2.0, 3.0], [0.5, 1.5]).unwrap();
    for points in [sample_surface(&shape, COUNT, 1), sample_solid(&shape, COUNT, 2)] {
        let mut counts = [0_usize; 8];
        for x in &points {
            counts[(0..3).map(|i| usize::from(x[i] > 0.0) << i).sum::<usize>()] += 1;
        }
        let bound = 5.0 * (COUNT as f64 * 7.0 / 64.0).sqrt();
        assert!(counts.iter().all(|&n| (n as f64 - COUNT as f64 / 8.0).abs() < bound));
    }
}

#[test]
fn slope_bound_holds_and_is_not_six_times_too_large() {
    for e1 in [0.05, 0.5, 1.0, 1.5, 2.0] {
        for e2 in [0.05, 0.5, 1.0, 1.5, 2.0] {
            for size in [[1.0, 1.0, 1.0], [1.0, 1.0, 100.0], [100.0, 100.0, 1.0]] {
                let shape = Superellipsoid::new(size, [e1, e2]).unwrap();
                let cone = ConeMeasure::new(&shape);
                let mut rng = ChaCha8Rng::seed_from_u64(3);
                let slopes: Vec<f64> =
                    (0..2000).map(|_| shape.gauge_gradient(&cone.draw(&mut rng)).norm()).collect();
                let bound = greatest_slope(&shape);
                // Rounding of a few products.
                assert!(slopes.iter().all(|&slope| slope < bound * (1.0 + 1e-13)));
                let kept = slopes.iter().sum::<f64>() / (2000.0 * bound);
                assert!(kept > 1.0 / 6.0, "{shape:?}: {kept}");
            }
        }
    }
}

#[test]
fn seeds_determine_the_points() {
    let shape = Superellipsoid::new([1.0, 2.0, 3.0], [0.5, 1.5]).unwrap();
    assert_eq!(sample_surface(&shape, 10, 5), sample_surface(&shape, 10, 5));
    assert_ne!(sample_surface(&shape, 10, 5), sample_surface(&shape, 10, 6));
    assert_eq!(sample_solid(&shape, 10, 5)[..4], sample_solid(&shape, 4, 5)[..]);
}
