//! How far outlines are from the edges of what rays hit, and cameras and solids to tell by.

use nalgebra::Vector3;
use superquadric::deform::{Chain, Deformation, Deformed};
use superquadric::outline::Outline;
use superquadric::pose::Pose;
use superquadric::ray::{Hittable, Rays, SolidTarget};
use superquadric::shape::{Shape, Superellipsoid};
use superquadric::solid::{Primitive, Tree};
use superquadric::view::{AnyCamera, OrthographicCamera};

pub const WIDTH: u32 = 160;
pub const HEIGHT: u32 = 120;

/// Most pixels between the outline and the edge of what rays hit.
pub const TOLERANCE: f64 = 0.5;

/// Pixels from one place on the outline to the next at which rays are cast on either side.
const STEP: f64 = 2.0;

/// Every which pixel a ray is cast through besides, along rows and columns.
const STRIDE: usize = 6;

/// Whether a place is within polygons, even-odd, and the distance to their nearest side.
fn place(polygons: &[Vec<[f64; 2]>], [u, v]: [f64; 2]) -> (bool, f64) {
    let (mut is_inside, mut nearest) = (false, f64::INFINITY);
    for polygon in polygons {
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            is_inside ^= (a[1] <= v) != (b[1] <= v) && a[0] + (v - a[1]) / y * x > u;
            let share = ((u - a[0]) * x + (v - a[1]) * y) / (x * x + y * y);
            let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
            nearest = nearest.min((a[0] + share * x - u).hypot(a[1] + share * y - v));
        }
    }
    (is_inside, nearest)
}

/// Places a little more than the tolerance to either side of polygons, and pixels of the whole
/// picture.
fn places(polygons: &[Vec<[f64; 2]>]) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    for row in (0..HEIGHT).step_by(STRIDE) {
        places.extend((0..WIDTH).step_by(STRIDE).map(|column| [f64::from(column), f64::from(row)]));
    }
    for polygon in polygons {
        let mut passed = STEP;
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            passed += x.hypot(y);
            if passed >= STEP {
                passed = 0.0;
                let off = 1.01 * TOLERANCE / x.hypot(y);
                let [u, v] = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
                places.extend([1.0, -1.0].map(|side| [u - side * off * y, v + side * off * x]));
            }
        }
    }
    places
}

/// The most pixels between the outline and a place at which rays tell otherwise than it does.
pub fn error(solid: &Tree, camera: &AnyCamera) -> f64 {
    let outline = Outline::of(solid, camera).expect("an outline");
    let target = SolidTarget::new(solid);
    let off = |at: &[f64; 2]| {
        let ray = camera.ray(at[0], at[1])?;
        let (is_inside, off) = place(outline.polygons(), *at);
        (target.first_hit(&ray).is_some() != is_inside).then_some(off)
    };
    places(outline.polygons()).iter().filter_map(off).fold(0.0, f64::max)
}

/// A deformed shape, moved.
pub fn primitive(shape: Shape, stages: &[Deformation], pose: Pose) -> Tree {
    let deformed = Deformed::new(shape, Chain::new(stages.to_vec())).expect("no fold");
    Primitive { deformed, pose }.into()
}

/// A ball of radius 0.5.
pub fn ball(center: [f64; 3]) -> Tree {
    let shape = Superellipsoid::new([0.5; 3], [1.0; 2]).unwrap().into();
    primitive(shape, &[], Pose::new(Default::default(), Vector3::from(center)))
}

pub fn parallel() -> AnyCamera {
    let [scale, origin] = [[40.0; 2], [80.0, 60.0]];
    AnyCamera::Orthographic(OrthographicCamera { scale, origin, width: WIDTH, height: HEIGHT })
}
