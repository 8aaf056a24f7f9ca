//! The rim: where lines of sight touch a solid (JLS section 2.4.3).

mod closed_form;
mod refine;
mod tangent;

use nalgebra::Vector3;
use thiserror::Error;

pub use closed_form::{orthographic_rim_meridians, orthographic_rim_point};
pub(super) use refine::{Sample, refine};
pub(super) use tangent::{Tangents, Touch};

use crate::pose::Pose;
use crate::shape::Superellipsoid;

/// Segments to the distance between two points of an evenly spaced rim.
const SEGMENTS_A_STEP: f64 = 8.0;

/// Where a solid is seen from, in the frame of the solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Viewpoint {
    /// The centre of a pinhole camera.
    At(Vector3<f64>),
    /// The direction in which an orthographic camera looks, of any length but 0.
    Along(Vector3<f64>),
}

impl Viewpoint {
    /// The same in the frame of something at a pose.
    pub fn in_frame_of(&self, pose: &Pose) -> Self {
        match self {
            Self::At(centre) => Self::At(pose.model_from_world(centre)),
            Self::Along(direction) => {
                Self::Along(pose.rotation().inverse_transform_vector(direction))
            }
        }
    }
}

/// A view in which a solid has no rim, or none that can be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum RimError {
    /// A solid that is not convex.
    #[error("the rim is traced for exponents up to 2, where a solid is convex; found {0}")]
    NotConvex(f64),
    /// A camera within the solid or on its surface.
    #[error("the camera is not outside the solid, which then has no rim")]
    Inside,
    /// A viewpoint that is no place or direction.
    #[error("a viewpoint must be finite, and a direction of view not 0")]
    Viewpoint,
    /// Part of the rim is not in front of a pinhole camera.
    #[error("the solid reaches behind the camera: its outline does not close in the image")]
    Behind,
    /// Part of the rim is where the lens lets no ray through.
    #[error("the solid reaches where distortion folds the image back onto itself")]
    BeyondLens,
}

/// Points of the rim of a superellipsoid, in its own frame, as a closed curve that goes once
/// around, the last point next to the first: `(x - c) . n(x) = 0` for a pinhole at c, `v . n(x) =
/// 0` for the direction of view v of an orthographic camera (JLS Eqs. 2.44, 2.45).
///
/// Each of the `count` points is solved for to rounding. They are evenly spaced along the curve.
/// A solid with exponents up to 2 is convex, and hides no part of its rim.
///
/// # Errors
/// If the solid is not convex or the camera not outside it.
pub fn rim(
    shape: &Superellipsoid,
    viewpoint: &Viewpoint,
    count: usize,
) -> Result<Vec<Vector3<f64>>, RimError> {
    let tangents = Tangents::new(shape, viewpoint)?;
    let solve = |theta| Ok::<_, RimError>(tangents.point(theta));
    let coarse = refine(solve, |_, _| false)?;
    let step = length(&coarse) / (SEGMENTS_A_STEP * count.max(1) as f64);
    let fine = refine(solve, |a, b| (b - a).norm() > step)?;
    Ok(evenly(&fine, count).map(|place| place.solve(&tangents)).collect())
}

/// The length of a closed polygon.
fn length(curve: &[Sample<Vector3<f64>>]) -> f64 {
    segments(curve).map(|[a, b]| (b.point - a.point).norm()).sum()
}

/// Pairs of neighbours on a closed curve, whose parameter grows by a turn from end to start.
fn segments(
    curve: &[Sample<Vector3<f64>>],
) -> impl Iterator<Item = [Sample<Vector3<f64>>; 2]> + '_ {
    let turned =
        curve.first().map(|first| Sample { theta: first.theta + std::f64::consts::TAU, ..*first });
    let ends = curve.iter().skip(1).copied().chain(turned);
    curve.iter().copied().zip(ends).map(|(a, b)| [a, b])
}

/// A place between two neighbours.
struct Place {
    between: [Sample<Vector3<f64>>; 2],
    share: f64,
}

impl Place {
    fn solve(&self, tangents: &Tangents) -> Vector3<f64> {
        let [a, b] = self.between;
        tangents.point(a.theta + self.share * (b.theta - a.theta))
    }
}

/// Places that divide the length of a closed curve evenly.
fn evenly(curve: &[Sample<Vector3<f64>>], count: usize) -> impl Iterator<Item = Place> {
    let step = length(curve) / count as f64;
    let mut segments = segments(curve);
    let (mut passed, mut here) = (0.0, None);
    (0..count).filter_map(move |i| {
        let target = step * i as f64;
        loop {
            let [a, b] = match here {
                Some(segment) => segment,
                None => *here.insert(segments.next()?),
            };
            let length = (b.point - a.point).norm();
            if target <= passed + length {
                let share = if length > 0.0 { (target - passed) / length } else { 0.0 };
                return Some(Place { between: [a, b], share });
            }
            passed += length;
            here = None;
        }
    })
}

#[cfg(test)]
mod tests;
