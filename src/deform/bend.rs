//! Bend along the y axis (B84 section 2.4).

use std::f64::consts::{PI, TAU};

use nalgebra::{Matrix3, Vector3};

use super::error::{DeformError, finite};
use super::map::Deform;
use crate::math::{Interval, Scalar};

/// Share of a bend's angle by which ends may pass each other: points that are written to meet
/// do so up to rounding.
const MEETING_TOLERANCE: f64 = 1e-9;

/// The isotropic bend by `k` radians per unit of length between `y_min` and `y_max`, about the
/// axis `(s, y0, 1/k)` parallel to x (B84 Eq. 2.4a).
///
/// The centre line `z = 0` keeps its length; beyond `y_min` and `y_max` the object moves
/// rigidly. Domain: `1 - k z > 0` in the bent region, and of the rigid ends what lies within the
/// half of the remaining angle on its own side, so that they do not meet. B84's inverse, as
/// printed, holds for `k < 0` and within 90 degrees only; this one holds throughout the domain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    rate: f64,
    center: f64,
    range: [f64; 2],
}

impl Bend {
    /// The bend of rate k (radians per unit of length; of either sign, or 0), center y0 and
    /// range `[y_min, y_max]`.
    ///
    /// # Errors
    /// If one of them is not finite, the range does not ascend, or the bend makes more than one
    /// turn.
    pub fn new(rate: f64, center: f64, range: [f64; 2]) -> Result<Self, DeformError> {
        let [y_min, y_max] = range;
        for (what, value) in [("k", rate), ("y0", center), ("y_min", y_min), ("y_max", y_max)] {
            finite(what, value)?;
        }
        if y_min >= y_max {
            let (what, expected) = ("y_max", "greater than y_min");
            return Err(DeformError::Parameter { what, expected, found: y_max });
        }
        let bend = Self { rate, center, range };
        if bend.angle() > TAU * (1.0 + MEETING_TOLERANCE) {
            let (what, expected) = ("k (y_max - y_min)", "at most a whole turn, 2 pi");
            return Err(DeformError::Parameter { what, expected, found: bend.angle() });
        }
        Ok(bend)
    }

    /// The rate k in radians per unit of length.
    pub fn rate(&self) -> f64 {
        self.rate
    }

    /// The position y0 that stays where it is.
    pub fn center(&self) -> f64 {
        self.center
    }

    /// The bent region `[y_min, y_max]`.
    pub fn range(&self) -> [f64; 2] {
        self.range
    }

    /// The whole angle of the bend, in radians, without sign.
    pub fn angle(&self) -> f64 {
        self.rate.abs() * (self.range[1] - self.range[0])
    }

    /// The bending angle at `y` (B84's theta), its sine and cosine.
    fn turn(&self, y: f64) -> (f64, f64) {
        let [y_min, y_max] = self.range;
        (self.rate * (y.clamp(y_min, y_max) - self.center)).sin_cos()
    }

    /// B84's `1 - k^ z`, in which the rate is 0 beyond the bent region.
    fn stretch(&self, x: &Vector3<f64>) -> f64 {
        let [y_min, y_max] = self.range;
        if y_min <= x.y && x.y <= y_max { 1.0 - self.rate * x.z } else { 1.0 }
    }

    /// `sin(theta) / k` and `(1 - cos(theta)) / k`, which do not cancel for small k. Domain: a
    /// rate that is not 0.
    fn arc<S: Scalar>(&self, theta: S) -> [S; 2] {
        let radius = self.rate.recip();
        let (half_sin, half_cos) = (theta * 0.5).sin_cos();
        [half_sin * half_cos * (2.0 * radius), half_sin * half_sin * (2.0 * radius)]
    }

    /// The middle of the bent region as an angle.
    fn middle(&self) -> f64 {
        let [y_min, y_max] = self.range;
        self.rate * (0.5 * (y_min + y_max) - self.center)
    }

    /// A point of the bent space about the bend's axis: its angle from the middle of the region,
    /// where the two rigid ends part at the opposite angle, and its distance, in radii.
    fn polar<S: Scalar>(&self, y: S, z: S) -> [S; 2] {
        let (s, c) = self.middle().sin_cos();
        let along = (y + -self.center) * self.rate;
        let across = -(z * self.rate) + 1.0;
        let (sine, cosine) = (along * c - across * s, across * c + along * s);
        [sine.atan2(cosine), S::superellipse_norm(sine.abs(), cosine.abs(), 1.0)]
    }
}

impl Deform for Bend {
    fn forward_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        if self.rate == 0.0 {
            return [x, y, z];
        }
        let [y_min, y_max] = self.range;
        let beyond = y.excess(y_min, y_max);
        let theta = (y.clamp(y_min, y_max) + -self.center) * self.rate;
        let (s, c) = theta.sin_cos();
        let [along, across] = self.arc(theta);
        [x, along - s * z + c * beyond + self.center, across + c * z + s * beyond]
    }

    /// B84's inverse, with the angle by its two coordinates and the sign of k: the rigid motion
    /// of the plane at the angle, undone.
    fn inverse_of<S: Scalar>(&self, [x, y, z]: [S; 3]) -> [S; 3] {
        if self.rate == 0.0 {
            return [x, y, z];
        }
        let radius = self.rate.recip();
        let half = 0.5 * self.angle();
        let [angle, distance] = self.polar(y, z);
        let theta = angle.clamp(-half, half) + self.middle();
        let (beyond_sin, _) = angle.excess(-half, half).sin_cos();
        let beyond = distance * beyond_sin * radius;
        let (s, c) = theta.sin_cos();
        let [_, across] = self.arc(theta);
        [x, theta * radius + self.center + beyond, across + z * c - (y + -self.center) * s]
    }

    fn check(&self, [_, y, z]: [Interval; 3]) -> Result<(), DeformError> {
        if self.rate == 0.0 {
            return Ok(());
        }
        let [y_min, y_max] = self.range;
        let stretch = -(z * self.rate) + 1.0;
        let is_bent = y.lo() < y_max && y.hi() > y_min;
        if is_bent && stretch.lo() <= 0.0 {
            return Err(DeformError::BendFolds { z: z.middle(), stretch: stretch.lo() });
        }
        let beyond = y.excess(y_min, y_max).abs() * self.rate.abs();
        let room = PI - (0.5 - MEETING_TOLERANCE) * self.angle();
        let is_apart = beyond.hi() == 0.0 || beyond.atan2(stretch).hi() <= room;
        if is_apart { Ok(()) } else { Err(DeformError::BendMeets { y: y.middle() }) }
    }

    fn jacobian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        let (s, c) = self.turn(x.y);
        let stretch = self.stretch(x);
        Matrix3::new(1.0, 0.0, 0.0, 0.0, c * stretch, -s, 0.0, s * stretch, c)
    }

    /// `1 - k z` in the bent region, 1 beyond it.
    fn determinant(&self, x: &Vector3<f64>) -> f64 {
        self.stretch(x)
    }

    fn normal_transform(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        let (s, c) = self.turn(x.y);
        let stretch = self.stretch(x);
        Matrix3::new(stretch, 0.0, 0.0, 0.0, c, -s * stretch, 0.0, s, c * stretch)
    }
}
