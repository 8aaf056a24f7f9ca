//! Closed curves of the rim with their points at even distances.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::facing::Facing;
use crate::shape::LevelSet;

/// The length of a closed polygon.
pub(super) fn length(curve: &[Vector3<f64>]) -> f64 {
    segments(curve).map(|[a, b]| (b - a).norm()).sum()
}

/// So many points of the rim at even distances along a closed curve of its points.
pub(super) fn evenly<S: LevelSet + Sync>(
    facing: &Facing<'_, S>,
    curve: &[Vector3<f64>],
    count: usize,
) -> Vec<Vector3<f64>> {
    let place = |(chord, share): ([Vector3<f64>; 2], f64)| {
        let nearest = chord[if share < 0.5 { 0 } else { 1 }];
        if share == 0.0 { nearest } else { facing.beside(chord, share).unwrap_or(nearest) }
    };
    places(curve, count).into_par_iter().map(place).collect()
}

/// Chords of a closed curve and shares of them at even distances along it.
fn places(curve: &[Vector3<f64>], count: usize) -> Vec<([Vector3<f64>; 2], f64)> {
    let step = length(curve) / count as f64;
    let mut places = Vec::with_capacity(count);
    let mut passed = 0.0;
    for chord @ [a, b] in segments(curve) {
        let length = (b - a).norm();
        while places.len() < count && step * places.len() as f64 <= passed + length {
            let ahead = step * places.len() as f64 - passed;
            places.push((chord, if length > 0.0 { (ahead / length).clamp(0.0, 1.0) } else { 0.0 }));
        }
        passed += length;
    }
    places
}

fn segments(curve: &[Vector3<f64>]) -> impl Iterator<Item = [Vector3<f64>; 2]> + '_ {
    let next = curve.iter().cycle().skip(1);
    curve.iter().zip(next).map(|(a, b)| [*a, *b])
}
