//! The whole fit, all starts included, in the library, one thread: complete clouds at 1 % noise, and
//! what makes it harder.
//!
//! `cargo bench --bench fit`; dated results stand in `benches/runs/`.

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::num::NonZeroUsize;
use std::time::{Duration, Instant};

use common::{Scene, one_sided_view_from, point_cloud, with_strays};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use superquadric::cloud::PointCloud;
use superquadric::recover::{Distance, FitOptions, Precision, Sight, fit};

/// Complete clouds that one measurement fits, one of each shape, since the search takes longer for some
/// than for others; and hard ones.
const COMPLETE: u64 = 16;
const HARD_SHAPES: u64 = 8;

/// What is told of the times of all shapes.
#[derive(Debug, Clone, Copy)]
enum Statistic {
    Median,
    Mean,
}

impl Statistic {
    fn of(self, mut times: Vec<Duration>) -> Duration {
        times.sort_unstable();
        match self {
            Self::Median => times[times.len() / 2],
            Self::Mean => times.iter().sum::<Duration>() / times.len() as u32,
        }
    }
}

fn complete_clouds(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("fit of a complete cloud");
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    for points in [1_000, 10_000, 100_000, 1_000_000] {
        let clouds: Vec<_> = (0..COMPLETE)
            .map(|seed| {
                let mut scene = Scene::new(seed);
                let truth = scene.random_model();
                point_cloud(&scene.cloud(&truth, points, 0.01))
            })
            .collect();
        group.throughput(Throughput::Elements(points as u64));
        for (distance, precision, statistic) in statistics() {
            let threads = NonZeroUsize::new(1);
            let options = FitOptions { distance, precision, threads, ..FitOptions::default() };
            let name = format!("{}, {}, {statistic:?}", distance.name(), precision.name());
            group.bench_function(BenchmarkId::new(name, points), |bencher| {
                bencher.iter_custom(|times| {
                    let one = |cloud| time_of_fits(cloud, &options, times);
                    statistic.of(clouds.iter().map(one).collect())
                });
            });
        }
    }
    group.finish();
}

/// What is measured of each size.
fn statistics() -> impl Iterator<Item = (Distance, Precision, Statistic)> {
    [Distance::Radial, Distance::Geometric].into_iter().flat_map(|distance| {
        [Precision::Double, Precision::Single].into_iter().flat_map(move |precision| {
            [Statistic::Median, Statistic::Mean].map(|statistic| (distance, precision, statistic))
        })
    })
}

/// What it takes to fit a cloud so many times.
fn time_of_fits(cloud: &PointCloud, options: &FitOptions, times: u64) -> Duration {
    let start = Instant::now();
    for _ in 0..times {
        black_box(fit(cloud, options).expect("a cloud with an extent"));
    }
    start.elapsed()
}

/// A cloud that is harder than a complete one, of about so many points.
struct Hard {
    name: &'static str,
    points: usize,
    noise: f64,
    is_one_sided: bool,
    strays: f64,
    tells_viewpoint: bool,
}

const PLAIN: Hard = Hard {
    name: "complete, 5 % of noise",
    points: 1_000,
    noise: 0.05,
    is_one_sided: false,
    strays: 0.0,
    tells_viewpoint: false,
};

const HARD: [Hard; 10] = [
    PLAIN,
    Hard { name: "one side", noise: 0.01, is_one_sided: true, ..PLAIN },
    Hard { name: "one side, 5 % of noise", is_one_sided: true, ..PLAIN },
    Hard {
        name: "one side, viewpoint told",
        noise: 0.01,
        is_one_sided: true,
        tells_viewpoint: true,
        ..PLAIN
    },
    Hard {
        name: "one side, 5 % of noise, viewpoint told",
        is_one_sided: true,
        tells_viewpoint: true,
        ..PLAIN
    },
    Hard { name: "20 % of strays", noise: 0.01, points: 2_000, strays: 0.2, ..PLAIN },
    Hard { name: "60 % of strays", noise: 0.01, points: 2_000, strays: 0.6, ..PLAIN },
    Hard { name: "80 % of strays", noise: 0.01, points: 3_000, strays: 0.8, ..PLAIN },
    Hard {
        name: "one side, 20 % of strays",
        noise: 0.01,
        points: 2_000,
        is_one_sided: true,
        strays: 0.2,
        ..PLAIN
    },
    Hard {
        name: "one side, 20 % of strays, viewpoint told",
        noise: 0.01,
        points: 2_000,
        is_one_sided: true,
        strays: 0.2,
        tells_viewpoint: true,
    },
];

impl Hard {
    fn cloud(&self, seed: u64) -> (PointCloud, Option<Sight>) {
        let mut scene = Scene::new(seed);
        let truth = scene.random_model();
        let surface = ((1.0 - self.strays) * self.points as f64) as usize;
        let (points, camera) = if self.is_one_sided {
            one_sided_view_from(&mut scene, &truth, surface, self.noise)
        } else {
            (scene.cloud(&truth, surface, self.noise), [0.0; 3])
        };
        let points = with_strays(&mut scene, &truth, points, self.strays);
        (point_cloud(&points), self.tells_viewpoint.then(|| Sight::from_viewpoint(camera)))
    }
}

fn hard_clouds(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group(format!("fit of {HARD_SHAPES} hard clouds"));
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for hard in HARD {
        let clouds: Vec<_> = (0..HARD_SHAPES).map(|seed| hard.cloud(seed)).collect();
        for distance in [Distance::Radial, Distance::Geometric] {
            let fit_all = || -> Vec<_> {
                let one = |(cloud, sight): &(PointCloud, Option<Sight>)| {
                    let threads = NonZeroUsize::new(1);
                    let sight = sight.clone();
                    fit(cloud, &FitOptions { distance, threads, sight, ..FitOptions::default() })
                };
                clouds.iter().map(one).collect()
            };
            group.bench_function(BenchmarkId::new(distance.name(), hard.name), |bencher| {
                bencher.iter(fit_all);
            });
        }
    }
    group.finish();
}

criterion_group!(benches, complete_clouds, hard_clouds);
criterion_main!(benches);
