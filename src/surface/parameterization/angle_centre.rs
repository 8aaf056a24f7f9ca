//! Equal steps of the angle of a ray from the centre (JLS Eqs. 2.71, 2.72).

use std::f64::consts::FRAC_PI_2;

use nalgebra::{Vector2, Vector3};

use crate::shape::superellipse_norm;

/// Points from `(a, 0)` to `(0, b)`.
pub(super) fn quarter([a, b]: [f64; 2], e: f64, n: usize) -> Vec<[f64; 2]> {
    let point = |i: usize| {
        let [cos, sin]: [f64; 2] = direction(i, n).into();
        let radius = superellipse_norm(cos / a, sin / b, e).recip();
        [radius * cos, radius * sin]
    };
    (0..=n).map(point).collect()
}

/// The rows of a surface: points on rays of equal steps of latitude and of longitude.
pub(super) fn rows(
    n: usize,
    on_ray: impl Fn(&Vector3<f64>) -> Vector3<f64>,
) -> Vec<Vec<Vector3<f64>>> {
    let quarter: Vec<[f64; 2]> = (0..=n).map(|i| direction(i, n).into()).collect();
    let south = quarter.iter().skip(1).rev().map(|&[cos, sin]| [cos, -sin]);
    let row = |[cos_eta, sin_eta]: [f64; 2]| {
        super::around(&quarter)
            .map(|[x, y]| Vector3::new(cos_eta * x, cos_eta * y, sin_eta))
            .map(|ray| on_ray(&ray))
            .collect()
    };
    south.chain(quarter.iter().copied()).map(row).collect()
}

/// The unit vector at step i of n of the first quadrant, with both ends on their axes.
fn direction(i: usize, n: usize) -> Vector2<f64> {
    let j = n - i;
    let angle = |step: usize| FRAC_PI_2 * step as f64 / n as f64;
    let (sin, cos) = angle(i.min(j)).sin_cos();
    if i < j { Vector2::new(cos, sin) } else { Vector2::new(sin, cos) }
}
