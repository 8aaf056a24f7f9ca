//! The boundary of a silhouette, held against rays: where edges run to a blade or a corner, the
//! rim alone may be a pixel off.

use nalgebra::Vector2;
use rayon::prelude::*;

use super::silhouette::signed_area;

/// Most pixels from a vertex to the next where rays are cast.
const STEP: f64 = 0.75;

/// Pixels to either side of the boundary at which one ray must hit and one must miss.
const ASIDE: f64 = 0.1;

/// Steps of that length in which the boundary is looked for where they do not.
const STEPS: i32 = 20;

/// Halvings of a step: to a thousandth of a pixel.
const HALVINGS: u32 = 8;

/// Polygons, those around holes the other way around, with vertices moved across them, where rays
/// tell so, to where `is_hit` changes.
pub(super) fn polished(
    polygons: &[Vec<[f64; 2]>],
    is_hit: impl Fn([f64; 2]) -> bool + Sync,
) -> Vec<Vec<[f64; 2]>> {
    let sign = polygons.iter().map(|polygon| signed_area(polygon)).sum::<f64>().signum();
    let polish = |polygon: &Vec<[f64; 2]>| {
        let dense = dense(polygon);
        let count = dense.len();
        let settled = (0..count).into_par_iter().map(|i| {
            let [before, here, after] = [count - 1, 0, 1].map(|step| dense[(i + step) % count]);
            let inward = sign * inward(before, here, after)?;
            let at = |steps: f64| (here + steps * ASIDE * inward).into();
            is_off(&is_hit, at).then(|| change(&is_hit, at)).flatten().map(|place| (i, place))
        });
        let moved: Vec<(usize, [f64; 2])> = settled.flatten().collect();
        if moved.is_empty() { polygon.clone() } else { replaced(&dense, &moved) }
    };
    polygons.iter().map(polish).collect()
}

fn replaced(dense: &[Vector2<f64>], moved: &[(usize, [f64; 2])]) -> Vec<[f64; 2]> {
    let mut polygon: Vec<[f64; 2]> = dense.iter().map(|vertex| (*vertex).into()).collect();
    moved.iter().for_each(|(i, place)| polygon[*i] = *place);
    polygon
}

/// A closed polygon with vertices between its own.
fn dense(polygon: &[[f64; 2]]) -> Vec<Vector2<f64>> {
    let next = polygon.iter().cycle().skip(1);
    let sides = polygon.iter().zip(next).map(|(a, b)| [*a, *b].map(Vector2::from));
    let cut = |[a, b]: [Vector2<f64>; 2]| {
        let pieces = ((b - a).norm() / STEP).ceil().max(1.0) as u32;
        (0..pieces).map(move |i| a.lerp(&b, f64::from(i) / f64::from(pieces)))
    };
    sides.flat_map(cut).collect()
}

/// The direction halfway between the inward ones of the sides that meet in a vertex, of a polygon
/// whose area is positive.
fn inward(before: Vector2<f64>, here: Vector2<f64>, after: Vector2<f64>) -> Option<Vector2<f64>> {
    let across = |from: Vector2<f64>, to: Vector2<f64>| {
        let side = to - from;
        Vector2::new(-side.y, side.x).try_normalize(0.0)
    };
    let sides = [across(before, here), across(here, after)].into_iter().flatten();
    sides.sum::<Vector2<f64>>().try_normalize(1e-6)
}

fn is_off(is_hit: &impl Fn([f64; 2]) -> bool, at: impl Fn(f64) -> [f64; 2]) -> bool {
    !is_hit(at(1.0)) || is_hit(at(-1.0))
}

/// The nearest place at which rays begin to hit, going inwards; none if there is none near.
fn change(is_hit: &impl Fn([f64; 2]) -> bool, at: impl Fn(f64) -> [f64; 2]) -> Option<[f64; 2]> {
    let hits: Vec<bool> = (-STEPS..=STEPS).map(|step| is_hit(at(f64::from(step)))).collect();
    let begins = |step: &i32| {
        let i = (step + STEPS) as usize;
        !hits[i] && hits[i + 1]
    };
    let outer = (-STEPS..STEPS).filter(begins).min_by_key(|step| (2 * step + 1).abs())?;
    let (mut miss, mut hit) = (f64::from(outer), f64::from(outer + 1));
    for _ in 0..HALVINGS {
        let middle = 0.5 * (miss + hit);
        if is_hit(at(middle)) { hit = middle } else { miss = middle }
    }
    Some(at(0.5 * (miss + hit)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disc of radius 30, of whose polygon some vertices are half a pixel off.
    #[test]
    fn vertices_that_are_off_are_moved_onto_the_boundary() {
        let is_disc = |[u, v]: [f64; 2]| u.hypot(v) < 30.0;
        let vertex = |i: u32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 200.0).sin_cos();
            let radius =
                30.0 + [0.0, 0.6, -0.5][usize::from(i % 20 == 3) + usize::from(i % 30 == 3)];
            [radius * cos, radius * sin]
        };
        let polygon: Vec<[f64; 2]> = (0..200).map(vertex).collect();
        let off = |polygon: &[[f64; 2]]| {
            polygon.iter().map(|[u, v]| (u.hypot(*v) - 30.0).abs()).fold(0.0, f64::max)
        };
        assert!(off(&polygon) >= 0.5);
        let [polished] = &polished(&[polygon], is_disc)[..] else { panic!("one polygon") };
        assert!(off(polished) <= 1.5 * ASIDE, "{}", off(polished));
    }

    #[test]
    fn what_is_right_or_too_thin_to_tell_is_left() {
        let square = vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
        let is_square = |pixel: [f64; 2]| pixel.iter().all(|x| (0.0..=9.0).contains(x));
        let squares = [square];
        assert_eq!(polished(&squares, is_square), squares);
        assert_eq!(polished(&squares, |_| false), squares);
    }
}
