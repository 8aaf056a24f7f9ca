use super::*;

const EXPONENTS: [f64; 7] = [0.05, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0];

const SIZES: [[f64; 3]; 4] =
    [[1.0, 1.0, 1.0], [2.0, 1.0, 0.5], [1e-6, 1e-4, 1e-5], [100.0, 1.0, 50.0]];

const STEPS: usize = 32;

/// Lengths of the steps once around.
fn step_lengths(points: &[Vector2<f64>]) -> impl Iterator<Item = f64> {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| (b - a).norm())
}

/// The longest step over the shortest.
fn unevenness(points: &[Vector2<f64>]) -> f64 {
    let longest = step_lengths(points).fold(0.0, f64::max);
    longest / step_lengths(points).fold(f64::INFINITY, f64::min)
}

fn points(
    parameterization: Parameterization,
    size: [f64; 2],
    e: f64,
    n: usize,
) -> Vec<Vector2<f64>> {
    parameterization.superellipse(&Superellipse::new(size, e).unwrap(), n)
}

#[test]
fn curves_go_once_around_on_the_superellipse_and_meet_the_axes() {
    for e in EXPONENTS {
        for [a, b, _] in SIZES {
            let figure = Superellipse::new([a, b], e).unwrap();
            for parameterization in Parameterization::ALL {
                let points = parameterization.superellipse(&figure, STEPS);
                assert_eq!(points.len(), 4 * STEPS);
                let on_axes = [0, 1, 2, 3].map(|quarter| points[quarter * STEPS]);
                let ends = [[a, 0.0], [0.0, b], [-a, 0.0], [0.0, -b]];
                assert_eq!(on_axes, ends.map(Vector2::from));
                // Next to the tips of exponent 3, gauges magnify rounding.
                assert!(points.iter().all(|x| (figure.gauge(x) - 1.0).abs() < 1e-13), "{e}");
                let angle = |x: &Vector2<f64>| (x.y / b).atan2(x.x / a);
                let turns = points.iter().zip(points.iter().cycle().skip(1));
                let turns =
                    turns.map(|(p, q)| (angle(q) - angle(p)).rem_euclid(std::f64::consts::TAU));
                assert!(turns.clone().all(|turn| turn < std::f64::consts::PI));
                assert!((turns.sum::<f64>() - std::f64::consts::TAU).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn equal_distances_are_equal_whatever_the_semi_axes() {
    for e in EXPONENTS {
        for [a, b, _] in SIZES {
            let points = points(Parameterization::EqualDistance, [a, b], e, 64);
            let mean = step_lengths(&points).sum::<f64>() / points.len() as f64;
            // Chords around a bend or a tip fall short of arcs; none is longer.
            let longest = step_lengths(&points).fold(0.0, f64::max);
            let shortest = step_lengths(&points).fold(f64::INFINITY, f64::min);
            assert!(longest < 1.03 * mean && shortest > 0.65 * mean, "{e} {a} {b}");
            if e == 1.0 && a == b {
                assert!(longest / shortest < 1.0 + 1e-4, "{}", longest / shortest);
            }
        }
    }
}

#[test]
fn explicit_points_are_even_within_the_root_of_two() {
    for e in EXPONENTS.into_iter().filter(|&e| e <= 2.0) {
        // From steps along an axis to steps along the diagonal.
        let unevenness = unevenness(&points(Parameterization::Explicit, [1.0, 1.0], e, 256));
        assert!(unevenness < 2.0_f64.sqrt() + 1e-9, "{e} {unevenness}");
    }
}

#[test]
fn equal_angles_at_the_centre_are_even_within_two() {
    for e in EXPONENTS.into_iter().filter(|&e| e <= 2.0) {
        // A square's: 1 / cos^2 of the angle from its normal.
        let unevenness = unevenness(&points(Parameterization::AngleCentre, [1.0, 1.0], e, 256));
        assert!(unevenness < 2.0 + 1e-9, "{e} {unevenness}");
        if e == 1.0 {
            assert!(unevenness < 1.0 + 1e-12);
        }
    }
}

#[test]
fn trigonometric_points_crowd_without_bound_but_on_the_circle() {
    let of = |e| unevenness(&points(Parameterization::Trigonometric, [1.0, 1.0], e, 16));
    assert!(of(1.0) < 1.0 + 1e-12);
    assert!(
        of(0.5) > 4.0 && of(0.1) > 50.0 && of(2.0) > 10.0,
        "{} {} {}",
        of(0.5),
        of(0.1),
        of(2.0)
    );
}

/// FB81's table, printed as of `cos^.02`, `sin^.02`; its numbers are those of the exponent .04.
#[test]
fn trigonometric_points_of_the_table_of_fb81() {
    let points = points(Parameterization::Trigonometric, [1.0, 1.0], 0.04, 18);
    let table = [
        [1.0000, 0.0000],
        [0.9998, 0.9070],
        [0.9994, 0.9324],
        [0.9986, 0.9474],
        [0.9975, 0.9580],
        [0.9961, 0.9661],
        [0.9943, 0.9727],
        [0.9921, 0.9780],
        [0.9894, 0.9825],
        [0.9862, 0.9862],
    ];
    for (found, printed) in points.iter().zip(table) {
        // Four digits, cut or rounded.
        assert!((found - Vector2::from(printed)).amax() < 1e-4, "{found} {printed:?}");
    }
}

#[test]
fn surfaces_have_their_rows_from_pole_to_pole() {
    for (e1, e2) in EXPONENTS.into_iter().zip(EXPONENTS.into_iter().rev()) {
        for size in SIZES {
            let shape = Superellipsoid::new(size, [e1, e2]).unwrap();
            for parameterization in Parameterization::ALL {
                let rows = parameterization.superellipsoid(&shape, 16);
                assert_eq!((rows.len(), rows[0].len()), (33, 64));
                let [south, north] = [&rows[0], &rows[32]].map(|row| row[5]);
                assert_eq!([south.z, north.z], [-size[2], size[2]]);
                assert!(south.xy().norm() == 0.0 && north.xy().norm() == 0.0);
                assert_eq!(rows[16][0], Vector3::new(size[0], 0.0, 0.0));
                for x in rows.iter().flatten() {
                    assert!((shape.gauge(x) - 1.0).abs() < 1e-13, "{shape:?} {x}");
                }
            }
        }
    }
}

#[test]
fn rays_of_the_angle_centre_parameterisation_are_at_equal_angles() {
    let shape = Superellipsoid::new([2.0, 1.0, 0.5], [0.3, 1.4]).unwrap();
    let rows = Parameterization::AngleCentre.superellipsoid(&shape, 8);
    for (j, row) in rows.iter().enumerate().skip(1).take(15) {
        for (i, x) in row.iter().enumerate() {
            let step = std::f64::consts::PI / 16.0;
            let latitude = x.z.atan2(x.xy().norm());
            assert!((latitude - (j as f64 - 8.0) * step).abs() < 1e-12);
            let longitude = x.y.atan2(x.x).rem_euclid(std::f64::consts::TAU);
            assert!((longitude - i as f64 * step).abs() < 1e-12);
        }
    }
}

/// The longest side of a grid's meshes over the side of a square that is one point's share of the
/// area: how wide a gap it leaves.
fn widest_gap(parameterization: Parameterization, exponents: [f64; 2]) -> f64 {
    let shape = Superellipsoid::new([1.0; 3], exponents).unwrap();
    let rows = parameterization.superellipsoid(&shape, 16);
    let along = rows.iter().flat_map(|row| row.iter().zip(row.iter().cycle().skip(1)));
    let across = rows.windows(2).flat_map(|pair| pair[0].iter().zip(&pair[1]));
    let longest = along.chain(across).map(|(a, b)| (b - a).norm()).fold(0.0, f64::max);
    longest / (shape.surface_area() / (33.0 * 64.0)).sqrt()
}

#[test]
fn even_parameterisations_of_surfaces_leave_no_wide_gaps() {
    for e1 in [0.1, 0.5, 1.0, 1.5, 2.0] {
        for e2 in [0.1, 0.5, 1.0, 1.5, 2.0] {
            for parameterization in [Parameterization::Explicit, Parameterization::EqualDistance] {
                let gap = widest_gap(parameterization, [e1, e2]);
                // On a sphere 1.27: rows of a lattice crowd at the poles.
                assert!(gap < 2.4, "{parameterization:?} {e1} {e2}: {gap}");
            }
            let gap = widest_gap(Parameterization::AngleCentre, [e1, e2]);
            assert!(gap < 4.0, "{e1} {e2}: {gap}");
        }
    }
    let trigonometric = widest_gap(Parameterization::Trigonometric, [0.1, 0.1]);
    assert!(trigonometric > 10.0, "{trigonometric}");
}
