//! FB81's table anew: six ways of calculating the points of a superquadric, one by one and in
//! vector code, each with its true error; and what the library's own writing into z-buffers and
//! vertex arrays reaches of this machine's memory-write bandwidth.
//!
//! `cargo bench --bench faster_calculation` measures and prints the tables; dated results stand
//! in `benches/runs/`.

use std::cell::Cell;
use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::{Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use superquadric::raster::method::{
    Explicit, LogTable, Method, PowerTables, RawParametric, Series, SphericalProduct,
};
use superquadric::raster::{Placement, VertexArray, ZBuffer};
use superquadric::raster::{write_heights, write_product, write_reflections};
use superquadric::shape::{Superellipse, Superellipsoid};
use superquadric::surface::Parameterization;

/// FB81's mildly rounded example, n = 5.
const EXPONENT: f64 = 0.4;

/// Points a row, and rows: 10,000 points, as in the paper.
const STEPS: usize = 1000;
const ROWS: usize = 10;

/// "times as fast as method 1" in the paper.
const PAPER: [f64; 6] = [1.00, 1.93, 2.69, 5.09, 54.10, 219.00];

/// Bytes of the array that the bandwidth of writing is measured on: far more than caches hold.
const LARGE: usize = 1 << 28;

/// What one method takes a point, in nanoseconds, and how far off its points are.
struct Line {
    name: &'static str,
    scalar: f64,
    vector: f64,
    error: f64,
}

fn methods(criterion: &mut Criterion) {
    let e = [EXPONENT; 2];
    let lines = [
        line(criterion, "1 raw parametric", &RawParametric::new(e, STEPS)),
        line(criterion, "2 exact explicit", &Explicit::new(e, STEPS)),
        line(criterion, "3 three-term series", &Series::new(e, STEPS)),
        line(criterion, "4 series, log table", &LogTable::new(e, STEPS)),
        line(criterion, "5 spherical product", &SphericalProduct::new(e, STEPS)),
        line(criterion, "6 power tables", &PowerTables::new(EXPONENT, STEPS)),
    ];
    println!(
        "\n| method | paper | one by one, ns | times as fast | rows, ns | times as fast | true error |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: | ---: |");
    for (line, paper) in lines.iter().zip(PAPER) {
        let Line { name, scalar, vector, error } = line;
        let [by_scalar, by_vector] = [lines[0].scalar / scalar, lines[0].scalar / vector];
        println!(
            "| {name} | {paper} | {scalar:.2} | {by_scalar:.2} | {vector:.2} | {by_vector:.1} | {error:.1e} |"
        );
    }
    println!();
}

fn line(criterion: &mut Criterion, name: &'static str, method: &impl Method) -> Line {
    let points = ROWS * STEPS;
    let mut columns = [(); 3].map(|()| vec![0.0; STEPS]);
    let scalar = seconds(criterion, &format!("{name}, one by one"), points, || {
        for j in 0..ROWS {
            for i in 0..STEPS {
                // Nothing that depends on j alone is kept from point to point.
                let point = method.point(i, black_box(j * STEPS / ROWS));
                for (column, coordinate) in columns.iter_mut().zip(point) {
                    column[i] = coordinate;
                }
            }
            black_box(&mut columns);
        }
    });
    let vector = seconds(criterion, &format!("{name}, rows"), points, || {
        for j in 0..ROWS {
            method.row(j * STEPS / ROWS, columns.each_mut().map(|column| &mut column[..]));
            black_box(&mut columns);
        }
    });
    let [scalar, vector] = [scalar, vector].map(|seconds| seconds / points as f64 * 1e9);
    Line { name, scalar, vector, error: true_error(method, EXPONENT) }
}

/// The true errors of the methods that have any, over equal exponents.
fn errors(_: &mut Criterion) {
    println!("\n| e | series (3 and 4) | power tables (6) |\n| ---: | ---: | ---: |");
    for e in [0.1, 0.4, 0.7, 1.0, 1.3, 1.6, 1.9, 2.0] {
        let series = true_error(&Series::new([e, e], STEPS), e);
        let tables = true_error(&PowerTables::new(e, STEPS), e);
        println!("| {e} | {series:.1e} | {tables:.1e} |");
    }
    println!();
}

/// The greatest distance from the surface of equal exponents, in semi-axes.
fn true_error(method: &impl Method, exponent: f64) -> f64 {
    let shape = Superellipsoid::new([1.0; 3], [exponent; 2]).expect("a valid shape");
    let places = (0..STEPS).flat_map(|j| (0..STEPS).map(move |i| (i, j)));
    let points = places.map(|(i, j)| method.point(i, j).into());
    points.map(|x| shape.radial_distance(&x).abs()).fold(0.0, f64::max)
}

fn writing(criterion: &mut Criterion) {
    let before = bandwidth(criterion, "memory filled, before");
    let mut written = Vec::new();
    for exponents in [[EXPONENT; 2], [0.4, 1.2]] {
        for side in [1024, 8192] {
            let name = format!("z-buffer {side} x {side}, e = {exponents:?}");
            let (bytes, seconds) = z_buffer(criterion, &name, side, exponents);
            written.push((name, bytes, seconds));
        }
    }
    let (bytes, seconds) = product(criterion);
    written.push(("vertices, spherical product".to_owned(), bytes, seconds));
    let (bytes, seconds) = reflections(criterion);
    written.push(("vertices, 48-fold symmetry".to_owned(), bytes, seconds));
    // What others do to a shared machine's memory in the meantime counts against us.
    let bandwidth = before.max(bandwidth(criterion, "memory filled, after"));
    println!("\nmemory is written at {:.2} GB/s", bandwidth / 1e9);
    println!("\n| written | MB | GB/s | share of the bandwidth |\n| --- | ---: | ---: | ---: |");
    for (name, bytes, seconds) in written {
        let [rate, megabytes] = [bytes as f64 / seconds / 1e9, bytes as f64 / 1e6];
        let share = 1e11 * rate / bandwidth;
        println!("| {name} | {megabytes:.0} | {rate:.2} | {share:.0} % |");
    }
    println!();
}

/// Bytes a second at which a large array is filled.
fn bandwidth(criterion: &mut Criterion, name: &str) -> f64 {
    // Not zeros, whose memory would only be found when it is first written.
    let mut array = vec![0.5_f32; LARGE / 4];
    let seconds = seconds(criterion, name, LARGE / 4, || {
        black_box(&mut array).fill(black_box(1.0));
    });
    LARGE as f64 / seconds
}

/// Bytes of the pixels that a solid takes of a z-buffer that its box fills, and the seconds.
fn z_buffer(
    criterion: &mut Criterion,
    name: &str,
    side: usize,
    exponents: [f64; 2],
) -> (usize, f64) {
    let shape = Superellipsoid::new([1.0; 3], exponents).expect("a valid shape");
    let mut buffer = ZBuffer::new(side, side).expect("a valid size");
    let centre = [0.5 * (side as f64 - 1.0); 2];
    let placement = Placement { centre, depth: 2.0, pixel: 2.0 / side as f64 };
    write_heights(&mut buffer, &shape, &placement);
    let filled = buffer.depths().iter().filter(|depth| depth.is_finite()).count();
    let seconds =
        seconds(criterion, name, filled, || write_heights(&mut buffer, &shape, &placement));
    (4 * filled, seconds)
}

fn product(criterion: &mut Criterion) -> (usize, f64) {
    let figure = Superellipse::new([1.0, 1.0], EXPONENT).expect("a valid figure");
    let curve = |n| -> Vec<[f64; 2]> {
        let points = Parameterization::Explicit.superellipse(&figure, n);
        points.into_iter().map(Into::into).collect()
    };
    let (meridian, equator) = (curve(1024), curve(1024));
    let mut vertices = VertexArray::default();
    write_product(&mut vertices, &meridian, &equator);
    let count = vertices.len();
    let seconds = seconds(criterion, "vertices, spherical product", count, || {
        write_product(&mut vertices, &meridian, &equator);
    });
    (12 * count, seconds)
}

fn reflections(criterion: &mut Criterion) -> (usize, f64) {
    let mut vertices = VertexArray::default();
    let mut write = || {
        write_reflections(&mut vertices, [1.0; 3], EXPONENT, 1e-3);
        vertices.len()
    };
    let count = write();
    let seconds = seconds(criterion, "vertices, 48-fold symmetry", count, || {
        write();
    });
    (12 * count, seconds)
}

/// The mean seconds that a run takes on the processor, over all that criterion measures.
fn seconds(criterion: &mut Criterion, name: &str, elements: usize, mut run: impl FnMut()) -> f64 {
    let (runs, total) = (Cell::new(0), Cell::new(Duration::ZERO));
    let mut group = criterion.benchmark_group("faster calculation");
    group.sample_size(10).warm_up_time(Duration::from_millis(300));
    group.throughput(Throughput::Elements(elements as u64));
    group.sampling_mode(SamplingMode::Flat).measurement_time(Duration::from_secs(3));
    group.bench_function(name, |bencher| {
        bencher.iter_custom(|iterations| {
            let (start, start_on_processor) = (Instant::now(), time_on_processor());
            (0..iterations).for_each(|_| run());
            let elapsed = start.elapsed();
            let on_processor = start_on_processor.zip(time_on_processor());
            runs.set(runs.get() + iterations);
            total.set(total.get() + on_processor.map_or(elapsed, |(start, end)| end - start));
            elapsed
        });
    });
    group.finish();
    total.get().as_secs_f64() / runs.get() as f64
}

/// How long this thread has run, without what others took of a shared machine; Linux tells.
fn time_on_processor() -> Option<Duration> {
    let schedule = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    schedule.split(' ').next()?.parse().ok().map(Duration::from_nanos)
}

criterion_group!(benches, methods, errors, writing);
criterion_main!(benches);
