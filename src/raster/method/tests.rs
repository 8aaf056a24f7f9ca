use super::*;
use crate::shape::Superellipsoid;

const STEPS: usize = 64;

const EXPONENTS: [f64; 7] = [0.1, 0.3, 0.5, 1.0, 1.4, 1.9, 2.0];

/// The greatest distance of a method's points from the surface, along rays from the centre.
fn true_error(method: &impl Method, exponents: [f64; 2]) -> f64 {
    let shape = Superellipsoid::new([1.0; 3], exponents).unwrap();
    let steps = method.steps();
    assert!(steps > 0);
    (0..steps * steps)
        .map(|point| method.point(point % steps, point / steps))
        .map(|x| shape.radial_distance(&x.into()).abs())
        .fold(0.0, f64::max)
}

/// The greatest difference between the points of rows and those calculated one by one.
fn row_error(method: &impl Method) -> f64 {
    let steps = method.steps();
    let mut columns = [const { Vec::new() }; 3].map(|_: Vec<f64>| vec![0.0; steps]);
    let mut greatest = 0.0_f64;
    for j in 0..steps {
        method.row(j, columns.each_mut().map(|column| &mut column[..]));
        for i in 0..steps {
            let point = method.point(i, j);
            for (column, coordinate) in columns.iter().zip(point) {
                greatest = greatest.max((column[i] - coordinate).abs());
            }
        }
    }
    greatest
}

/// Both errors, for all pairs of exponents.
fn assert_within<M: Method>(make: impl Fn([f64; 2]) -> M, bound: impl Fn([f64; 2]) -> f64) {
    for e1 in EXPONENTS {
        for e2 in EXPONENTS {
            let method = make([e1, e2]);
            let error = true_error(&method, [e1, e2]);
            assert!(error <= bound([e1, e2]), "{e1} {e2}: {error}");
            // Exponents of powers, up to 690, are rounded.
            assert!(row_error(&method) < 1e-13, "{e1} {e2}");
        }
    }
}

/// A few powers, each of relative rounding 1e-16.
const ROUNDING: f64 = 1e-14;

#[test]
fn exact_methods_are_on_the_surface() {
    assert_within(|e| RawParametric::new(e, STEPS), |_| ROUNDING);
    assert_within(|e| Explicit::new(e, STEPS), |_| ROUNDING);
    assert_within(|e| SphericalProduct::new(e, STEPS), |_| ROUNDING);
}

/// What three terms of the binomial series of `(1 - s)^p` leave at `s <= 2/3`: the rest has
/// terms of one sign, each less than the one before by s at least.
fn series_remainder([e1, _]: [f64; 2]) -> f64 {
    let (p, s) = (0.5 * e1, 2.0_f64 / 3.0);
    let fourth = p * (1.0 - p) * (2.0 - p) * (3.0 - p) / 24.0 * s.powi(4);
    fourth / (1.0 - s)
}

#[test]
fn the_series_leaves_its_remainder() {
    assert_within(|e| Series::new(e, STEPS), |e| series_remainder(e) + ROUNDING);
    assert_within(|e| LogTable::new(e, STEPS), |e| series_remainder(e) + ROUNDING);
}

#[test]
fn three_terms_are_good_to_a_pixel_in_fifty_at_worst_and_exact_for_exponent_two() {
    let worst = EXPONENTS.map(|e| true_error(&Series::new([e, e], STEPS), [e, e]));
    assert!(worst.iter().all(|&error| error < 0.02), "{worst:?}");
    assert!(worst[0] > 1e-4 && worst[3] > 1e-3 && worst[6] < ROUNDING, "{worst:?}");
}

#[test]
fn the_printed_series_of_n_five() {
    // FB81: 1 - .1 - .02 - .006 at x = y = 2^(-1/n), that is s = 1/2.
    let sum = series::Binomial::new(1.0 / 5.0).sum::<false>(0.5);
    assert!((sum - (1.0 - 0.1 - 0.02 - 0.006)).abs() < 1e-15, "{sum}");
}

#[test]
fn power_tables_are_good_to_a_step() {
    for e in EXPONENTS {
        let method = PowerTables::new(e, STEPS);
        // |dz/dt| = e/2 (1 - t)^(e/2 - 1), greatest at t = 2/3; each power is rounded by
        // half a step of 1/1500 at most.
        let bound = 0.5 * e * 3.0_f64.powf(1.0 - 0.5 * e) / 1500.0;
        let error = true_error(&method, [e, e]);
        assert!(error <= bound + ROUNDING && error > 0.05 * bound, "{e}: {error} {bound}");
        assert!(row_error(&method) == 0.0);
    }
}

#[test]
fn explicit_points_are_equally_far_apart_up_to_the_corner() {
    for e in EXPONENTS {
        let method = Explicit::new([e, e], STEPS);
        let [first, second, last] = [0, 1, STEPS - 1].map(|i| method.point(i, STEPS - 1));
        // Half a step before the corner x = y = z = 3^(-e/2), z being never less than there.
        let half_step = 0.5 * (second[0] - first[0]);
        let corner = 3.0_f64.powf(-0.5 * e);
        assert!((last[0] + half_step - corner).abs() < 1e-14 && last[2] >= last[0], "{e}");
    }
}
