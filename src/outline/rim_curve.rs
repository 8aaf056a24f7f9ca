//! The rim of any solid: closed curves, several for a ring.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::curve::Curve;
use super::part::{Part, bounds, parts};
use super::visibility::Visibility;
use crate::ray::outward_normal;
use crate::solid::Tree;
use crate::view::{RimError, Viewpoint, rim};

/// Segments of the meshes on which the rim is looked for.
const SEGMENTS: usize = 32;

/// Share of the solid's size that chords are off the rim, at most, where its length is measured.
const TOLERANCE: f64 = 1e-4;

/// Points from which the length of a convex part's rim is measured.
const DENSE: usize = 256;

/// Points that every curve has.
const FEWEST: usize = 3;

/// A closed curve of the rim: the last point is next to the first.
#[derive(Debug, Clone, PartialEq)]
pub struct RimCurve {
    /// Points in their order, at even distances; the part of the surface that faces the camera is
    /// to the left, as seen from outside.
    pub points: Vec<Vector3<f64>>,
    /// Whether the solid hides each.
    pub is_hidden: Vec<bool>,
}

/// The rim of a solid (JLS Eqs. 2.44, 2.45), in the frame of the solid and the viewpoint: some
/// `count` points in all, at even distances, each solved for on the surface.
///
/// Of a union it is the rims of all parts, hidden where another part is in the way or around them.
/// On edges, those of caps and of what was cut among them, where the normal jumps past the rim's
/// condition, it follows the edge. Parts of the rim smaller than a 100th of the solid may be
/// missed.
///
/// # Errors
/// If the camera is in the solid, or the viewpoint is no place or direction.
pub fn rim_curves(
    solid: &Tree,
    viewpoint: &Viewpoint,
    count: usize,
) -> Result<Vec<RimCurve>, RimError> {
    check(solid, viewpoint)?;
    let parts = parts(solid);
    let bounds @ [min, max] = bounds(&parts);
    let mut curves = Vec::new();
    for part in &parts {
        curves.extend(
            dense(part, viewpoint, TOLERANCE * (max - min).norm())?
                .into_iter()
                .map(|curve| (part, curve)),
        );
    }
    let whole: f64 = curves.iter().map(|(_, curve)| curve.length()).sum();
    let visibility = Visibility::new(solid, bounds, *viewpoint);
    let spaced = |(part, curve): &(&Part<'_>, Curve<'_>)| {
        let share = curve.length() / whole;
        let count = (share * count as f64).round() as usize;
        RimCurve::of(part, curve, count, &visibility)
    };
    curves.iter().map(spaced).collect()
}

/// The curves of a part's rim, as dense as their length is to be measured.
fn dense<'a>(
    part: &Part<'a>,
    viewpoint: &Viewpoint,
    tolerance: f64,
) -> Result<Vec<Curve<'a>>, RimError> {
    let Some(model) = &part.convex else {
        let is_coarse = |[a, middle, b]: &[Vector3<f64>; 3]| {
            (middle - 0.5 * (a + b)).norm() > tolerance.max(1e-3 * (b - a).norm())
        };
        return Ok(part.trace(viewpoint, SEGMENTS, is_coarse));
    };
    let points = rim(&model.shape, &viewpoint.in_frame_of(&model.pose), DENSE)?;
    let points = points.iter().map(|x| model.pose.world_from_model(x)).collect();
    Ok(vec![Curve::convex(*model, *viewpoint, points)])
}

impl RimCurve {
    /// The longest runs of neighbours that are all hidden, or all not; each with the point after
    /// it, where there is one.
    pub fn runs(&self, is_hidden: bool) -> Vec<Vec<Vector3<f64>>> {
        let Self { points, is_hidden: flags } = self;
        let count = points.len();
        // From a place where a run begins, once around.
        let starts = |i: &usize| flags[*i] != flags[(i + count - 1) % count];
        let first = (0..count).find(starts).unwrap_or(0);
        let around: Vec<usize> = (first..=first + count).map(|i| i % count.max(1)).collect();
        let mut runs: Vec<Vec<Vector3<f64>>> = Vec::new();
        for pair in around.windows(2) {
            let [here, next] = [pair[0], pair[1]];
            if flags[here] != is_hidden {
                continue;
            }
            match runs.last_mut() {
                Some(run) if here != first && run.last() == Some(&points[here]) => {
                    run.push(points[next]);
                }
                _ => runs.push(vec![points[here], points[next]]),
            }
        }
        runs
    }

    /// A curve with so many points, at even distances.
    pub(super) fn of(
        part: &Part<'_>,
        curve: &Curve<'_>,
        count: usize,
        visibility: &Visibility,
    ) -> Result<Self, RimError> {
        let points = curve.evenly(count.max(FEWEST))?;
        let is_hidden = |x| visibility.is_hidden(x, &outward_normal(part.solid, x));
        let is_hidden = points.par_iter().map(is_hidden).collect();
        Ok(Self { points, is_hidden })
    }
}

/// Refuses views without a rim.
pub(super) fn check(solid: &Tree, viewpoint: &Viewpoint) -> Result<(), RimError> {
    let (Viewpoint::At(vector) | Viewpoint::Along(vector)) = viewpoint;
    let is_finite = vector.iter().all(|component| component.is_finite());
    match viewpoint {
        _ if !is_finite => Err(RimError::Viewpoint),
        Viewpoint::Along(direction) if direction.amax() == 0.0 => Err(RimError::Viewpoint),
        Viewpoint::At(centre) if solid.contains(centre) => Err(RimError::Inside),
        _ => Ok(()),
    }
}
