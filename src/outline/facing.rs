//! Which way a surface faces a camera.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use nalgebra::Vector3;

use crate::math::increasing_root;
use crate::ray::outward_normal;
use crate::shape::LevelSet;
use crate::view::Viewpoint;

/// Halvings of a step that looks for the surface, at most.
const FINEST: i32 = 12;

/// How far to either side of a chord the rim is looked for, in chords.
const ASIDE: [f64; 4] = [1.0 / 32.0, 1.0 / 8.0, 0.5, 1.0];

/// Turns about a chord, in radians, of the direction in which the surface is looked for beside it:
/// on edges the normal may be that of either side, or none between.
const TURNS: [f64; 5] = [0.0, FRAC_PI_4, -FRAC_PI_4, FRAC_PI_2, -FRAC_PI_2];

/// How far from 1 the level is at points of the surface.
const ON_SURFACE: f64 = 1e-6;

/// Chords from its middle to the rim, at most: what is further off is another part of it.
const REACH: f64 = 0.75;

/// A surface and where it is seen from, both in one frame.
pub(super) struct Facing<'a, S> {
    pub solid: &'a S,
    pub viewpoint: Viewpoint,
}

impl<S: LevelSet> Facing<'_, S> {
    /// `(x - c) . n(x)` or `v . n(x)` (JLS Eqs. 2.44, 2.45): negative where the surface faces the
    /// camera, 0 on the rim.
    pub fn away(&self, x: &Vector3<f64>) -> f64 {
        let normal = outward_normal(self.solid, x);
        match self.viewpoint {
            Viewpoint::At(centre) => (x - centre).dot(&normal),
            Viewpoint::Along(direction) => direction.dot(&normal),
        }
    }

    /// The point of the rim between a surface point that faces the camera and one that does not.
    /// Where an edge lies between them, a point of the edge; at a blade, if no point of the surface
    /// is found there, one within it.
    pub fn crossing(&self, [front, back]: [Vector3<f64>; 2]) -> Vector3<f64> {
        let chord = back - front;
        let reach = chord.norm();
        let sum = outward_normal(self.solid, &front) + outward_normal(self.solid, &back);
        let across = sum - chord * (sum.dot(&chord) / chord.norm_squared());
        let Some(outward) = across.try_normalize(0.0) else { return front };
        let surface = |share: f64| {
            let x = front + share * chord;
            self.on_surface(x, reach * outward).unwrap_or(x)
        };
        surface(increasing_root(|share| self.away(&surface(share)), [0.0, 1.0]))
    }

    /// The point of the rim beside a place on the chord between two points of it, if it is found.
    ///
    /// What faces the camera is to the left of the chord, as seen from outside.
    pub fn beside(&self, [a, b]: [Vector3<f64>; 2], share: f64) -> Option<Vector3<f64>> {
        let chord = b - a;
        let length = chord.norm();
        let sum = outward_normal(self.solid, &a) + outward_normal(self.solid, &b);
        let left = length * sum.cross(&chord).try_normalize(0.0)?;
        let outward = chord.cross(&left).normalize() * length;
        let place = a + share * chord;
        TURNS.into_iter().find_map(|turn| {
            let (sin, cos) = turn.sin_cos();
            let (left, outward) = (cos * left + sin * outward, cos * outward - sin * left);
            let x = self.across(&place, &left, outward)?;
            ((x - place).norm() <= REACH * length).then_some(x)
        })
    }

    /// The point of the rim near a place, between surface points to its left and its right.
    fn across(
        &self,
        place: &Vector3<f64>,
        left: &Vector3<f64>,
        outward: Vector3<f64>,
    ) -> Option<Vector3<f64>> {
        let surface = |aside: f64| self.on_surface(place + aside * left, outward);
        ASIDE.into_iter().find_map(|aside| {
            let [front, back] = [surface(aside)?, surface(-aside)?];
            let is_between = self.away(&front) < 0.0 && self.away(&back) >= 0.0;
            let x = is_between.then(|| self.crossing([front, back]))?;
            ((self.solid.level(x.into()) - 1.0).abs() < ON_SURFACE).then_some(x)
        })
    }

    /// The surface point nearest to x along a line that leads outwards, at most a step away; none
    /// if there is none.
    fn on_surface(&self, x: Vector3<f64>, step: Vector3<f64>) -> Option<Vector3<f64>> {
        let above = |t: f64| self.solid.level((x + t * step).into()) - 1.0;
        // Through a thin blade a whole step leads out again on its other side.
        let towards = if above(0.0) > 0.0 { -1.0 } else { 1.0 };
        let reaches = (0..=FINEST).rev().map(|halvings| towards * 0.5_f64.powi(halvings));
        let beyond = |t: &f64| above(*t) * towards > 0.0;
        let reach = reaches.into_iter().find(beyond)?;
        Some(x + increasing_root(above, [reach.min(0.0), reach.max(0.0)]) * step)
    }
}
