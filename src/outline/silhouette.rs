//! The boundary of a silhouette, from the rim.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::float::simplify::SimplifyShape;
use nalgebra::{Vector2, Vector3};

use super::curve::Curve;
use super::part::{Part, bounds, parts};
use super::polish::polished;
use super::rim_curve::{RimCurve, check};
use super::visibility::Visibility;
use crate::pose::Pose;
use crate::ray::Rays;
use crate::solid::Tree;
use crate::view::{Contour, Projection, RimError, Viewpoint};

/// Most pixels by which a chord may be off the rim's image.
const TOLERANCE: f64 = 0.02;

/// Most pixels of a chord: what bends to either side of it shows.
const LONGEST: f64 = 8.0;

/// Chords so short, in pixels, are left as they are.
const SHORTEST: f64 = 0.01;

/// Pixels to a segment along each side of the meshes on which the rim is looked for, and fewest
/// and most of these.
const PIXELS_A_SEGMENT: f64 = 6.0;
const SEGMENTS: [f64; 2] = [32.0, 128.0];

/// Pixels from a point of the rim to the next, and fewest and most points of a curve.
const SPACING: f64 = 1.0;
const POINTS: [f64; 2] = [128.0, 16_384.0];

/// Polygons besides the greatest that are no wider, in pixels, are specks of what chords are off.
const SPECK: f64 = 0.1;

/// What a camera sees of a solid's edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    polygons: Vec<Vec<[f64; 2]>>,
    rim_camera: Vec<RimCurve>,
}

impl Outline {
    /// The outline of a solid, given in the camera's frame.
    ///
    /// A superellipsoid's with exponents up to 2 is its [`Contour`]. Any other's has vertices
    /// that are solved for, and chords no more than some 0.02 pixels off; where rays on either
    /// side tell otherwise, as at blades of exponents above 2, those decide, to 0.1 pixels. That
    /// of a union is the boundary of what its parts cover. The rim has a point at least every
    /// pixel, or, of small solids, 128 of them.
    ///
    /// # Errors
    /// If the camera is not outside the solid, or part of it is behind the camera or where the
    /// lens lets no ray through.
    pub fn of(
        solid_camera: &Tree,
        camera: &(impl Projection + Rays + Sync),
    ) -> Result<Self, RimError> {
        let viewpoint = camera.viewpoint(&Pose::identity());
        check(solid_camera, &viewpoint)?;
        let view = View { camera, viewpoint };
        let (mut images, mut rim_camera) = (Vec::new(), Vec::new());
        let ahead: Vec<Part<'_>> =
            parts(solid_camera).into_iter().filter(|part| view.is_ahead(part)).collect();
        let visibility = Visibility::new(solid_camera, bounds(&ahead), viewpoint);
        for part in &ahead {
            let curves = view.curves(part)?;
            let has_none = curves.is_empty() && matches!(viewpoint, Viewpoint::At(_));
            if has_none {
                return Err(RimError::Inside);
            }
            for (curve, image) in curves {
                let count = view.count(&curve);
                rim_camera.push(RimCurve::of(part, &curve, count, &visibility)?);
                images.push(image);
            }
        }
        if images.is_empty() {
            return Err(RimError::Behind);
        }
        let is_convex = ahead.len() == 1 && ahead[0].convex.is_some();
        if !is_convex {
            let is_hit = |[column, row]: [f64; 2]| {
                camera.ray(column, row).is_some_and(|ray| visibility.is_hit(&ray))
            };
            images = covered(&polished(&covered(&images), is_hit));
        }
        Ok(Self { polygons: images, rim_camera })
    }

    /// The boundary of the silhouette in pixels `[column, row]`: closed polygons, the last vertex
    /// next to the first, those around holes the other way around. The centre of the image's
    /// first pixel is (0, 0); vertices may lie beside the image.
    pub fn polygons(&self) -> &[Vec<[f64; 2]>] {
        &self.polygons
    }

    /// The rim, in the camera's frame.
    pub fn rim_camera(&self) -> &[RimCurve] {
        &self.rim_camera
    }

    /// Area of the silhouette without its holes, in square pixels.
    pub fn area(&self) -> f64 {
        self.polygons.iter().map(|polygon| signed_area(polygon)).sum::<f64>().abs()
    }

    /// The least box along rows and columns that holds the silhouette: `[min, max]` as
    /// `[column, row]`.
    pub fn bounding_box(&self) -> [[f64; 2]; 2] {
        let of = |start: f64, pick: fn(f64, f64) -> f64| {
            [0, 1].map(|k| self.polygons.iter().flatten().map(|pixel| pixel[k]).fold(start, pick))
        };
        [of(f64::INFINITY, f64::min), of(f64::NEG_INFINITY, f64::max)]
    }
}

/// A curve of the rim in the camera's frame, and its image.
type Imaged<'a> = (Curve<'a>, Vec<[f64; 2]>);

/// A camera, and where it looks from in its own frame.
struct View<'a, P> {
    camera: &'a P,
    viewpoint: Viewpoint,
}

impl<P: Projection + Sync> View<'_, P> {
    /// Whether any of a part can be before the camera.
    fn is_ahead(&self, part: &Part<'_>) -> bool {
        match self.viewpoint {
            Viewpoint::At(_) => part.bounds[1].z > 0.0,
            Viewpoint::Along(_) => true,
        }
    }

    /// The curves of a part's rim, each with its image.
    fn curves<'a>(&self, part: &Part<'a>) -> Result<Vec<Imaged<'a>>, RimError> {
        if let Some(model) = &part.convex {
            let contour = Contour::of(model, self.camera)?;
            let image = contour.polygon().to_vec();
            let points = contour.rim_camera().to_vec();
            return Ok(vec![(Curve::convex(*model, self.viewpoint, points), image)]);
        }
        let is_coarse = |points: &[Vector3<f64>; 3]| self.is_coarse(points);
        let curves = part.trace(&self.viewpoint, self.segments(part), is_coarse);
        let imaged = |curve: Curve<'a>| {
            let image = curve.points.iter().map(|x| self.pixel(x)).collect::<Result<_, _>>()?;
            Ok((curve, image))
        };
        curves.into_iter().map(imaged).collect()
    }

    fn pixel(&self, x_camera: &Vector3<f64>) -> Result<[f64; 2], RimError> {
        let undistorted = self.camera.project_undistorted(x_camera).ok_or(RimError::Behind)?;
        self.camera.distort(undistorted).ok_or(RimError::BeyondLens)
    }

    /// Whether the image of a chord `[start, beside the middle, end]` shows to be none of the
    /// rim's.
    fn is_coarse(&self, [a, middle, b]: &[Vector3<f64>; 3]) -> bool {
        let [Ok(a), Ok(middle), Ok(b)] = [a, middle, b].map(|x| self.pixel(x).map(Vector2::from))
        else {
            return false;
        };
        let chord = b - a;
        let length = chord.norm().max((middle - a).norm());
        let off = chord.perp(&(middle - a)).abs() / length;
        length > LONGEST || (length > SHORTEST && off > TOLERANCE)
    }

    /// Segments of the mesh of a part.
    fn segments(&self, part: &Part<'_>) -> usize {
        let [min, max] = part.bounds;
        let pixels = (max - min).norm() * self.scale(&(0.5 * (min + max)));
        let [fewest, most] = SEGMENTS;
        2 * (pixels / PIXELS_A_SEGMENT / 2.0).clamp(0.5 * fewest, 0.5 * most) as usize
    }

    /// Points of a curve of the rim.
    fn count(&self, curve: &Curve<'_>) -> usize {
        let greatest = curve.points.iter().map(|x| self.scale(x)).fold(0.0, f64::max);
        (curve.length() * greatest / SPACING).clamp(POINTS[0], POINTS[1]) as usize
    }

    /// Pixels to a unit of length across the line of sight.
    fn scale(&self, x_camera: &Vector3<f64>) -> f64 {
        let [along_rows, along_columns] = self.camera.focal_lengths();
        let focal = along_rows.max(along_columns);
        match self.viewpoint {
            Viewpoint::At(_) => focal / x_camera.z.abs(),
            Viewpoint::Along(_) => focal,
        }
    }
}

/// The boundary of what the images of rims go around.
///
/// The part of the surface that faces the camera lies to the left of them all, so that they go
/// around a pixel as often as its line of sight enters the solid.
fn covered(images: &[Vec<[f64; 2]>]) -> Vec<Vec<[f64; 2]>> {
    let shapes = images.to_vec().simplify_shape_as::<i64>(FillRule::NonZero);
    let polygons: Vec<Vec<[f64; 2]>> = shapes.into_iter().flatten().collect();
    let greatest = polygons.iter().map(|polygon| signed_area(polygon).abs()).fold(0.0, f64::max);
    let is_speck = |polygon: &[[f64; 2]]| {
        let area = signed_area(polygon).abs();
        area < greatest && 2.0 * area < SPECK * perimeter(polygon)
    };
    polygons.into_iter().filter(|polygon| !is_speck(polygon)).collect()
}

fn perimeter(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1])).sum()
}

/// Area of a polygon, negative one way around.
pub(super) fn signed_area(polygon: &[[f64; 2]]) -> f64 {
    let Some(&[u0, v0]) = polygon.first() else { return 0.0 };
    // Seen from a vertex: nothing cancels far from the image's corner.
    let doubled = |[a, b]: [[f64; 2]; 2]| (a[0] - u0) * (b[1] - v0) - (b[0] - u0) * (a[1] - v0);
    0.5 * polygon.windows(2).map(|pair| doubled([pair[0], pair[1]])).sum::<f64>()
}
