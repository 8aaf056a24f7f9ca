//! What a camera sees of a solid: depths and normals.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::half_line::Ray;
use super::target::{Hit, Hittable};
use crate::view::{Camera, OrthographicCamera};

/// A camera as its pixels' rays, in its own frame: x to the right, y down, z forward.
pub trait Rays {
    /// The ray of a pixel, along which z grows by 1 with t; none where no light comes through.
    fn ray(&self, column: f64, row: f64) -> Option<Ray>;

    /// Columns and rows.
    fn size(&self) -> [u32; 2];
}

impl Rays for Camera {
    fn ray(&self, column: f64, row: f64) -> Option<Ray> {
        let direction = Camera::ray(self, column, row)?.into();
        Some(Ray { origin: Vector3::zeros(), direction })
    }

    fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }
}

impl Rays for OrthographicCamera {
    /// From the plane `z = 0` on.
    fn ray(&self, column: f64, row: f64) -> Option<Ray> {
        let x = (column - self.origin[0]) / self.scale[0];
        let y = (row - self.origin[1]) / self.scale[1];
        Some(Ray { origin: Vector3::new(x, y, 0.0), direction: Vector3::z() })
    }

    fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }
}

/// Depths and normals, row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// Columns and rows.
    pub size: [u32; 2],
    /// z in the camera's frame at the first hit of a pixel's ray; 0 where nothing is hit.
    pub depths: Vec<f64>,
    /// Outward unit normals there in the camera's frame; 0 where nothing is hit.
    pub normals: Vec<Vector3<f64>>,
    /// Which of the solids is hit there, by its place among them; 0 too where nothing is hit.
    pub solids: Vec<usize>,
}

/// What a camera sees of solids given in its frame, in parallel; `on_row` is called after every
/// row.
pub fn render(
    targets_camera: &[impl Hittable + Sync],
    camera: &(impl Rays + Sync),
    on_row: impl Fn() + Sync,
) -> Rendering {
    let [width, height] = camera.size();
    let rows: Vec<Vec<Pixel>> = (0..height)
        .into_par_iter()
        .map(|row| {
            let pixels = (0..width).map(|column| pixel(targets_camera, camera, [column, row]));
            let pixels = pixels.collect();
            on_row();
            pixels
        })
        .collect();
    let pixels = || rows.iter().flatten();
    Rendering {
        size: [width, height],
        depths: pixels().map(|pixel| pixel.depth).collect(),
        normals: pixels().map(|pixel| pixel.normal).collect(),
        solids: pixels().map(|pixel| pixel.solid).collect(),
    }
}

/// What is seen in a pixel.
struct Pixel {
    depth: f64,
    normal: Vector3<f64>,
    solid: usize,
}

fn pixel(targets: &[impl Hittable], camera: &impl Rays, [column, row]: [u32; 2]) -> Pixel {
    let ray = camera.ray(f64::from(column), f64::from(row));
    match ray.and_then(|ray| first_hit(targets, &ray)) {
        Some((hit, solid)) => Pixel { depth: hit.position.z, normal: hit.normal, solid },
        None => Pixel { depth: 0.0, normal: Vector3::zeros(), solid: 0 },
    }
}

/// The first hit of a ray with any of some solids, and the solid's place among them: of those hit
/// at once the first.
pub fn first_hit(targets: &[impl Hittable], ray: &Ray) -> Option<(Hit, usize)> {
    let hits = targets.iter().enumerate();
    let hits = hits.filter_map(|(solid, target)| Some((target.first_hit(ray)?, solid)));
    hits.reduce(|a, b| if b.0.t < a.0.t { b } else { a })
}
