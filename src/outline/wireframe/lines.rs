//! Lines on the surface of a shape of any family, as curves over [0, 1].

use nalgebra::Vector3;

use crate::shape::{
    Shape, Solid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
    superellipse_norm,
};
use crate::surface::{flattened_cube_point, within_rim};

/// Where lines stand on the sides of the cube, or the square, that they are taken from.
const PLACES: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];

/// Lines around a tube, and along it.
const AROUND: u32 = 16;
const ALONG: u32 = 8;

/// A line on a surface, in the shape's frame: its point at a place from 0 to 1.
pub(super) type Line = Box<dyn Fn(f64) -> Vector3<f64> + Send + Sync>;

/// The lines of a grid: of solids around their centre that of a cube of the semi-axes, projected
/// from the centre, on a box parallels of its edges, on a ball great circles; of towers that of a
/// cube between their caps, of bowls that of a square, of tubes lines around and along them.
pub(super) fn surface_lines(shape: &Shape) -> Vec<Line> {
    match *shape {
        Shape::Superellipsoid(shape) => {
            let size = Vector3::from(shape.size());
            cube_lines(move |x| shape.radial_projection(&x.component_mul(&size)))
        }
        Shape::ThreeExponent(shape) => {
            let size = Vector3::from(shape.size());
            cube_lines(move |x| {
                let x = x.component_mul(&size);
                x * (1.0 - shape.radial_distance(&x) / x.norm())
            })
        }
        Shape::SuperhyperboloidOneSheet(tower) => cube_lines(move |x| on_tower(&tower, x)),
        Shape::SuperhyperboloidTwoSheets(bowls) => bowl_lines(bowls),
        Shape::Supertoroid(torus) => torus_lines(torus),
    }
}

/// Straight lines on the cube `max |x| = 1` along its axes, mapped to a surface.
fn cube_lines(
    map: impl Fn(Vector3<f64>) -> Vector3<f64> + Clone + Send + Sync + 'static,
) -> Vec<Line> {
    let is_on_cube = |across: &[f64; 2]| across[0].abs().max(across[1].abs()) == 1.0;
    let places = PLACES.into_iter().flat_map(|p| PLACES.map(|q| [p, q])).filter(is_on_cube);
    let line = |[p, q]: [f64; 2], axis: usize| -> Line {
        let map = map.clone();
        Box::new(move |t| {
            let mut x = Vector3::zeros();
            x[axis] = 2.0 * t - 1.0;
            x[(axis + 1) % 3] = p;
            x[(axis + 2) % 3] = q;
            map(x)
        })
    };
    places.flat_map(|across| [0, 1, 2].map(|axis| line(across, axis))).collect()
}

/// The point of a tower, its caps included, for one of a cube.
fn on_tower(tower: &SuperhyperboloidOneSheet, x: Vector3<f64>) -> Vector3<f64> {
    let [_, e2] = tower.exponents();
    let level = flattened_cube_point([x.x, x.y, 0.0], e2);
    let height = tower.top() * x.z;
    let unit = level * tower.radius(height.abs()) + Vector3::new(0.0, 0.0, height);
    unit.component_mul(&Vector3::from(tower.size()))
}

/// Lines of a square's grid on both bowls and their caps.
fn bowl_lines(bowls: SuperhyperboloidTwoSheets) -> Vec<Line> {
    let size = Vector3::from(bowls.size());
    let line = |side: f64, is_cap: bool, place: f64, axis: usize| -> Line {
        Box::new(move |t| {
            let mut square = [2.0 * t - 1.0; 2];
            square[axis] = place;
            let [v, w] = within_rim(&bowls, square);
            let u = if is_cap { bowls.top() } else { bowls.height(v.abs(), w.abs()) };
            Vector3::new(side * u, v, w).component_mul(&size)
        })
    };
    let faces = [(1.0, false), (1.0, true), (-1.0, false), (-1.0, true)];
    let on_face = |(side, is_cap)| {
        PLACES.into_iter().flat_map(move |place| [0, 1].map(|axis| line(side, is_cap, place, axis)))
    };
    faces.into_iter().flat_map(on_face).collect()
}

/// Lines around a tube and along it.
fn torus_lines(torus: Supertoroid) -> Vec<Line> {
    let size = Vector3::from(torus.size());
    let [e1, e2] = torus.exponents();
    let at = move |around: f64, along: f64| {
        let [across, up] = superellipse_point(around, e1);
        let [x, y] = superellipse_point(along, e2);
        let radius = torus.ring() + across;
        Vector3::new(radius * x, radius * y, up).component_mul(&size)
    };
    let places = |count: u32| (0..count).map(move |i| f64::from(i) / f64::from(count));
    let around = places(AROUND).map(|along| -> Line { Box::new(move |t| at(t, along)) });
    let along = places(ALONG).map(|around| -> Line { Box::new(move |t| at(around, t)) });
    around.chain(along).collect()
}

/// The point of the unit superellipse on the ray through that of a square, `turn` times around.
fn superellipse_point(turn: f64, e: f64) -> [f64; 2] {
    let side = 4.0 * (turn + 0.125).rem_euclid(1.0);
    let t = 2.0 * side.fract() - 1.0;
    let [x, y] = match side as u32 {
        0 => [1.0, t],
        1 => [-t, 1.0],
        2 => [-1.0, -t],
        _ => [t, -1.0],
    };
    let norm = superellipse_norm(x.abs(), y.abs(), e);
    [x / norm, y / norm]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{LevelSet, Superellipsoid, ThreeExponent};

    #[test]
    fn lines_are_on_the_surface_of_every_family() {
        let size = [1.2, 0.8, 0.5];
        let shapes: [Shape; 5] = [
            Superellipsoid::new(size, [0.3, 1.4]).unwrap().into(),
            ThreeExponent::new(size, [0.8, 3.0, 2.0]).unwrap().into(),
            SuperhyperboloidOneSheet::new(size, [0.6, 0.4], 0.9).unwrap().into(),
            SuperhyperboloidTwoSheets::new(size, [0.7, 1.3], 2.5).unwrap().into(),
            Supertoroid::new(size, [0.5, 1.5], 2.0).unwrap().into(),
        ];
        for shape in shapes {
            let lines = surface_lines(&shape);
            assert!(lines.len() >= 24);
            for place in (0..=20).map(|i| f64::from(i) / 20.0) {
                for line in &lines {
                    let level = shape.level(line(place).into());
                    assert!((level - 1.0).abs() < 1e-12, "{level} at {place} of {shape:?}");
                }
            }
        }
    }
}
