//! Random points of a boundary, uniform by area, from patches of it.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::covering::Covering;
use super::grading::Grading;

/// Segments of the lattice whose triangles the patches lie over.
const SEGMENTS: usize = 16;

/// Steps along each side of the grid on which a patch's area elements are looked at.
const STEPS: u32 = 4;

/// Margin on the greatest element that the grid shows, or that a draw exceeds a bound by.
const MARGIN: f64 = 1.2;

/// How far tangents reach, as a share of a patch's sides.
const STEP: f64 = 1e-6;

/// The part of a boundary over a triangle of its polyhedron.
#[derive(Debug, Clone, Copy)]
struct Patch {
    places: [Vector3<f64>; 3],
    /// What no element of area is greater than, as far as is known.
    bound: f64,
}

/// `count` independent points of a boundary, uniform by area; the same for the same seed.
///
/// A patch is chosen by the bound on its elements of area, a place on its triangle at random, and
/// kept with a probability proportional to the element there. Should an element exceed its bound,
/// all points are drawn anew with a greater one.
pub(super) fn sample(surface: &Covering, count: usize, seed: u64) -> Vec<Vector3<f64>> {
    let mut patches = patches(surface);
    loop {
        match draw(surface, &patches, count, seed) {
            Ok(points) => return points,
            Err((patch, element)) => patches[patch].bound = MARGIN * element,
        }
    }
}

/// Patches that cover a boundary.
fn patches(surface: &Covering) -> Vec<Patch> {
    let lattice = surface.lattice(SEGMENTS, Grading::Even);
    let share = |i: u32| f64::from(i) / f64::from(STEPS);
    let patch = |triangle: &[u32; 3]| {
        let places = triangle.map(|i| lattice.places[i as usize]);
        let grid = (0..=STEPS).flat_map(|i| (0..=STEPS - i).map(move |j| [i, j].map(share)));
        let greatest = grid.map(|at| element(surface, &places, at)).fold(0.0, f64::max);
        Patch { places, bound: MARGIN * greatest }
    };
    lattice.triangles.iter().map(patch).collect()
}

/// The points drawn under the patches' bounds, or a patch and the element that exceeds its bound.
fn draw(
    surface: &Covering,
    patches: &[Patch],
    count: usize,
    seed: u64,
) -> Result<Vec<Vector3<f64>>, (usize, f64)> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let bounds = patches.iter().scan(0.0, |sum, patch| {
        *sum += patch.bound;
        Some(*sum)
    });
    let bounds: Vec<f64> = bounds.collect();
    let total = bounds[bounds.len() - 1];
    let mut points = Vec::with_capacity(count);
    while points.len() < count {
        let chosen = rng.random::<f64>() * total;
        let number = bounds.partition_point(|&sum| sum <= chosen).min(patches.len() - 1);
        let Patch { places, bound } = patches[number];
        let [u, v]: [f64; 2] = [rng.random(), rng.random()];
        let at = if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] };
        let element = element(surface, &places, at);
        if element > bound {
            return Err((number, element));
        }
        if rng.random::<f64>() * bound < element {
            points.push(surface.point(&place(&places, at)));
        }
    }
    Ok(points)
}

/// The place of barycentric coordinates u and v.
fn place([a, b, c]: &[Vector3<f64>; 3], [u, v]: [f64; 2]) -> Vector3<f64> {
    a + (b - a) * u + (c - a) * v
}

/// The area of the boundary over that of the triangle, up to a factor that is the patch's own: the
/// product of tangents along its sides.
fn element(surface: &Covering, places: &[Vector3<f64>; 3], at: [f64; 2]) -> f64 {
    let point = |at| surface.point(&place(places, at));
    // Towards the middle of the triangle, so that they stay on its side of a bend.
    let [du, dv] = at.map(|share| if share < 1.0 / 3.0 { STEP } else { -STEP });
    let middle = point(at);
    let [along_u, along_v] =
        [[at[0] + du, at[1]], [at[0], at[1] + dv]].map(|at| point(at) - middle);
    along_u.cross(&along_v).norm() / (STEP * STEP)
}

#[cfg(test)]
mod tests;
