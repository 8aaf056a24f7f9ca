//! Meshes of every family: closed, outwards, of the right genus, and as good as their resolution.

use std::collections::HashSet;

use super::*;
use crate::shape::{
    Solid, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
    ThreeExponent,
};

const EXPONENTS: [f64; 5] = [0.1, 0.5, 1.0, 1.5, 2.0];

/// Every family, with the Euler characteristic of its boundary.
pub(in crate::surface) fn examples() -> impl Iterator<Item = (Shape, i64)> {
    let size = [2.0, 0.7, 1.3];
    EXPONENTS.into_iter().flat_map(move |e1| {
        EXPONENTS.into_iter().flat_map(move |e2| {
            let e = [e1, e2];
            let n = [2.0 / e1, 2.0 / e2, 1.0 / e1 + 1.0 / e2];
            [
                (Superellipsoid::new(size, e).unwrap().into(), 2),
                (SuperhyperboloidOneSheet::new(size, e, 2.2).unwrap().into(), 2),
                (SuperhyperboloidTwoSheets::new(size, e, 3.5).unwrap().into(), 4),
                (Supertoroid::new(size, e, 1.6).unwrap().into(), 0),
                (ThreeExponent::new(size, n).unwrap().into(), 2),
            ]
        })
    })
}

#[test]
fn meshes_are_closed_and_of_the_boundarys_genus() {
    let mut count = 0;
    for (shape, expected) in examples() {
        let mesh = tessellate_shape(&shape, Resolution::new(8).unwrap());
        assert!(mesh.is_closed(), "{shape:?}");
        let edges: HashSet<[u32; 2]> = mesh
            .triangles()
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let used: HashSet<u32> = mesh.triangles().iter().flatten().copied().collect();
        assert_eq!(used.len(), mesh.vertices().len());
        let characteristic = used.len() as i64 - edges.len() as i64 + mesh.triangles().len() as i64;
        assert_eq!(characteristic, expected, "{shape:?}");
        count += 1;
    }
    assert_eq!(count, 125);
}

#[test]
fn vertices_are_on_the_boundary() {
    for (shape, _) in examples() {
        let mesh = tessellate_shape(&shape, Resolution::new(8).unwrap());
        for x in mesh.vertices() {
            let [within, beyond] = [x * (1.0 - 1e-9), x * (1.0 + 1e-9)];
            let clip = match shape {
                Shape::SuperhyperboloidOneSheet(tower) => tower.clip() - x.z.abs(),
                Shape::SuperhyperboloidTwoSheets(bowls) => bowls.clip() - x.x.abs(),
                _ => f64::INFINITY,
            };
            let is_on_surface = (shape.inside_outside(x) - 1.0).abs()
                < 1e-12 + 1e-13 * shape.inside_outside_gradient(x).component_mul(x).abs().sum();
            let is_on_cap = clip.abs() < 1e-12 && !shape.contains(&beyond);
            assert!(is_on_surface || is_on_cap, "{shape:?} {x} {within}");
        }
    }
}

#[test]
fn volume_and_area_come_near_those_of_the_solid() {
    for (shape, _) in examples() {
        let mesh = tessellate_shape(&shape, Resolution::new(64).unwrap());
        let [volume, area] = [mesh.volume() / shape.volume(), mesh.area() / shape.surface_area()];
        // Chords fall short by the square of their length, at edges of small exponents by more.
        assert!((volume - 1.0).abs() < 1e-2, "{shape:?} {volume}");
        assert!((area - 1.0).abs() < 1e-2, "{shape:?} {area}");
    }
}
