//! What each stage of the fit costs: reading, normalising, surveying, searching, one pass.
//!
//! `cargo bench --features internals --bench stages`; `SUPERQUADRIC_SIMD` chooses the instruction
//! set. Dated results stand in `benches/runs/`.

#[path = "../tests/common/mod.rs"]
mod common;

use std::io::Write;
use std::time::Duration;

use common::{Scene, point_cloud};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use superquadric::cloud::{PointCloud, read};
use superquadric::model::Model;
use superquadric::recover::stages::{Normalized, normalize};
use superquadric::recover::{Distance, PARAMETERS, Precision, Row, geometric_row, radial_row};

const SIZES: [usize; 3] = [1_000, 10_000, 100_000];

/// Points of one pass: more than the first-level cache holds, fewer than the last.
const PASS: usize = 50_000;

fn cloud(points: usize) -> (Model, PointCloud) {
    let mut scene = Scene::new(0);
    let truth = scene.random_model();
    let cloud = point_cloud(&scene.cloud(&truth, points, 0.01));
    (truth, cloud)
}

fn group<'a>(criterion: &'a mut Criterion, name: &str) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(20).measurement_time(Duration::from_secs(2));
    group
}

/// A million points in a binary file, as doubles and as floats.
fn reading(criterion: &mut Criterion) {
    const POINTS: usize = 1_000_000;
    let mut group = group(criterion, "reading");
    let (_, cloud) = cloud(POINTS);
    for (kind, bytes) in [("double", 8), ("float", 4)] {
        let mut file = tempfile::Builder::new().suffix(".ply").tempfile().expect("a file");
        file.write_all(&ply(&cloud, kind)).expect("room for it");
        group.throughput(Throughput::Bytes((3 * bytes * POINTS) as u64));
        group.bench_function(kind, |bencher| bencher.iter(|| read(file.path()).expect("a cloud")));
    }
}

fn ply(cloud: &PointCloud, kind: &str) -> Vec<u8> {
    let properties = ["x", "y", "z"].map(|name| format!("property {kind} {name}\n")).concat();
    let count = cloud.len();
    let header = "ply\nformat binary_little_endian 1.0\n";
    let mut bytes =
        format!("{header}element vertex {count}\n{properties}end_header\n").into_bytes();
    for value in cloud.points().flatten() {
        match kind {
            "float" => bytes.extend((value as f32).to_le_bytes()),
            _ => bytes.extend(value.to_le_bytes()),
        }
    }
    bytes
}

fn normalization(criterion: &mut Criterion) {
    let mut group = group(criterion, "normalization");
    for points in SIZES {
        let (_, cloud) = cloud(points);
        group.throughput(Throughput::Elements(points as u64));
        group.bench_function(points.to_string(), |bencher| bencher.iter(|| normalize(&cloud)));
    }
}

fn survey(criterion: &mut Criterion) {
    let mut group = group(criterion, "survey");
    for points in SIZES {
        let (_, cloud) = cloud(points);
        let cloud = Normalized::of(&cloud);
        group.bench_function(points.to_string(), |bencher| bencher.iter(|| cloud.survey()));
    }
}

fn search(criterion: &mut Criterion) {
    let mut group = group(criterion, "coarse search");
    let (_, cloud) = cloud(SIZES[0]);
    let cloud = Normalized::of(&cloud);
    group.bench_function("256 points", |bencher| bencher.iter(|| cloud.search(256)));
}

fn pass(criterion: &mut Criterion) {
    let mut group = group(criterion, "pass");
    group.throughput(Throughput::Elements(PASS as u64));
    let (model, cloud) = cloud(PASS);
    for (name, row) in [("radial", radial_row as RowOf), ("geometric", geometric_row)] {
        group.bench_function(format!("{name}, scalar rows"), |bencher| {
            bencher.iter(|| scalar_pass(&cloud, &model, row));
        });
    }
    for precision in [Precision::Double, Precision::Single] {
        let normalized = Normalized::of(&cloud).with_precision(precision);
        for distance in [Distance::Radial, Distance::Geometric] {
            let name = format!("{}, {}", distance.name(), precision.name());
            group
                .bench_function(name, |bencher| bencher.iter(|| normalized.pass(&model, distance)));
        }
    }
    let normalized = Normalized::of(&cloud);
    group.bench_function("distances alone", |bencher| {
        bencher.iter(|| normalized.distances(&model));
    });
}

type RowOf = fn([f64; 3], &[f64; 3], &[f64; 2]) -> Row;

/// The same as the fused pass, from the reference rows: `J'J`, `J'r` and `r'r`.
fn scalar_pass(
    cloud: &PointCloud,
    model: &Model,
    row: RowOf,
) -> [[f64; PARAMETERS + 1]; PARAMETERS + 1] {
    let (size, exponents) = (model.shape.size(), model.shape.exponents());
    let mut sums = [[0.0; PARAMETERS + 1]; PARAMETERS + 1];
    for point in cloud.points() {
        let local = model.pose.model_from_world(&point.into());
        let Row { distance, gradient, .. } = row(local.into(), &size, &exponents);
        let mut entries = [distance; PARAMETERS + 1];
        entries[1..].copy_from_slice(&gradient);
        for (i, sums) in sums.iter_mut().enumerate() {
            for j in i..=PARAMETERS {
                sums[j] += entries[i] * entries[j];
            }
        }
    }
    sums
}

criterion_group!(benches, reading, normalization, survey, search, pass);
criterion_main!(benches);
