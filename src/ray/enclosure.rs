//! A cell's deformed image, and its level, as linear functions with bounded errors.

use nalgebra::{Matrix3, Vector3};

use super::cage::Stretch;
use super::half_line::Ray;
use crate::deform::{Chain, Deform};
use crate::math::{Dual, Interval};
use crate::shape::LevelSet;

/// Share of its size by which a cell's image is widened: for rounding.
const ROUNDING: f64 = 1e-9;

/// Share of a level by which it is rounded.
const LEVEL_ROUNDING: f64 = 1e-13;

/// Share of a ray's t by which it may be off.
const ROUNDING_OF_T: f64 = 8.0 * f64::EPSILON;

/// The slopes of three functions along each axis, over a box: a column an axis.
pub(super) type Columns = [[Interval; 3]; 3];

/// The slopes of a map over a box.
pub(super) fn slopes_of(sides: [Interval; 3], map: impl Fn([Dual; 3]) -> [Dual; 3]) -> Columns {
    [0, 1, 2].map(|axis| map(Dual::along(axis, sides)).map(|component| component.slope))
}

/// The deformed image of a cell: a parallelepiped that holds it.
///
/// A point X of the image is undeformed to within `reach` of the cell's middle, along each axis,
/// as `inverse (X - middle)` tells.
#[derive(Debug, Clone, Copy)]
pub(super) struct Image {
    middle: Vector3<f64>,
    inverse: Matrix3<f64>,
    /// By how much a point so undeformed may be off along each axis, a column for each side that
    /// this is due to.
    blur: Matrix3<f64>,
    reach: Vector3<f64>,
    /// Half of the box around the image.
    half: Vector3<f64>,
}

impl Image {
    /// The image of a cell, by the mean value theorem from its middle; none, if the deformation
    /// is not known to be about linear.
    pub fn of(chain: &Chain, sides: [Interval; 3], jacobian: &Columns) -> Option<Self> {
        let half = Vector3::from(sides.map(|side| 0.5 * side.width()));
        let middle = chain.forward_of(sides.map(|side| Interval::point(side.middle())));
        let linear = Matrix3::from_fn(|i, j| jacobian[j][i].middle());
        let spread = Matrix3::from_fn(|i, j| radius(jacobian[j][i]));
        let inverse = linear.try_inverse()?;
        let error = spread * half + Vector3::from(middle.map(Interval::width));
        let blur = inverse.abs() * spread * Matrix3::from_diagonal(&half);
        let image = Self {
            middle: middle.map(Interval::middle).into(),
            inverse,
            blur,
            reach: (half + inverse.abs() * error) * (1.0 + ROUNDING),
            half: (linear.abs() * half + error) * (1.0 + ROUNDING),
        };
        let is_bounded = |v: &Vector3<f64>| v.iter().all(|x| x.is_finite());
        let is_known = is_bounded(&image.reach) && is_bounded(&image.half);
        (is_known && is_bounded(&image.middle)).then_some(image)
    }

    /// That of which nothing is known.
    fn unbounded() -> Self {
        let unbounded = Vector3::from_element(f64::INFINITY);
        let blur = Matrix3::from_element(f64::INFINITY);
        let (middle, inverse) = (Vector3::zeros(), Matrix3::zeros());
        Self { middle, inverse, blur, reach: unbounded, half: unbounded }
    }

    /// A box around it, `[min, max]`.
    pub fn bounds(&self) -> [Vector3<f64>; 2] {
        [self.middle - self.half, self.middle + self.half]
    }

    /// What of a ray's range lies in the parallelepiped.
    pub fn clipped(&self, ray: &Ray, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
        let start = self.inverse * (ray.origin - self.middle);
        let direction = self.inverse * ray.direction;
        let (mut from, mut to) = (from, to);
        for i in 0..3 {
            let is_parallel = direction[i] == 0.0;
            if is_parallel {
                if start[i].abs() > self.reach[i] {
                    return None;
                }
                continue;
            }
            let inverse = direction[i].recip();
            let (middle, half) = (-start[i] * inverse, self.reach[i] * inverse.abs());
            let slack = half + ROUNDING_OF_T * middle.abs();
            from = from.max(middle - slack);
            to = to.min(middle + slack);
        }
        (from <= to).then_some([from, to])
    }
}

/// A linear function of the deformed point that a level differs from by a bounded error
/// throughout a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tangent {
    /// The cell's deformed middle.
    middle: Vector3<f64>,
    /// The level less 1 there.
    excess: f64,
    gradient: Vector3<f64>,
    error: f64,
    errors: Vector3<f64>,
    change: f64,
    normal: Option<Normals>,
}

/// The normals of level surfaces throughout a cell, of any length.
#[derive(Debug, Clone, Copy)]
struct Normals {
    middle: Vector3<f64>,
    spread: Vector3<f64>,
}

impl Tangent {
    /// That of a shape's level in a cell; the deformation's slopes, where they are known to be
    /// those of a map that does not fold, tell of normals.
    pub fn of(
        shape: &impl LevelSet,
        sides: [Interval; 3],
        image: Option<&Image>,
        jacobian: Option<&Columns>,
    ) -> Self {
        let slopes = [0, 1, 2].map(|axis| shape.level(Dual::along(axis, sides)).slope);
        let half = Vector3::from(sides.map(|side| 0.5 * side.width()));
        let excess = shape.level(sides.map(|side| Interval::point(side.middle()))) + -1.0;
        let gradient = Vector3::from(slopes.map(Interval::middle));
        let spread = Vector3::from(slopes.map(radius));
        let unknown = Image::unbounded();
        let image = image.unwrap_or(&unknown);
        let errors = spread.component_mul(&half) + image.blur.tr_mul(&gradient.abs());
        let change = gradient.abs().dot(&half);
        let rounding = excess.width() + LEVEL_ROUNDING * (1.0 + excess.middle().abs() + change);
        Self {
            middle: image.middle,
            excess: excess.middle(),
            gradient: image.inverse.tr_mul(&gradient),
            error: spread.dot(&half) + gradient.abs().dot(&(image.reach - half)) + rounding,
            errors,
            change,
            normal: jacobian.and_then(|jacobian| Normals::of(&slopes, jacobian)),
        }
    }

    /// Whether the level is nowhere 1.
    pub fn is_apart(&self) -> bool {
        self.excess.abs() > self.change + self.error
    }

    /// How much of the error is due to each side of the cell, if it has a bound.
    pub fn errors(&self) -> Option<[f64; 3]> {
        self.error.is_finite().then_some(self.errors.into())
    }

    /// How much the function changes from the middle to the cell's end.
    pub fn change(&self) -> f64 {
        self.change
    }

    /// What of a ray's range in the cell may cross the surface, if anything.
    pub fn stretch(&self, ray: &Ray, [from, to]: [f64; 2]) -> Option<Stretch> {
        let outwards = self.normal.as_ref().and_then(|normal| normal.faces(&ray.direction));
        let slope = self.gradient.dot(&ray.direction);
        let start = self.excess + self.gradient.dot(&(ray.origin - self.middle));
        let (expected, half) = (-start / slope, self.error / slope.abs());
        let slack = half + ROUNDING_OF_T * (expected.abs() + to);
        let is_told = slope != 0.0 && slack.is_finite();
        let range = match is_told {
            true => [from.max(expected - slack), to.min(expected + slack)],
            false => [from, to],
        };
        (range[0] <= range[1]).then_some(Stretch { range, outwards })
    }
}

impl Normals {
    /// The cofactors of the deformation's Jacobian times the level's gradient (B84 appendix A).
    fn of(slopes: &[Interval; 3], jacobian: &Columns) -> Option<Self> {
        let faces = [0, 1, 2].map(|j| cross(&jacobian[(j + 1) % 3], &jacobian[(j + 2) % 3]));
        let sums: [Interval; 3] = std::array::from_fn(|i| {
            let terms = (0..3).map(|j| faces[j][i] * slopes[j]);
            terms.fold(Interval::ZERO, |sum, term| sum + term)
        });
        let middle = Vector3::from(sums.map(Interval::middle));
        let spread = Vector3::from(sums.map(radius)) * (1.0 + ROUNDING);
        spread.iter().all(|x| x.is_finite()).then_some(Self { middle, spread })
    }

    /// Whether all of them face along a direction, or all against it.
    fn faces(&self, direction: &Vector3<f64>) -> Option<bool> {
        let along = self.middle.dot(direction);
        let is_certain = along.abs() > self.spread.dot(&direction.abs()) * (1.0 + ROUNDING);
        is_certain.then_some(along > 0.0)
    }
}

/// How far an interval's ends may be from its middle.
fn radius(interval: Interval) -> f64 {
    let middle = interval.middle();
    (interval.hi() - middle).max(middle - interval.lo()).next_up()
}

fn cross(a: &[Interval; 3], b: &[Interval; 3]) -> [Interval; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
