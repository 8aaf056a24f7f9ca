//! Points along plane curves: along those of a formula from quarters that are mirrored: what is symmetric stays so, and
//! points on the axes are exactly there.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector2;

use super::clipped_curve::{ClippedCurve, PlaneCurve};
use super::{Curve, LameCurve, Polyline, Superellipse, Superhyperbola};

impl ClippedCurve {
    /// The branches of the curve, each with so many segments (at least one) to a quadrant, at even
    /// steps of the parameter, counter-clockwise about the origin; a polyline is itself.
    pub fn polylines(&self, segments: usize) -> Vec<Polyline> {
        match self.curve() {
            PlaneCurve::Superellipse(curve) => vec![ring(&ellipse_quarter(curve, segments))],
            PlaneCurve::Superhyperbola(curve) => {
                let branch = mirrored(&hyperbola_quarter(curve, self.clip(), segments));
                let other = branch.iter().map(|x| -x).collect();
                vec![open(branch), open(other)]
            }
            PlaneCurve::Lame(curve) => lame_polylines(curve, self.clip(), segments),
            PlaneCurve::Polyline(line) => vec![line.clone()],
        }
    }

    /// The branches as a meridian, from south to north: of a curve that is symmetric about the y
    /// axis the half `x >= 0`, whose spherical product is the whole surface (B81); a polyline is
    /// itself, symmetric or not.
    pub fn meridians(&self, segments: usize) -> Vec<Polyline> {
        let half = |curve: &Superellipse| vec![open(mirrored(&ellipse_quarter(curve, segments)))];
        match self.curve() {
            PlaneCurve::Superellipse(curve) => half(curve),
            PlaneCurve::Lame(curve) if matches!(curve.kind(), 1 | 2) => half(&ellipse_of(curve)),
            PlaneCurve::Superhyperbola(_) => self.polylines(segments)[..1].to_vec(),
            PlaneCurve::Lame(curve) if curve.kind() == 7 => {
                let is_right = |line: &Polyline| line.points()[0].x > 0.0;
                self.polylines(segments).into_iter().filter(is_right).collect()
            }
            PlaneCurve::Lame(_) | PlaneCurve::Polyline(_) => self.polylines(segments),
        }
    }
}

fn open(points: Vec<Vector2<f64>>) -> Polyline {
    Polyline::of(points, false)
}

fn lame_polylines(curve: &LameCurve, clip: f64, segments: usize) -> Vec<Polyline> {
    let inner = || ellipse_quarter(&ellipse_of(curve), segments);
    let unbounded = || unbounded_quarter(curve, clip, segments);
    match curve.kind() {
        1 | 2 => vec![ring(&inner())],
        3 | 4 => vec![open(inner())],
        5 | 6 => vec![open(with_tails(curve, &inner(), clip, segments))],
        7 => {
            let first = unbounded();
            let second: Vec<_> = first.iter().rev().map(|x| flipped(x, [-1.0, 1.0])).collect();
            let turned = |line: &[Vector2<f64>]| line.iter().map(|x| -x).collect();
            let [third, fourth] = [turned(&first), turned(&second)];
            [first, second, third, fourth].map(open).into()
        }
        8 => vec![open(unbounded())],
        _ => {
            let through_origin = through_origin(curve, clip, segments);
            vec![open(unbounded()), open(through_origin)]
        }
    }
}

/// The superellipse of which a Lame curve of positive m has the quarter `x, y >= 0`.
fn ellipse_of(curve: &LameCurve) -> Superellipse {
    Superellipse::of(curve.size(), 2.0 / curve.exponent())
}

/// Points at even steps of the parameter, both ends included.
fn along(curve: &impl Curve, [first, last]: [f64; 2], segments: usize) -> Vec<Vector2<f64>> {
    let share = |i: usize| i as f64 / segments as f64;
    let parameter = |i: usize| first * (1.0 - share(i)) + last * share(i);
    (0..=segments).map(|i| curve.at(parameter(i)).position).collect()
}

/// From `(a, 0)` to `(0, b)`.
fn ellipse_quarter(curve: &Superellipse, segments: usize) -> Vec<Vector2<f64>> {
    let mut points = along(curve, [0.0, FRAC_PI_2], segments);
    points[segments].x = 0.0;
    points
}

/// From `(a, 0)` to `x = clip a`, where `tan^2 = clip^(2/e) - 1`.
fn hyperbola_quarter(curve: &Superhyperbola, clip: f64, segments: usize) -> Vec<Vector2<f64>> {
    let ([a, b], e) = (curve.size(), curve.exponent());
    let log_power = 2.0 / e * clip.ln();
    let mut points = along(curve, [0.0, log_power.exp_m1().sqrt().atan()], segments);
    // The angle itself loses digits near a right one.
    points[segments] = clip * Vector2::new(a, b * (-(-log_power).exp_m1()).powf(0.5 * e));
    points
}

/// The arc `x, y > 0` of a curve of negative m, from `x = clip a` to `y = clip b`, where the cosine
/// and the sine are `clip^(m/2)`.
fn unbounded_quarter(curve: &LameCurve, clip: f64, segments: usize) -> Vec<Vector2<f64>> {
    let least = clip.powf(0.5 * curve.exponent()).max(f64::MIN_POSITIVE);
    along(&curve.arcs()[0], [least.acos(), least.asin()], segments)
}

/// The arcs of a curve of odd, positive m: one that comes from below, the inner one, and one that
/// leaves to the left.
fn with_tails(
    curve: &LameCurve,
    inner: &[Vector2<f64>],
    clip: f64,
    segments: usize,
) -> Vec<Vector2<f64>> {
    let ([a, b], e) = (curve.size(), 2.0 / curve.exponent());
    let tail = |size| hyperbola_quarter(&Superhyperbola::of(size, e), clip, segments);
    let below = tail([a, b]).into_iter().skip(1).rev().map(|x| flipped(&x, [1.0, -1.0]));
    let left = tail([b, a]).into_iter().skip(1).map(|x| Vector2::new(-x.y, x.x));
    below.chain(inner.iter().copied()).chain(left).collect()
}

/// The outer arcs of a curve of odd, negative m, from `y = -clip b` through the origin to
/// `x = -clip a`, where the tangent is `clip^(m/2)`.
fn through_origin(curve: &LameCurve, clip: f64, segments: usize) -> Vec<Vector2<f64>> {
    let first = clip.powf(0.5 * curve.exponent()).max(f64::MIN_POSITIVE).atan();
    let [below, left] = [1, 2].map(|i| along(&curve.arcs()[i], [first, FRAC_PI_2], segments));
    let before = below.into_iter().take(segments);
    let after = left.into_iter().take(segments).rev();
    before.chain([Vector2::zeros()]).chain(after).collect()
}

/// A point with its coordinates times two signs.
fn flipped(x: &Vector2<f64>, signs: [f64; 2]) -> Vector2<f64> {
    x.component_mul(&Vector2::from(signs))
}

/// A quarter that begins on the x axis, after its mirror image below that.
fn mirrored(quarter: &[Vector2<f64>]) -> Vec<Vector2<f64>> {
    let below = quarter[1..].iter().rev().map(|x| flipped(x, [1.0, -1.0]));
    below.chain(quarter.iter().copied()).collect()
}

/// The closed curve of a quarter from the x axis to the y axis.
fn ring(quarter: &[Vector2<f64>]) -> Polyline {
    let half = mirrored(quarter);
    let right = &half[..half.len() - 1];
    let points = right.iter().copied().chain(right.iter().map(|x| -x)).collect();
    Polyline::of(points, true)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [f64; 2] = [2.0, 0.3];
    const SEGMENTS: usize = 16;

    /// An exponent of each of JLS's nine kinds, steep ones too, and the branches that each has.
    const KINDS: [(i32, u32, usize); 13] = [
        (8, 3, 1),
        (40, 1, 1),
        (2, 3, 1),
        (5, 2, 1),
        (1, 2, 1),
        (3, 1, 1),
        (39, 1, 1),
        (1, 3, 1),
        (-2, 1, 4),
        (-3, 2, 1),
        (-1, 3, 2),
        (-5, 1, 2),
        (-3000, 1, 4),
    ];

    fn ratios(x: &Vector2<f64>) -> Vector2<f64> {
        Vector2::new(x.x / SIZE[0], x.y / SIZE[1])
    }

    /// Points that turn counter-clockwise about the origin, or run through it.
    fn assert_counter_clockwise(line: &Polyline) {
        for pair in line.points().windows(2) {
            assert!(pair[0].perp(&pair[1]) >= 0.0, "{pair:?}");
        }
    }

    #[test]
    fn polylines_of_lame_curves_lie_on_them_as_far_as_the_clip() {
        for (numerator, denominator, branches) in KINDS {
            let curve = LameCurve::new(SIZE, numerator, denominator).unwrap();
            let clipped = ClippedCurve::new(PlaneCurve::Lame(curve), None).unwrap();
            let lines = clipped.polylines(SEGMENTS);
            assert_eq!(lines.len(), branches, "{numerator}/{denominator}");
            for x in
                lines.iter().inspect(|line| assert_counter_clockwise(line)).flat_map(|l| l.points())
            {
                let u = ratios(x);
                assert!(u.amax() <= clipped.clip() * (1.0 + 1e-9), "{numerator}/{denominator} {u}");
                let power = u.map(|u| u.abs().powf(curve.exponent())).amax();
                let defect = (curve.implicit(x) - 1.0).abs();
                // At the origin a negative power is infinite.
                let is_on = *x == Vector2::zeros() || defect < 1e-11 * power.max(1.0);
                assert!(is_on, "{numerator}/{denominator} {u} {defect}");
            }
        }
    }

    #[test]
    fn unbounded_branches_end_at_the_clip() {
        for e in [0.001, 0.05, 0.5, 1.0, 2.0, 3.0] {
            let curve = Superhyperbola::new(SIZE, e).unwrap();
            let clipped = ClippedCurve::new(PlaneCurve::Superhyperbola(curve), Some(3.0)).unwrap();
            let lines = clipped.polylines(SEGMENTS);
            assert_eq!(lines.len(), 2);
            for line in &lines {
                assert_eq!((line.points().len(), line.is_closed()), (2 * SEGMENTS + 1, false));
                for end in [0, 2 * SEGMENTS] {
                    assert!((ratios(&line.points()[end]).amax() / 3.0 - 1.0).abs() < 1e-15, "{e}");
                }
                assert_eq!(line.points()[SEGMENTS].y, 0.0);
            }
            assert_eq!(clipped.meridians(SEGMENTS), lines[..1]);
        }
    }

    #[test]
    fn superellipses_are_closed_and_their_meridians_end_on_the_axis() {
        for e in [0.05, 0.5, 1.0, 2.0, 3.0] {
            let curve = Superellipse::new(SIZE, e).unwrap();
            let clipped = ClippedCurve::new(PlaneCurve::Superellipse(curve), None).unwrap();
            let lines = clipped.polylines(SEGMENTS);
            assert_eq!((lines.len(), lines[0].points().len()), (1, 4 * SEGMENTS));
            assert!(lines[0].is_closed());
            assert_counter_clockwise(&lines[0]);
            let meridians = clipped.meridians(SEGMENTS);
            let meridian = meridians[0].points();
            let [south, north] = [meridian[0], meridian[2 * SEGMENTS]];
            assert_eq!([south, north], [Vector2::new(0.0, -0.3), Vector2::new(0.0, 0.3)]);
            for x in lines[0].points().iter().chain(meridian) {
                assert!((curve.gauge(x) - 1.0).abs() < 1e-14, "{e} {x}");
            }
        }
    }

    #[test]
    fn clips_that_leave_nothing_are_refused() {
        let lame = |m| PlaneCurve::Lame(LameCurve::new(SIZE, m, 3).unwrap());
        assert!(ClippedCurve::new(lame(-1), Some(8.0)).is_err());
        assert!(ClippedCurve::new(lame(-1), Some(8.1)).is_ok());
        assert!(ClippedCurve::new(lame(1), Some(1.0)).is_err());
        assert!(ClippedCurve::new(lame(1), Some(f64::INFINITY)).is_err());
    }
}
