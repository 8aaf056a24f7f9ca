//! Shaded solids: B81 Fig. 7, JLS Figs. 2.5 and 2.13.

use superquadric::shape::Superellipsoid;

use crate::picture::{Panel, Picture};
use crate::shading::{self, View};

const CLAY: [f64; 3] = [0.85, 0.55, 0.35];
const STEEL: [f64; 3] = [0.45, 0.60, 0.80];

/// Lengths that half a panel stands for: a cube's corner is sqrt(3) off.
const HALF_WIDTH: f64 = 1.75;

/// JLS Fig. 2.5: exponents 0.1, 1 and 2; e1 from top to bottom, e2 from left to right.
pub fn nine_superellipsoids() -> Picture {
    squared(&[0.1, 1.0, 2.0], |exponents| Superellipsoid::new([0.8, 1.0, 1.2], exponents))
}

/// B81 Fig. 7: superellipsoids of five exponents squared.
pub fn superellipsoids() -> Picture {
    squared(&[0.1, 0.5, 1.0, 2.0, 3.0], |exponents| Superellipsoid::new([1.0; 3], exponents))
}

/// JLS Fig. 2.13: a model with Phong's shading and three lights.
pub fn phong() -> Picture {
    let mut picture = Picture::new(320, 320);
    let shape = Superellipsoid::new([1.0, 1.2, 0.9], [0.3, 0.6]).expect("a valid shape");
    let panel = Panel { corner: [0, 0], side: 320 };
    draw(&mut picture, &panel, &shape, STEEL);
    picture
}

/// A shape for each pair of exponents: e1 from top to bottom, e2 from left to right.
fn squared<E: std::fmt::Debug>(
    exponents: &[f64],
    shape: impl Fn([f64; 2]) -> Result<Superellipsoid, E>,
) -> Picture {
    const SIDE: usize = 120;
    let count = exponents.len();
    let mut picture = Picture::new((SIDE * count) as u32, (SIDE * count) as u32);
    let pairs = exponents.iter().flat_map(|&e1| exponents.iter().map(move |&e2| [e1, e2]));
    for (panel, pair) in Panel::grid(count, count, SIDE).iter().zip(pairs) {
        draw(&mut picture, panel, &shape(pair).expect("a valid shape"), CLAY);
    }
    picture
}

fn draw(picture: &mut Picture, panel: &Panel, shape: &Superellipsoid, color: [f64; 3]) {
    let camera_from_model = shading::from_above();
    shading::draw(
        picture,
        panel,
        &View { shape, camera_from_model, half_width: HALF_WIDTH, color },
    );
}
