//! Every profile: slopes against differences, enclosures against samples.

use super::*;

fn knots() -> Vec<[f64; 2]> {
    vec![[-1.0, 0.5], [-0.2, 1.5], [0.1, 1.6], [0.5, 0.9], [2.0, 0.9]]
}

/// A profile of no form known here: `exp(z/2)`.
#[derive(Debug)]
struct Exponential;

impl Univariate for Exponential {
    fn value(&self, z: f64) -> f64 {
        (0.5 * z).exp()
    }

    fn slope(&self, z: f64) -> f64 {
        0.5 * self.value(z)
    }

    fn value_range(&self, z: Interval) -> Interval {
        Interval::new(self.value(z.lo()), self.value(z.hi())).widened_relatively(f64::EPSILON)
    }

    fn slope_range(&self, z: Interval) -> Interval {
        self.value_range(z) * 0.5
    }
}

fn profiles() -> Vec<Profile> {
    vec![
        Line::new(1.0, -0.3).unwrap().into(),
        Polyline::new(knots()).unwrap().into(),
        Polyline::new(vec![[0.3, 2.0]]).unwrap().into(),
        Spline::new(knots()).unwrap().into(),
        Spline::new(vec![[0.3, 2.0]]).unwrap().into(),
        Spline::new(vec![[-0.5, 2.0], [0.5, 1.0]]).unwrap().into(),
        Profile::Function(Arc::new(Exponential)),
    ]
}

fn positions() -> impl Iterator<Item = f64> {
    (-30..=50).map(|i| 0.05 * f64::from(i) + 0.0123)
}

#[test]
fn slopes_are_difference_quotients() {
    let h = 1e-6;
    for profile in profiles() {
        for z in positions() {
            let quotient = (profile.value(z + h) - profile.value(z - h)) / (2.0 * h);
            assert!((profile.slope(z) - quotient).abs() < 1e-8, "{profile:?} {z}");
        }
    }
}

#[test]
fn ranges_hold_values_and_slopes() {
    for profile in profiles() {
        for start in positions() {
            for width in [0.0, 0.02, 0.3, 2.0] {
                let range = Interval::new(start, start + width);
                for i in 0..=10 {
                    let z = (start + width * 0.1 * f64::from(i)).min(range.hi());
                    let (values, slopes) = (profile.value_range(range), profile.slope_range(range));
                    assert!(values.contains(profile.value(z)), "{profile:?} {range:?}");
                    assert!(slopes.contains(profile.slope(z)), "{profile:?} {range:?}");
                }
            }
        }
    }
}

#[test]
fn pieces_pass_through_their_knots_and_stay_beyond() {
    for profile in
        [Profile::from(Polyline::new(knots()).unwrap()), Spline::new(knots()).unwrap().into()]
    {
        for [z, value] in knots() {
            assert_eq!(profile.value(z), value);
        }
        assert_eq!((profile.value(-9.0), profile.slope(-9.0)), (0.5, 0.0));
        assert_eq!((profile.value(9.0), profile.slope(9.0)), (0.9, 0.0));
    }
}

#[test]
fn a_spline_has_no_kinks_and_turns_only_at_knots() {
    let spline = Spline::new(knots()).unwrap();
    for [z, _] in knots() {
        assert!((spline.slope(z + 1e-9) - spline.slope(z - 1e-9)).abs() < 1e-6);
    }
    for pair in knots().windows(2) {
        let direction = (pair[1][1] - pair[0][1]).signum();
        let slope =
            |i: i32| spline.slope(pair[0][0] + (pair[1][0] - pair[0][0]) * 0.05 * f64::from(i));
        assert!((1..20).all(|i| slope(i) * direction >= 0.0));
    }
}

#[test]
fn knots_outside_their_domain_are_refused() {
    for bad in
        [vec![], vec![[0.0, 1.0], [0.0, 2.0]], vec![[f64::NAN, 1.0]], vec![[0.0, f64::INFINITY]]]
    {
        assert!(Polyline::new(bad.clone()).is_err());
        assert!(Spline::new(bad).is_err());
    }
    assert!(Line::new(f64::NAN, 1.0).is_err());
}
