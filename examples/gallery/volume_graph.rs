//! JLS Fig. 2.12: the volume of a superellipsoid over that of its box, by both exponents.

use superquadric::shape::Superellipsoid;

use crate::picture::{INK, PALE, Panel, Picture, Rgb};

const SIDE: usize = 420;

/// Meshes of the graph along each exponent, and the least exponent drawn in place of 0.
const STEPS: usize = 20;
const LEAST: f64 = 1e-6;

/// The graph over 0..2 squared, seen from above the corner (2, 2); e1 runs to the lower left.
pub fn volume_ratio() -> Picture {
    let mut picture = Picture::new(SIDE as u32, SIDE as u32);
    let panel = Panel { corner: [0, 0], side: SIDE };
    for corners in [[[0.0, 2.0], [0.0, 0.0]], [[0.0, 0.0], [2.0, 0.0]]] {
        let [from, to] = corners.map(|[e1, e2]| project([e1, e2, 0.0]));
        picture.line(&panel.places(&[from, to]), 1.0, PALE);
    }
    let base = [[2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[e1, e2]| project([e1, e2, 0.0]));
    let posts = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    for [e1, e2] in posts {
        let post = [[e1, e2, 0.0], [e1, e2, ratio([e1, e2])]].map(project);
        picture.line(&panel.places(&post), 1.0, PALE);
    }
    // From the far corner on, so that what is near covers what is behind.
    for far in 0..2 * STEPS - 1 {
        let first = far.saturating_sub(STEPS - 1);
        for i in first..=far.min(STEPS - 1) {
            draw_mesh(&mut picture, &panel, [i, far - i]);
        }
    }
    picture.line(&panel.places(&base), 1.0, INK);
    picture
}

fn draw_mesh(picture: &mut Picture, panel: &Panel, [i, j]: [usize; 2]) {
    let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]
        .map(|corner| corner.map(|step| 2.0 * step as f64 / STEPS as f64))
        .map(|[e1, e2]| [e1, e2, ratio([e1, e2])]);
    let height = corners.iter().map(|[_, _, z]| z / 4.0).sum::<f64>();
    let mut places = panel.places(&corners.map(project));
    picture.polygon(&places, tint(height));
    places.push(places[0]);
    picture.line(&places, 0.7, INK);
}

/// The ratio of the volumes.
fn ratio(exponents: [f64; 2]) -> f64 {
    let exponents = exponents.map(|e| e.max(LEAST));
    Superellipsoid::new([1.0; 3], exponents).expect("a valid shape").volume() / 8.0
}

/// Parallel projection of `(e1, e2, ratio)` into the panel.
fn project([e1, e2, z]: [f64; 3]) -> [f64; 2] {
    [0.45 * (e2 - e1), -0.22 * (e1 + e2) + 0.95 * z - 0.03]
}

/// From blue where the ratio is 0 to sand where it is 1.
fn tint(height: f64) -> Rgb {
    let mix = |low: f64, high: f64| (low + (high - low) * height).round() as u8;
    [mix(90.0, 245.0), mix(140.0, 225.0), mix(200.0, 180.0)]
}
