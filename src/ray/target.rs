//! A solid that rays are shot at.

use nalgebra::Vector3;

use super::half_line::Ray;
use super::hits::Crossings;
use crate::math::Dual;
use crate::shape::LevelSet;

/// Share of a box's size by which it is widened: what touches it is inside.
const MARGIN: f64 = 1e-9;

/// Where a ray meets a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// The ray's parameter.
    pub t: f64,
    /// The point.
    pub position: Vector3<f64>,
    /// The outward unit normal there.
    pub normal: Vector3<f64>,
}

/// A solid and a box around it.
///
/// No crossing of a ray is missed, however thin the part; shapes of exponents from 0.1 are
/// tested against dense sampling.
#[derive(Debug, Clone)]
pub struct Target<S> {
    solid: S,
    bounds: [Vector3<f64>; 2],
}

impl<S: LevelSet> Target<S> {
    /// A solid, and a box `[min, max]` that holds it.
    pub fn new(solid: S, bounds: [Vector3<f64>; 2]) -> Self {
        Self { solid, bounds: widened(bounds) }
    }

    /// The solid.
    pub fn solid(&self) -> &S {
        &self.solid
    }

    fn crossings(&self, ray: &Ray) -> Option<Crossings<'_, S>> {
        Some(Crossings::new(&self.solid, *ray, ray.clipped(&self.bounds)?))
    }
}

/// What rays can hit.
pub trait Hittable {
    /// The first hit of a ray, from its origin on.
    fn first_hit(&self, ray: &Ray) -> Option<Hit>;

    /// All hits of a ray, in their order.
    fn all_hits(&self, ray: &Ray) -> Vec<Hit>;
}

impl<S: LevelSet> Hittable for Target<S> {
    fn first_hit(&self, ray: &Ray) -> Option<Hit> {
        self.crossings(ray)?.next().map(|t| Hit::of(&self.solid, ray, t))
    }

    fn all_hits(&self, ray: &Ray) -> Vec<Hit> {
        let crossings = self.crossings(ray).into_iter().flatten();
        crossings.map(|t| Hit::of(&self.solid, ray, t)).collect()
    }
}

impl Hit {
    fn of(solid: &impl LevelSet, ray: &Ray, t: f64) -> Self {
        let position = ray.at(t);
        Self { t, position, normal: outward_normal(solid, &position) }
    }
}

/// A box, widened by so little that what touches it is inside.
pub(super) fn widened([min, max]: [Vector3<f64>; 2]) -> [Vector3<f64>; 2] {
    let margin = (max - min) * MARGIN;
    [min - margin, max + margin]
}

/// The outward unit normal at a point of the surface: the gradient of the level. On an edge one
/// between those of its sides.
pub(crate) fn outward_normal(solid: &impl LevelSet, x: &Vector3<f64>) -> Vector3<f64> {
    let gradient = Vector3::from_fn(|axis, _| solid.level(Dual::along(axis, (*x).into())).slope);
    // Slopes without bound, at edges of exponents above 2, count as far as numbers go.
    let bounded = gradient.map(|part| if part.is_nan() { 0.0 } else { part.clamp(-1e150, 1e150) });
    bounded.try_normalize(0.0).unwrap_or_else(Vector3::z)
}
