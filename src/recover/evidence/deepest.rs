//! Where lines through a solid are deepest in it, for many lines side by side.

use nalgebra::Vector3;

use crate::recover::kernel::{ModelView, geometric_distances, normals};
use crate::recover::subset::Subset;
use crate::shape::Superellipsoid;

/// Places along each line that are looked at in a round: few lines fill the vectors with them.
const PLACES: usize = 8;

/// Rounds, each of which leaves `2 / 9` of the way: in the end `(2 / 9)^5 = 5e-4` of that through the
/// shape's box, within which the distance is a parabola.
const ROUNDS: usize = 5;

/// A line in a shape's frame, and from where to where along it the shape's box reaches.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    pub origin: Vector3<f64>,
    pub direction: Vector3<f64>,
    low: f64,
    high: f64,
    /// Whether it ends before it leaves the box.
    ends_within: bool,
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
        (low < high).then_some(Self { origin, direction, low, high, ends_within: high == reach })
    }

    /// One of the [`PLACES`], evenly within the ends, which have the places before and after.
    fn place(&self, k: usize) -> f64 {
        self.low + (k + 1) as f64 / (PLACES + 1) as f64 * (self.high - self.low)
    }

    /// Cuts the line to what is next to the place of the least of these distances: there it is the
    /// deepest, if it is within the solid.
    fn narrow(&mut self, distances: &[f64]) -> Option<Vector3<f64>> {
        let mut least = 0;
        for k in 1..PLACES {
            if distances[k] < distances[least] {
                least = k;
            }
        }
        let (place, is_inner) = (self.place(least), least > 0 && least + 1 < PLACES);
        let high = if least + 1 < PLACES { self.place(least + 1) } else { self.high };
        self.low = if least > 0 { self.place(least - 1) } else { self.low };
        self.high = high;
        let step = if is_inner { vertex(&distances[least - 1..=least + 1]) } else { 0.0 };
        let deepest = self.at(place + 0.5 * step * (self.high - self.low));
        (distances[least] < 0.0).then_some(deepest)
    }

    fn at(&self, t: f64) -> Vector3<f64> {
        self.origin + self.direction * t
    }
}

/// Where a parabola through values at -1, 0 and 1 is least, the middle one being the least.
fn vertex(values: &[f64]) -> f64 {
    let [fall, rise] = [values[0] - values[1], values[2] - values[1]];
    if fall + rise > 0.0 { 0.5 * (fall - rise) / (fall + rise) } else { 0.0 }
}

/// Those lines on which the solid is not just being entered where they end.
pub(super) fn not_entering(view: &ModelView, lines: Vec<Line>) -> Vec<Line> {
    let ends: Subset = lines.iter().map(|line| line.at(line.high)).collect();
    let normals = normals(view, ends.columns());
    let is_kept = |(line, normal): &(Line, [f64; 3])| {
        !line.ends_within || line.direction.dot(&Vector3::from(*normal)) > 0.0
    };
    lines.into_iter().zip(normals).filter(is_kept).map(|(line, _)| line).collect()
}

/// The deepest point of each line by the first-order geometric distance; of those lines only that are
/// within the solid there. `view` is the shape's own.
///
/// Far inside, where a line passes near the centre, the distance has other minima, too: of these it
/// may be any.
pub(super) fn deepest_points(view: &ModelView, mut lines: Vec<Line>) -> Subset {
    let mut deepest: Vec<Option<Vector3<f64>>> = Vec::new();
    for _ in 0..ROUNDS {
        let points = lines.iter().flat_map(|line| (0..PLACES).map(|k| line.at(line.place(k))));
        let points: Subset = points.collect();
        let found = geometric_distances(view, points.columns(), false);
        deepest =
            lines.iter_mut().zip(found.chunks(PLACES)).map(|(line, d)| line.narrow(d)).collect();
    }
    deepest.into_iter().flatten().collect()
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
            let deepest = deepest_points(&view, vec![line]);
            let [x, y, z] = deepest.columns();
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
