//! Where lines through a solid are deepest in it, for many lines side by side.

use nalgebra::Vector3;

use crate::recover::kernel::{ModelView, geometric_distances};
use crate::shape::Superellipsoid;

/// Rounds of the golden section: they leave `0.618^24 = 1e-5` of the way through the shape's box.
const ROUNDS: usize = 24;

const GOLDEN: f64 = 0.618_033_988_749_895;

/// A line in a shape's frame, and from where to where along it the shape's box reaches.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    pub origin: Vector3<f64>,
    pub direction: Vector3<f64>,
    low: f64,
    high: f64,
}

impl Line {
    /// The line from an origin to `reach` times a direction, where it meets the shape's box.
    pub fn within_box(
        shape: &Superellipsoid,
        origin: Vector3<f64>,
        direction: Vector3<f64>,
        reach: f64,
    ) -> Option<Self> {
        let (mut low, mut high) = (0.0_f64, reach);
        for (k, side) in shape.size().into_iter().enumerate() {
            if direction[k] == 0.0 {
                if origin[k].abs() > side {
                    return None;
                }
                continue;
            }
            let ends = [-side, side].map(|end| (end - origin[k]) / direction[k]);
            low = low.max(ends[0].min(ends[1]));
            high = high.min(ends[0].max(ends[1]));
        }
        (low < high).then_some(Self { origin, direction, low, high })
    }

    /// Whether the solid is being entered where the line ends before it leaves the box.
    pub fn ends_entering(&self, shape: &Superellipsoid, reach: f64) -> bool {
        self.high == reach && shape.gauge_gradient(&self.at(self.high)).dot(&self.direction) <= 0.0
    }

    fn at(&self, t: f64) -> Vector3<f64> {
        self.origin + self.direction * t
    }
}

/// The deepest point of each line by the first-order geometric distance, as columns; of those lines
/// only that are within the solid there. `view` is the shape's own.
///
/// Far inside, where a line passes near the centre, the distance has other minima, too: of these it
/// may be any.
pub(super) fn deepest_points(view: &ModelView, lines: &[Line]) -> [Vec<f64>; 3] {
    let start = |share: f64| -> Vec<f64> {
        lines.iter().map(|line| line.low + share * (line.high - line.low)).collect()
    };
    let (left, right) = (start(1.0 - GOLDEN), start(GOLDEN));
    let (at_left, at_right) = (distances(view, lines, &left), distances(view, lines, &right));
    let mut brackets: Vec<Bracket> = (0..lines.len())
        .map(|i| Bracket {
            ends: [lines[i].low, lines[i].high],
            probes: [left[i], right[i]],
            at: [at_left[i], at_right[i]],
        })
        .collect();
    for _ in 0..ROUNDS {
        let probes: Vec<f64> = brackets.iter_mut().map(Bracket::narrow).collect();
        let found = distances(view, lines, &probes);
        brackets.iter_mut().zip(found).for_each(|(bracket, distance)| bracket.take(distance));
    }
    let deepest = lines.iter().zip(&brackets).filter_map(|(line, bracket)| {
        let (t, distance) = bracket.least();
        (distance < 0.0).then(|| line.at(t))
    });
    columns(deepest)
}

/// The signed distance at a place along each line.
fn distances(view: &ModelView, lines: &[Line], places: &[f64]) -> Vec<f64> {
    let points = columns(lines.iter().zip(places).map(|(line, &t)| line.at(t)));
    geometric_distances(view, points.each_ref().map(|column| &column[..]), false)
}

fn columns(points: impl Iterator<Item = Vector3<f64>>) -> [Vec<f64>; 3] {
    let mut columns = [Vec::new(), Vec::new(), Vec::new()];
    for point in points {
        columns.iter_mut().zip(&point).for_each(|(column, x)| column.push(*x));
    }
    columns
}

/// An interval that holds a minimum, and two places in it that are probed.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    ends: [f64; 2],
    probes: [f64; 2],
    /// The values there; that of a place not yet probed is not a number.
    at: [f64; 2],
}

impl Bracket {
    /// Leaves out the side where the minimum is not: the place to be probed next.
    fn narrow(&mut self) -> f64 {
        let Self { ends: [low, high], probes: [left, right], at: [at_left, at_right] } = *self;
        *self = if at_left < at_right {
            let probe = right - GOLDEN * (right - low);
            Self { ends: [low, right], probes: [probe, left], at: [f64::NAN, at_left] }
        } else {
            let probe = left + GOLDEN * (high - left);
            Self { ends: [left, high], probes: [right, probe], at: [at_right, f64::NAN] }
        };
        self.probes[self.open()]
    }

    /// Takes the value at the place that was to be probed.
    fn take(&mut self, value: f64) {
        self.at[self.open()] = value;
    }

    /// Which of both places is to be probed.
    fn open(&self) -> usize {
        usize::from(!self.at[0].is_nan())
    }

    /// The place of the lesser value, and that value.
    fn least(&self) -> (f64, f64) {
        let k = usize::from(self.at[1] < self.at[0]);
        (self.probes[k], self.at[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_as_deep_as_the_deepest_of_many_places() {
        let shape = Superellipsoid::new([1.0, 0.7, 1.4], [0.3, 0.8]).unwrap();
        let view = ModelView::of_shape(&shape);
        let mut within = 0;
        for k in 0..40 {
            let turn = 0.16 * f64::from(k);
            let origin = Vector3::new(0.6 * turn.sin(), 0.5 * turn.cos(), -3.0);
            let direction = Vector3::new(0.1 * turn.cos(), 0.2 * (2.0 * turn).sin(), 1.0);
            let Some(line) = Line::within_box(&shape, origin, direction, 10.0) else { continue };
            let least = |x: &Vector3<f64>| (shape.gauge(x) - 1.0) / shape.gauge_gradient(x).norm();
            let tried = (0..=20_000).map(|i| least(&line.at(1.0 + f64::from(i) * 2e-4)));
            let expected = tried.fold(f64::INFINITY, f64::min);
            let [x, y, z] = deepest_points(&view, &[line]);
            assert_eq!(x.is_empty(), expected > 0.0);
            // Near the centre there are several minima.
            if x.is_empty() || expected < -0.5 {
                continue;
            }
            within += 1;
            let found = least(&Vector3::new(x[0], y[0], z[0]));
            assert!((found - expected).abs() < 2e-4, "{k}: {found} {expected}");
        }
        assert!(within > 10, "{within}");
    }
}
