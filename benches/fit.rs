//! The whole fit, all starts included, in the library: complete clouds at 1 % noise.
//!
//! `cargo bench --bench fit`; dated results stand in `benches/runs/`.

#[path = "../tests/common/mod.rs"]
mod common;

use std::num::NonZeroUsize;
use std::time::Duration;

use common::{Scene, point_cloud};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use superquadric::recover::{Distance, FitOptions, fit};

/// Shapes that one measurement fits, since the search takes longer for some than for others.
const SHAPES: u64 = 8;

fn complete_clouds(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group(format!("fit of {SHAPES} complete clouds"));
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    for points in [1_000, 10_000, 100_000, 1_000_000] {
        let clouds: Vec<_> = (0..SHAPES)
            .map(|seed| {
                let mut scene = Scene::new(seed);
                let truth = scene.random_model();
                point_cloud(&scene.cloud(&truth, points, 0.01))
            })
            .collect();
        group.throughput(Throughput::Elements(SHAPES * points as u64));
        for distance in [Distance::Radial, Distance::Geometric] {
            let options =
                FitOptions { distance, threads: NonZeroUsize::new(1), ..FitOptions::default() };
            let id = BenchmarkId::new(distance.name(), points);
            group.bench_with_input(id, &clouds, |bencher, clouds| {
                bencher.iter(|| clouds.iter().map(|c| fit(c, &options)).collect::<Vec<_>>());
            });
        }
    }
    group.finish();
}

criterion_group!(benches, complete_clouds);
criterion_main!(benches);
