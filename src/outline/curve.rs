//! Closed curves of the rim, and their points at even distances.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::path::Path;
use crate::model::Model;
use crate::view::{RimError, Viewpoint, rim};

/// A closed curve of the rim as points of it, as many as its form takes.
pub(super) struct Curve<'a> {
    pub points: Vec<Vector3<f64>>,
    source: Source<'a>,
}

/// What tells other points of the curve.
enum Source<'a> {
    Convex(Model, Viewpoint),
    /// The path, and the places on it of the curve's points.
    Traced(Path<'a>, Vec<f64>),
}

impl<'a> Curve<'a> {
    /// The rim of a convex superellipsoid.
    pub fn convex(model: Model, viewpoint: Viewpoint, points: Vec<Vector3<f64>>) -> Self {
        Self { points, source: Source::Convex(model, viewpoint) }
    }

    /// A path, and places and points of it in their order.
    pub fn traced(path: Path<'a>, places: Vec<f64>, points: Vec<Vector3<f64>>) -> Self {
        Self { points, source: Source::Traced(path, places) }
    }

    /// The length.
    pub fn length(&self) -> f64 {
        chords(&self.points).map(|[a, b]| (b - a).norm()).sum()
    }

    /// So many points of the rim at even distances.
    ///
    /// # Errors
    /// If the viewpoint is not outside a convex solid.
    pub fn evenly(&self, count: usize) -> Result<Vec<Vector3<f64>>, RimError> {
        match &self.source {
            Source::Convex(Model { shape, pose }, viewpoint) => {
                let points = rim(shape, &viewpoint.in_frame_of(pose), count)?;
                Ok(points.iter().map(|x| pose.world_from_model(x)).collect())
            }
            Source::Traced(path, places) => {
                let at = |(chord, share): (usize, f64)| {
                    let end = places.get(chord + 1).copied().unwrap_or(path.len() as f64);
                    path.at(places[chord] + share * (end - places[chord]))
                };
                Ok(self.shares(count).into_par_iter().map(at).collect())
            }
        }
    }

    /// Chords by their numbers, and shares of them, at even distances.
    fn shares(&self, count: usize) -> Vec<(usize, f64)> {
        let step = self.length() / count as f64;
        let mut shares = Vec::with_capacity(count);
        let mut passed = 0.0;
        for (number, [a, b]) in chords(&self.points).enumerate() {
            let length = (b - a).norm();
            while shares.len() < count && step * shares.len() as f64 <= passed + length {
                let ahead = step * shares.len() as f64 - passed;
                let share = if length > 0.0 { (ahead / length).clamp(0.0, 1.0) } else { 0.0 };
                shares.push((number, share));
            }
            passed += length;
        }
        shares
    }
}

/// The chords of a closed curve.
fn chords(points: &[Vector3<f64>]) -> impl Iterator<Item = [Vector3<f64>; 2]> + '_ {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| [*a, *b])
}
