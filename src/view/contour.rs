//! The occluding contour: the rim as a camera sees it (JLS section 2.4.3).

use nalgebra::{Vector2, Vector3};

use super::projection::Projection;
use super::rim::{RimError, Sample, Tangents, Touch, refine};
use crate::model::Model;
use crate::pose::Pose;

/// Most pixels by which the polygon may be off the contour.
const TOLERANCE: f64 = 0.01;

/// The same, as a share of the contour's extent: a solid of a few pixels has a good area too.
const RELATIVE_TOLERANCE: f64 = 1e-4;

/// Neighbours so near, in tolerances, are told apart no more.
const NEAREST: f64 = 0.05;

/// The outline of a solid in an image, as a closed polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Contour {
    polygon: Vec<[f64; 2]>,
    rim_camera: Vec<Vector3<f64>>,
}

/// A point of the contour.
#[derive(Debug, Clone, Copy)]
struct Seen {
    x_camera: Vector3<f64>,
    undistorted: Vector2<f64>,
    pixel: Vector2<f64>,
    /// Direction of the contour without distortion, one way around for all points.
    tangent: Vector2<f64>,
}

impl Contour {
    /// The outline of a model, given in the camera's frame.
    ///
    /// Its points are solved for to rounding; between them the polygon is at most 0.01 pixels off
    /// the contour, and at most 1e-4 of its extent.
    ///
    /// # Errors
    /// If the solid is not convex (an exponent above 2), the camera is not outside it, or part of
    /// it is behind the camera or where the lens lets no ray through.
    pub fn of(model_camera: &Model, camera: &impl Projection) -> Result<Self, RimError> {
        let viewpoint = camera.viewpoint(&model_camera.pose);
        let tangents = Tangents::new(&model_camera.shape, &viewpoint)?;
        let see = |theta: f64| see(&model_camera.pose, camera, &tangents.touch(theta));
        let coarse = refine(see, |_, _| false)?;
        let tolerance = TOLERANCE.min(RELATIVE_TOLERANCE * extent(&coarse));
        let fine = refine(see, |a, b| is_coarse(a, b, camera, tolerance))?;
        Ok(Self {
            polygon: fine.iter().map(|sample| sample.point.pixel.into()).collect(),
            rim_camera: fine.iter().map(|sample| sample.point.x_camera).collect(),
        })
    }

    /// Pixels `[column, row]` once around, the last next to the first; the centre of the first
    /// pixel of the image is (0, 0). They may lie beside the image.
    pub fn polygon(&self) -> &[[f64; 2]] {
        &self.polygon
    }

    /// The point of the rim, in the camera's frame, that is seen at each vertex of the polygon.
    pub fn rim_camera(&self) -> &[Vector3<f64>] {
        &self.rim_camera
    }

    /// Area of the silhouette, in square pixels.
    pub fn area(&self) -> f64 {
        let Some(&[u0, v0]) = self.polygon.first() else { return 0.0 };
        let next = self.polygon.iter().skip(1).chain(self.polygon.first());
        // Seen from a vertex: nothing cancels far from the image's corner.
        let doubled =
            |(a, b): (&[f64; 2], &[f64; 2])| (a[0] - u0) * (b[1] - v0) - (b[0] - u0) * (a[1] - v0);
        0.5 * self.polygon.iter().zip(next).map(doubled).sum::<f64>().abs()
    }

    /// The least box along rows and columns that holds the silhouette: `[min, max]` as
    /// `[column, row]`.
    pub fn bounding_box(&self) -> [[f64; 2]; 2] {
        let of = |start: f64, pick: fn(f64, f64) -> f64| {
            [0, 1].map(|k| self.polygon.iter().map(|pixel| pixel[k]).fold(start, pick))
        };
        [of(f64::INFINITY, f64::min), of(f64::NEG_INFINITY, f64::max)]
    }
}

/// A point of the rim as the camera sees it.
fn see(
    camera_from_model: &Pose,
    camera: &impl Projection,
    touch: &Touch,
) -> Result<Seen, RimError> {
    let x_camera = camera_from_model.world_from_model(&touch.point);
    let undistorted = camera.project_undistorted(&x_camera).ok_or(RimError::Behind)?;
    let pixel = camera.distort(undistorted).ok_or(RimError::BeyondLens)?;
    // The plane that touches the solid here holds the line of sight, and is seen as a line.
    let normal = camera_from_model.rotation() * touch.normal;
    let [fx, fy] = camera.focal_lengths();
    let tangent = Vector2::new(-normal.y / fy, normal.x / fx);
    let tangent = tangent.try_normalize(0.0).unwrap_or_default();
    Ok(Seen { x_camera, undistorted: undistorted.into(), pixel: pixel.into(), tangent })
}

/// Whether the chord between two points is off the contour by more than the tolerance.
///
/// Without distortion the contour is convex, and lies in the triangle of the chord and the tangents
/// at its ends. Where these turn by less than a right angle, its height is at most `|chord|` times
/// the lesser sine of the angles at the chord. Distortion bends the chord itself by about as much as its middle.
fn is_coarse(a: &Seen, b: &Seen, camera: &impl Projection, tolerance: f64) -> bool {
    let chord = b.undistorted - a.undistorted;
    let length = chord.norm();
    if length <= NEAREST * tolerance {
        return false;
    }
    let [along_a, along_b] = [a, b].map(|end| end.tangent.dot(&chord));
    let [across_a, across_b] = [a, b].map(|end| end.tangent.perp(&chord).abs());
    let turns_by_a_right_angle = along_a * along_b <= across_a * across_b;
    let middle = 0.5 * (a.undistorted + b.undistorted);
    let bent = camera
        .distort(middle.into())
        .map_or(f64::INFINITY, |pixel| (Vector2::from(pixel) - 0.5 * (a.pixel + b.pixel)).norm());
    turns_by_a_right_angle || across_a.min(across_b) > tolerance || bent > tolerance
}

/// The greater side of the box around points of a contour.
fn extent(samples: &[Sample<Seen>]) -> f64 {
    let pixels = samples.iter().map(|sample| sample.point.undistorted);
    let low = pixels.clone().fold(Vector2::repeat(f64::INFINITY), |low, pixel| low.inf(&pixel));
    let high = pixels.fold(Vector2::repeat(f64::NEG_INFINITY), |high, pixel| high.sup(&pixel));
    (high - low).amax()
}

#[cfg(test)]
mod tests;
