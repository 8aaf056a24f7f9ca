//! Every path against the scalar row.

mod feet;

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::machine::InstructionSet;
use crate::machine::vectorized::run_by;
use crate::math::lane::Lane;
use crate::model::Model;
use crate::pose::Pose;
use crate::recover::geometric::geometric_row;
use crate::recover::normalization::Normalization;
use crate::recover::options::Precision;
use crate::recover::radial::radial_row;
use crate::shape::Superellipsoid;

/// Both forms take the same dozen roundings in another order, those of a logarithm multiplied by
/// `2/e <= 40` among them; and the Gram matrix sums their products.
const TOLERANCE: f64 = 4e-14;

/// The same of rows in single precision: roundings of 6e-8, multiplied by up to 40.
const SINGLE_TOLERANCE: f64 = 1e-5;

/// Exponents above which the geometric distance has a crease at symmetry planes: its derivatives fall
/// as `|x_i|^(2/e - 1)` next to them, which on the plane itself depends on what is told from zero.
const CREASE: f64 = 1.5;

fn columns(points: &[[f64; 3]]) -> [Vec<f64>; 3] {
    std::array::from_fn(|k| points.iter().map(|p| p[k]).collect())
}

/// How many points are summed: fewer than fill a block, a block, and more; few for Miri, which
/// interprets.
const COUNTS: &[usize] = if cfg!(miri) { &[3] } else { &[1, 127, 128, 129, 1000] };

const RESIDUALS: [Residual; 2] = [Residual::Radial, Residual::Geometric];

fn view_of(shape: Superellipsoid, pose: Pose, residual: Residual) -> ModelView {
    ModelView::new(&Normalization::identity(), &Model { shape, pose }, residual)
}

/// The scalar row, as columns are ordered: the residual first.
fn scalar_row(view: &ModelView, point: [f64; 3]) -> [f64; COLUMNS] {
    let x = view.model_from_cloud(point);
    let row = if view.is_geometric { geometric_row } else { radial_row };
    let row = row(x, &view.size, &view.exponents);
    let mut columns = [row.distance; COLUMNS];
    columns[1..].copy_from_slice(&row.gradient);
    columns
}

/// The squared radial and geometric distances.
fn squares(view: &ModelView, point: [f64; 3]) -> [f64; 2] {
    let x = view.model_from_cloud(point);
    [radial_row, geometric_row].map(|row| row(x, &view.size, &view.exponents).distance.powi(2))
}

/// What the entries of a row are sums of: lengths, and for the normal and its moments the terms
/// that cancel far inside a long shape. Those of a geometric row carry the curvature of the
/// surface, `2/e` over the coordinates, times the distance.
fn scales(view: &ModelView, point: [f64; 3]) -> [f64; COLUMNS] {
    let x = view.model_from_cloud(point);
    let radial = radial_row(x, &view.size, &view.exponents);
    let radius = Vector3::from(x).norm().max(1e-100);
    let surface = radius - radial.distance;
    let reach = radius.max(surface);
    let steepest =
        radial.gradient[8..].iter().fold(1.0 + surface / radius, |most, n| most.max(n.abs()));
    let least = x.iter().fold(f64::INFINITY, |least, c| least.min(c.abs().max(1e-100)));
    let [e1, e2] = view.exponents;
    let bend = if view.is_geometric { (2.0 / e1 + 2.0 / e2) * reach } else { 0.0 };
    std::array::from_fn(|column| match column {
        0 => reach,
        1..=5 => surface + 700.0 * bend,
        6..=8 => (steepest + bend / least) * radius,
        _ => steepest + bend / least,
    })
}

/// Coordinates on axes and planes, ties, tiny and huge ones, and those of plain points.
fn adversarial_points(rng: &mut ChaCha8Rng) -> Vec<[f64; 3]> {
    const SPECIAL: [f64; 8] = [0.0, 1e-12, -0.5, 0.5, 1.0, -1.0, 3.0, 1e3];
    let mut points = Vec::new();
    for x in SPECIAL {
        for y in SPECIAL {
            points.extend(SPECIAL.map(|z| [x, y, z]));
        }
    }
    points.extend(random_points(rng, 389));
    points
}

fn random_points(rng: &mut ChaCha8Rng, count: usize) -> Vec<[f64; 3]> {
    (0..count).map(|_| std::array::from_fn(|_| rng.random_range(-2.0..2.0))).collect()
}

fn assert_rows_agree<L: Lane, const FMA: bool>(
    view: &ModelView,
    points: &[[f64; 3]],
    tolerance: f64,
) {
    if view.is_geometric {
        assert_rows_of_residual_agree::<L, FMA, true>(view, points, tolerance);
    } else {
        assert_rows_of_residual_agree::<L, FMA, false>(view, points, tolerance);
    }
}

fn assert_rows_of_residual_agree<L: Lane, const FMA: bool, const GEOMETRIC: bool>(
    view: &ModelView,
    points: &[[f64; 3]],
    tolerance: f64,
) {
    let mut scratch = block::Scratch::<L>::new();
    let mut rows = gram::Rows::new();
    for block in points.chunks(gram::BLOCK) {
        let [x, y, z] = columns(block);
        block::write_rows::<L, FMA, GEOMETRIC>(view, [&x, &y, &z], &mut scratch, &mut rows);
        for (i, point) in block.iter().enumerate() {
            let expected = scalar_row(view, *point);
            let scales = scales(view, *point);
            for k in 0..COLUMNS {
                let error = (rows.columns[k][i] - expected[k]).abs();
                assert!(
                    error <= tolerance * scales[k],
                    "column {k} at {point:?} of {view:?}: {} is not {}",
                    rows.columns[k][i],
                    expected[k]
                );
            }
        }
        assert!(rows.columns.iter().all(|column| column[block.len()..].iter().all(|v| *v == 0.0)));
        for squares in [&rows.radial_squares, &rows.geometric_squares] {
            assert!(squares[block.len()..].iter().all(|v| *v == 0.0));
        }
    }
}

#[test]
fn block_rows_agree_with_the_scalar_row_at_adversarial_points() {
    let points = adversarial_points(&mut ChaCha8Rng::seed_from_u64(1));
    for e1 in [0.05, 0.3, 1.0, 1.9, 2.0] {
        for e2 in [0.05, 0.3, 1.0, 1.9, 2.0] {
            for size in [[1.0, 1.0, 1.0], [0.5, 1.0, 3.0], [0.02, 2.0, 1.0]] {
                let shape = Superellipsoid::new(size, [e1, e2]).unwrap();
                for residual in RESIDUALS {
                    let view = view_of(shape, Pose::identity(), residual);
                    assert_rows_agree::<f64, false>(&view, &points, TOLERANCE);
                    assert_rows_agree::<f64, true>(&view, &points, TOLERANCE);
                    // A float does not tell 1e-12 of the unit from the centre.
                    let points: Vec<_> = points
                        .iter()
                        .filter(|x| !x.contains(&1e-12))
                        .filter(|x| !(view.is_geometric && e1.max(e2) > CREASE && x.contains(&0.0)))
                        .copied()
                        .collect();
                    assert_rows_agree::<f32, false>(&view, &points, SINGLE_TOLERANCE);
                    assert_rows_agree::<f32, true>(&view, &points, SINGLE_TOLERANCE);
                }
            }
        }
    }
}

/// Sizes of the scale of the domain's ends, points on axes and planes and far outside.
#[test]
fn single_rows_are_finite_wherever_points_are() {
    let points = adversarial_points(&mut ChaCha8Rng::seed_from_u64(4));
    let [x, y, z] = columns(&points);
    for exponents in [[0.05, 0.05], [0.05, 2.0], [2.0, 0.05], [2.0, 2.0], [1.0, 0.3]] {
        for size in [[1e-3, 0.1, 0.1], [1e3, 10.0, 1e3], [0.01, 1.0, 0.01]] {
            for residual in RESIDUALS {
                let shape = Superellipsoid::new(size, exponents).unwrap();
                let view = view_of(shape, Pose::identity(), residual);
                let view = view.with_precision(Precision::Single);
                let gram = gram(&view, [&x, &y, &z], None, false);
                assert!(gram.matrix.iter().flatten().all(|entry| entry.is_finite()), "{view:?}");
                assert!(gram.geometric_squares.is_finite() && gram.radial_squares.is_finite());
            }
        }
    }
}

#[test]
fn points_far_from_the_origin_lose_nothing_in_single_precision() {
    let points = random_points(&mut ChaCha8Rng::seed_from_u64(5), 500);
    let shape = Superellipsoid::new([0.5, 1.0, 1.5], [0.4, 1.3]).unwrap();
    let model = Model { shape, pose: Pose::identity() };
    let centroid = [1e6, -2e6, 3e6];
    let far: Vec<[f64; 3]> =
        points.iter().map(|x| std::array::from_fn(|k| centroid[k] + x[k])).collect();
    let normalization = Normalization { centroid, ..Normalization::identity() };
    let single = |normalization: &Normalization, points: &[[f64; 3]]| {
        let view = ModelView::new(normalization, &model, Residual::Geometric)
            .with_precision(Precision::Single);
        let [x, y, z] = columns(points);
        gram(&view, [&x, &y, &z], None, false)
    };
    let (near, far) = (single(&Normalization::identity(), &points), single(&normalization, &far));
    let share = far.geometric_squares / near.geometric_squares - 1.0;
    assert!(share.abs() < 1e-7, "{share}");
}

#[test]
fn every_path_sums_the_scalar_rows() {
    let points = random_points(&mut ChaCha8Rng::seed_from_u64(3), 1000);
    let shape = Superellipsoid::new([0.5, 1.0, 1.5], [0.4, 1.3]).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 0.8, -1.0], Vector3::new(0.1, 0.0, -0.2));
    for residual in RESIDUALS {
        let view = view_of(shape, pose, residual);
        for count in COUNTS {
            assert_sums_agree(&view, &points[..*count], TOLERANCE);
            let single = view.clone().with_precision(Precision::Single);
            assert_sums_agree(&single, &points[..*count], SINGLE_TOLERANCE);
        }
    }
}

#[test]
fn every_path_has_the_normals_of_the_gauge() {
    let shape = Superellipsoid::new([0.5, 1.0, 1.5], [0.4, 1.3]).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 0.8, -1.0], Vector3::new(0.1, 0.0, -0.2));
    let view = view_of(shape, pose, Residual::Geometric);
    for count in COUNTS {
        let points = &random_points(&mut ChaCha8Rng::seed_from_u64(6), *count);
        let [x, y, z] = columns(points);
        for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
            let normals = run_by(set, NormalsOf { view: &view, points: [&x, &y, &z] });
            assert_eq!(normals.len(), points.len());
            for (point, normal) in points.iter().zip(normals) {
                let x_model = pose.model_from_world(&Vector3::from(*point));
                let expected = shape.gauge_gradient(&x_model).normalize();
                let error = (Vector3::from(normal) - expected).norm();
                assert!(error < 1e-13, "{set:?} at {point:?}: {error}");
            }
        }
    }
}

fn each_distance(set: InstructionSet, view: &ModelView, points: [&[f64]; 3]) -> Vec<f64> {
    let mut distances = vec![0.0; points[0].len()];
    run_by(set, DistancesOf { view, points, distances: &mut distances });
    distances
}

fn assert_sums_agree(view: &ModelView, points: &[[f64; 3]], tolerance: f64) {
    let [x, y, z] = columns(points);
    let rows: Vec<_> = points.iter().map(|point| scalar_row(view, *point)).collect();
    let scales: Vec<_> = points.iter().map(|point| scales(view, *point)).collect();
    let squares: Vec<_> = points.iter().map(|point| squares(view, *point)).collect();
    let [radial, geometric] = [0, 1].map(|k| squares.iter().map(|s| s[k]).sum::<f64>());
    for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
        let actual = run_by(set, GramOf { view, points: [&x, &y, &z], factors: None });
        let each = each_distance(set, view, [&x, &y, &z]);
        for (i, distance) in each.iter().enumerate() {
            let [_, square] = squares[i];
            assert!((distance * distance - square).abs() <= TOLERANCE * geometric);
            // The radial and the geometric distance have one sign.
            assert!(distance * rows[i][0] >= 0.0);
        }
        assert!((actual.radial_squares - radial).abs() <= tolerance * radial);
        assert!((actual.geometric_squares - geometric).abs() <= tolerance * geometric);
        for i in 0..COLUMNS {
            for j in i..COLUMNS {
                let expected: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
                let scale: f64 = scales.iter().map(|scale| scale[i] * scale[j]).sum();
                let error = (actual.matrix[i][j] - expected).abs();
                assert!(error <= tolerance * scale, "[{i}][{j}] of {view:?}: {error}");
            }
        }
    }
}

#[test]
fn threads_do_not_change_a_byte() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let [x, y, z] = columns(&random_points(&mut rng, 5 * CHUNK + 17));
    let shape = Superellipsoid::new([1.0, 0.8, 1.5], [0.4, 1.2]).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 0.8, -1.0], Vector3::new(0.1, 0.0, -0.2));
    let view = view_of(shape, pose, Residual::Radial);
    let one = gram(&view, [&x, &y, &z], None, false);
    let many = gram(&view, [&x, &y, &z], None, true);
    assert_eq!(one, many);
}
