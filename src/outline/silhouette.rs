//! The boundary of a silhouette, from the rim.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::float::simplify::SimplifyShape;
use nalgebra::Vector3;

use super::rim_curve::{RimCurve, rim_curves};
use crate::model::Model;
use crate::shape::{Shape, Superellipsoid};
use crate::solid::Primitive;
use crate::surface::Resolution;
use crate::view::{Contour, Projection, RimError, Viewpoint};

/// Segments of the mesh on which the rim is looked for.
const SEGMENTS: usize = 64;

/// Polygons of less than this share of the silhouette's area are specks of rounding.
const SPECK: f64 = 1e-7;

/// What a camera sees of a solid's edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    polygons: Vec<Vec<[f64; 2]>>,
    rim_camera: Vec<RimCurve>,
}

impl Outline {
    /// The outline of a deformed shape of any family, given in the camera's frame.
    ///
    /// A superellipsoid's with exponents up to 2 is its [`Contour`]. Any other's has vertices
    /// that are solved for, some 250 and more around the solid; its chords may be off by a few
    /// thousandths of the solid's extent where the surface is bent sharply.
    ///
    /// # Errors
    /// If the camera is not outside the solid, or part of it is behind the camera or where the
    /// lens lets no ray through.
    pub fn of(
        primitive_camera: &Primitive<Shape>,
        camera: &impl Projection,
    ) -> Result<Self, RimError> {
        match convex(primitive_camera) {
            Some(model_camera) => Ok(Self::from(Contour::of(&model_camera, camera)?)),
            None => Self::traced(primitive_camera, camera),
        }
    }

    fn traced(
        Primitive { deformed, pose }: &Primitive<Shape>,
        camera: &impl Projection,
    ) -> Result<Self, RimError> {
        let viewpoint = camera.viewpoint(pose);
        let resolution = Resolution::new(SEGMENTS).expect("a number that is a resolution");
        let rim_camera: Vec<RimCurve> = rim_curves(deformed, &viewpoint, resolution)?
            .into_iter()
            .map(|RimCurve { points, is_hidden }| {
                let points = points.iter().map(|x| pose.world_from_model(x)).collect();
                RimCurve { points, is_hidden }
            })
            .collect();
        if rim_camera.is_empty() && matches!(viewpoint, Viewpoint::At(_)) {
            return Err(RimError::Inside);
        }
        let images = rim_camera
            .iter()
            .map(|curve| curve.points.iter().map(|x| pixel(x, camera)).collect())
            .collect::<Result<Vec<Vec<[f64; 2]>>, RimError>>()?;
        Ok(Self { polygons: covered(&images), rim_camera })
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

impl From<Contour> for Outline {
    /// A convex solid hides nothing of its rim.
    fn from(contour: Contour) -> Self {
        let points = contour.rim_camera().to_vec();
        let is_hidden = vec![false; points.len()];
        Self {
            polygons: vec![contour.polygon().to_vec()],
            rim_camera: vec![RimCurve { points, is_hidden }],
        }
    }
}

/// The undeformed superellipsoid that is convex, if it is one.
fn convex(primitive: &Primitive<Shape>) -> Option<Model> {
    let Model { shape, pose } = primitive.undeformed()?;
    let is_convex = |shape: &Superellipsoid| shape.exponents().iter().all(|e| *e <= 2.0);
    match shape {
        Shape::Superellipsoid(shape) if is_convex(&shape) => Some(Model { shape, pose }),
        _ => None,
    }
}

fn pixel(x_camera: &Vector3<f64>, camera: &impl Projection) -> Result<[f64; 2], RimError> {
    let undistorted = camera.project_undistorted(x_camera).ok_or(RimError::Behind)?;
    camera.distort(undistorted).ok_or(RimError::BeyondLens)
}

/// The boundary of what the images of rims go around.
///
/// The part of the surface that faces the camera lies to the left of them all, so that they go
/// around a pixel as often as its line of sight enters the solid.
fn covered(images: &[Vec<[f64; 2]>]) -> Vec<Vec<[f64; 2]>> {
    let shapes = images.to_vec().simplify_shape_as::<i64>(FillRule::NonZero);
    let polygons: Vec<Vec<[f64; 2]>> = shapes.into_iter().flatten().collect();
    let greatest = polygons.iter().map(|polygon| signed_area(polygon).abs()).fold(0.0, f64::max);
    let is_speck = |polygon: &[[f64; 2]]| signed_area(polygon).abs() < SPECK * greatest;
    polygons.into_iter().filter(|polygon| !is_speck(polygon)).collect()
}

/// Area of a polygon, negative one way around.
fn signed_area(polygon: &[[f64; 2]]) -> f64 {
    let Some(&[u0, v0]) = polygon.first() else { return 0.0 };
    // Seen from a vertex: nothing cancels far from the image's corner.
    let doubled = |[a, b]: [[f64; 2]; 2]| (a[0] - u0) * (b[1] - v0) - (b[0] - u0) * (a[1] - v0);
    0.5 * polygon.windows(2).map(|pair| doubled([pair[0], pair[1]])).sum::<f64>()
}
