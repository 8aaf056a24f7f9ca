//! Every path against the scalar row.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::model::Model;
use crate::pose::Pose;
use crate::recover::normalization::Normalization;
use crate::recover::radial::radial_row;
use crate::shape::Superellipsoid;

/// Both forms take the same dozen roundings in another order, those of a logarithm multiplied by
/// `2/e <= 40` among them; and the Gram matrix sums their products.
const TOLERANCE: f64 = 4e-14;

fn columns(points: &[[f64; 3]]) -> [Vec<f64>; 3] {
    std::array::from_fn(|k| points.iter().map(|p| p[k]).collect())
}

fn view_of(shape: Superellipsoid, pose: Pose) -> ModelView {
    ModelView::new(&Normalization::identity(), &Model { shape, pose })
}

/// The scalar row, as columns are ordered: the residual first.
fn scalar_row(view: &ModelView, point: [f64; 3]) -> [f64; COLUMNS] {
    let row = radial_row(view.model_from_cloud(point), &view.size, &view.exponents);
    let mut columns = [row.distance; COLUMNS];
    columns[1..].copy_from_slice(&row.gradient);
    columns
}

/// The squared distance over the squared gradient, of a scalar row.
fn geometric_square(row: &[f64; COLUMNS]) -> f64 {
    row[0] * row[0] / row[9..].iter().map(|n| n * n).sum::<f64>()
}

/// What the entries of a row are sums of: lengths, and for the normal and its moments the terms
/// that cancel far inside a long shape.
fn scales(row: &[f64; COLUMNS], point: [f64; 3]) -> [f64; COLUMNS] {
    let radius = Vector3::from(point).norm().max(1e-100);
    let surface = radius - row[0];
    let steepest = row[9..].iter().fold(1.0 + surface / radius, |most, n| most.max(n.abs()));
    std::array::from_fn(|column| match column {
        0 => radius.max(surface),
        1..=5 => surface,
        6..=8 => steepest * radius,
        _ => steepest,
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

fn assert_rows_agree<const FMA: bool>(view: &ModelView, points: &[[f64; 3]]) {
    let mut scratch = block::Scratch::new();
    let mut rows = gram::Rows::new();
    for block in points.chunks(gram::BLOCK) {
        let [x, y, z] = columns(block);
        block::write_rows::<FMA>(view, [&x, &y, &z], &mut scratch, &mut rows);
        for (i, point) in block.iter().enumerate() {
            let expected = scalar_row(view, *point);
            let scales = scales(&expected, *point);
            for k in 0..COLUMNS {
                let error = (rows.columns[k][i] - expected[k]).abs();
                assert!(
                    error <= TOLERANCE * scales[k],
                    "column {k} at {point:?} of {view:?}: {} is not {}",
                    rows.columns[k][i],
                    expected[k]
                );
            }
        }
        assert!(rows.columns.iter().all(|column| column[block.len()..].iter().all(|v| *v == 0.0)));
        assert!(rows.geometric_squares[block.len()..].iter().all(|v| *v == 0.0));
    }
}

#[test]
fn block_rows_agree_with_the_scalar_row_at_adversarial_points() {
    let points = adversarial_points(&mut ChaCha8Rng::seed_from_u64(1));
    for e1 in [0.05, 0.3, 1.0, 1.9, 2.0] {
        for e2 in [0.05, 0.3, 1.0, 1.9, 2.0] {
            for size in [[1.0, 1.0, 1.0], [0.5, 1.0, 3.0], [0.02, 2.0, 1.0]] {
                let shape = Superellipsoid::new(size, [e1, e2]).unwrap();
                let view = view_of(shape, Pose::identity());
                assert_rows_agree::<false>(&view, &points);
                assert_rows_agree::<true>(&view, &points);
            }
        }
    }
}

#[test]
fn every_path_sums_the_scalar_rows() {
    let points = random_points(&mut ChaCha8Rng::seed_from_u64(3), 1000);
    let [x, y, z] = columns(&points);
    let shape = Superellipsoid::new([0.5, 1.0, 1.5], [0.4, 1.3]).unwrap();
    let pose = Pose::from_euler_zyz([0.3, 0.8, -1.0], Vector3::new(0.1, 0.0, -0.2));
    let view = view_of(shape, pose);
    for count in [1, 127, 128, 129, points.len()] {
        let rows: Vec<_> = points[..count].iter().map(|p| scalar_row(&view, *p)).collect();
        let scales: Vec<_> = rows.iter().zip(&points).map(|(row, p)| scales(row, *p)).collect();
        let slices = [&x[..count], &y[..count], &z[..count]];
        for actual in [dispatch::gram(&view, slices), dispatch::gram_portable(&view, slices)] {
            let geometric: f64 = rows.iter().map(geometric_square).sum();
            assert!((actual.geometric_squares - geometric).abs() <= TOLERANCE * geometric);
            for i in 0..COLUMNS {
                for j in i..COLUMNS {
                    let expected: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
                    let scale: f64 = scales.iter().map(|s| s[i] * s[j]).sum();
                    let error = (actual.matrix[i][j] - expected).abs();
                    assert!(error <= TOLERANCE * scale, "[{i}][{j}] of {count}: {error}");
                }
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
    let view = view_of(shape, pose);
    let one = gram(&view, [&x, &y, &z], false);
    let many = gram(&view, [&x, &y, &z], true);
    assert_eq!(one, many);
}
