//! Points in a row, and the curve of straight edges between them.

use nalgebra::Vector2;

use super::curve::{Curve, CurvePoint};
use crate::error::ModelError;

/// Points in a row, in a unit of the caller: a curve of straight edges, open or closed.
///
/// As a [`Curve`] its parameter counts the points: it is k at the point of index k, and moves evenly
/// along the edges between.
#[derive(Debug, Clone, PartialEq)]
pub struct Polyline {
    points: Vec<Vector2<f64>>,
    is_closed: bool,
}

impl Polyline {
    /// Most points of a polyline that is given: the spherical product of two of them still has a
    /// mesh.
    pub const MOST_POINTS: usize = 10_000;

    /// A polyline through points, of which a closed one leads from the last to the first by itself.
    ///
    /// # Errors
    /// If there are fewer than two points, three of a closed one, or more than
    /// [`MOST_POINTS`](Self::MOST_POINTS); if one is not finite, or the same as the one before it.
    pub fn new(points: Vec<Vector2<f64>>, is_closed: bool) -> Result<Self, ModelError> {
        let (least, most) = (if is_closed { 3 } else { 2 }, Self::MOST_POINTS);
        if !(least..=most).contains(&points.len()) {
            return Err(ModelError::PointCount { least, most, found: points.len() });
        }
        let is_finite = |x: &Vector2<f64>| x.iter().all(|coordinate| coordinate.is_finite());
        if let Some(index) = points.iter().position(|x| !is_finite(x)) {
            return Err(ModelError::Point { index, must: "be finite numbers" });
        }
        let line = Self { points, is_closed };
        let must = "differ from the next point; a closed polyline does not repeat its first";
        match (0..line.edges()).find(|&edge| line.edge(edge).0 == line.edge(edge).1) {
            Some(index) => Err(ModelError::Point { index, must }),
            None => Ok(line),
        }
    }

    /// A polyline whose points are known to be as they must.
    pub(super) fn of(points: Vec<Vector2<f64>>, is_closed: bool) -> Self {
        Self { points, is_closed }
    }

    /// The points, in order; of a closed curve none is repeated.
    pub fn points(&self) -> &[Vector2<f64>] {
        &self.points
    }

    /// Whether the first point follows the last.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    fn edges(&self) -> usize {
        self.points.len() - usize::from(!self.is_closed)
    }

    /// The ends of the edge of an index.
    fn edge(&self, index: usize) -> (Vector2<f64>, Vector2<f64>) {
        (self.points[index], self.points[(index + 1) % self.points.len()])
    }
}

impl Curve for Polyline {
    /// From 0 to the number of edges.
    fn range(&self) -> [f64; 2] {
        [0.0, self.edges() as f64]
    }

    /// At a point, the tangent of the edge that begins there, or ends where none begins. A closed
    /// polyline goes round again beyond its range, an open one has no points there, but NaN.
    fn at(&self, t: f64) -> CurvePoint {
        let edges = self.edges() as f64;
        let within = if self.is_closed { t.rem_euclid(edges) } else { t };
        // Written so that NaN is refused too.
        let is_on = (0.0..=edges).contains(&within);
        if !is_on {
            let nowhere = Vector2::repeat(f64::NAN);
            return CurvePoint { position: nowhere, tangent: nowhere, second: nowhere };
        }
        let index = within.min(edges - 1.0).floor();
        let (from, to) = self.edge(index as usize);
        let share = within - index;
        CurvePoint {
            position: from * (1.0 - share) + to * share,
            tangent: to - from,
            second: Vector2::zeros(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[[f64; 2]], is_closed: bool) -> Result<Polyline, ModelError> {
        Polyline::new(points.iter().map(|&x| x.into()).collect(), is_closed)
    }

    const CORNERS: [[f64; 2]; 3] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1e-300]];

    #[test]
    fn the_parameter_counts_the_points_and_moves_evenly_along_the_edges() {
        for is_closed in [false, true] {
            let line = line(&CORNERS, is_closed).unwrap();
            assert_eq!(line.range(), [0.0, if is_closed { 3.0 } else { 2.0 }]);
            for (t, corner) in [0.0, 1.0, 2.0].into_iter().zip(CORNERS) {
                assert_eq!(line.at(t).position, Vector2::from(corner));
            }
            assert_eq!(line.at(0.25).position, Vector2::new(0.5, 0.0));
            assert_eq!(line.at(0.25).tangent, Vector2::new(2.0, 0.0));
            assert_eq!(line.at(1.5).tangent, Vector2::new(0.0, 1e-300));
            assert_eq!(line.at(1.5).second, Vector2::zeros());
        }
    }

    #[test]
    fn closed_polylines_go_round_and_open_ones_end() {
        let (open, ring) = (line(&CORNERS, false).unwrap(), line(&CORNERS, true).unwrap());
        for turn in [-3.0, 3.0, 300.0] {
            assert_eq!(ring.at(0.25 + turn), ring.at(0.25));
            assert!(open.at(0.25 + turn).position.x.is_nan());
        }
        assert_eq!(ring.at(2.5).position, Vector2::new(1.0, 5e-301));
        assert_eq!(open.at(2.0).tangent, Vector2::new(0.0, 1e-300));
        assert!(ring.at(f64::NAN).position.x.is_nan() && open.at(f64::NAN).position.x.is_nan());
        assert!(ring.at(f64::INFINITY).position.x.is_nan());
        // A remainder so near to the end that it is rounded there.
        assert_eq!(ring.at(-1e-300).position, Vector2::zeros());
    }

    #[test]
    fn what_makes_no_polyline_is_named() {
        let many = vec![[0.0, 1.0]; Polyline::MOST_POINTS + 1];
        let nan = [[0.0, 0.0], [1.0, f64::NAN]];
        let cases: [(&[[f64; 2]], bool, &str); 7] = [
            (&[], false, "from 2 to 10000 points, found 0"),
            (&CORNERS[..1], false, "found 1"),
            (&CORNERS[..2], true, "from 3"),
            (&many, false, "found 10001"),
            (&nan, false, "points[1] must be finite"),
            (&[[0.0, 1.0], [0.0, 1.0]], false, "points[0] must differ"),
            (&[[0.0, 1.0], [1.0, 1.0], [0.0, 1.0]], true, "points[2] must differ"),
        ];
        for (points, is_closed, expected) in cases {
            let message = line(points, is_closed).unwrap_err().to_string();
            assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        }
    }
}
