//! Solids shaded with Phong's model and three lights, by the library's z-buffer.

use nalgebra::{Rotation3, Vector3};
use superquadric::raster::{Placement, ZBuffer, scatter};
use superquadric::shape::Superellipsoid;

use crate::picture::{Panel, Picture};

/// Samples along each side of a pixel.
const FINER: usize = 3;

/// Unit vectors towards the lights in the camera's frame (x right, y down, z forward), and their
/// strengths.
const LIGHTS: [([f64; 3], f64); 3] =
    [([-0.5, -0.7, -0.5], 0.75), ([0.8, -0.2, -0.55], 0.35), ([0.1, 0.6, -0.8], 0.15)];

const AMBIENT: f64 = 0.15;
const SPECULAR: f64 = 0.35;
const SHININESS: i32 = 30;

/// A solid and how it is looked at.
pub struct View<'a> {
    pub shape: &'a Superellipsoid,
    pub camera_from_model: Rotation3<f64>,
    /// Lengths that half a panel stands for.
    pub half_width: f64,
    pub color: [f64; 3],
}

/// The view from before and above: z upwards, x to the lower left.
pub fn from_above() -> Rotation3<f64> {
    // The camera's rows in the model's frame: right, down, forward.
    let forward = Vector3::new(-0.75, -0.45, -0.48).normalize();
    let right = forward.cross(&Vector3::z()).normalize();
    let down = forward.cross(&right);
    Rotation3::from_basis_unchecked(&[right, down, forward]).inverse()
}

/// Draws a solid in the middle of a panel.
pub fn draw(picture: &mut Picture, panel: &Panel, view: &View) {
    let side = FINER * panel.side;
    let (buffer, seen) = sampled(view, side);
    for row in 0..panel.side {
        for column in 0..panel.side {
            let samples = (0..FINER * FINER).filter_map(|i| {
                let sample = [FINER * column + i % FINER, FINER * row + i / FINER];
                let index = sample[1] * side + sample[0];
                buffer.depths()[index].is_finite().then(|| shade(view, &seen[index]))
            });
            let colors: Vec<Vector3<f64>> = samples.collect();
            if !colors.is_empty() {
                let mean = colors.iter().sum::<Vector3<f64>>() / colors.len() as f64;
                let share = colors.len() as f64 / (FINER * FINER) as f64;
                let pixel = [panel.corner[0] + column, panel.corner[1] + row];
                picture.cover(pixel, mean.into(), share);
            }
        }
    }
}

/// The z-buffer of a view, and the model's point seen at each of its places.
pub fn sampled(view: &View, side: usize) -> (ZBuffer, Vec<Vector3<f64>>) {
    let mut buffer = ZBuffer::new(side, side).expect("a valid size");
    let mut seen = vec![Vector3::zeros(); side * side];
    let pixel = 2.0 * view.half_width / side as f64;
    let placement = Placement { centre: [0.5 * (side as f64 - 1.0); 2], depth: 0.0, pixel };
    scatter(&mut buffer, view.shape, &view.camera_from_model, &placement, |index, x| {
        seen[index] = *x;
    });
    (buffer, seen)
}

/// Phong's model at a point of the surface: ambient, diffuse and specular light.
fn shade(view: &View, x_model: &Vector3<f64>) -> Vector3<f64> {
    let normal = view.camera_from_model * view.shape.gauge_gradient(x_model);
    let normal = normal.normalize();
    let eye = -Vector3::z();
    let color = Vector3::from(view.color);
    let light = LIGHTS.iter().map(|&(towards, strength)| {
        let towards = Vector3::from(towards).normalize();
        let cosine = normal.dot(&towards).max(0.0);
        let mirrored = 2.0 * normal.dot(&towards) * normal - towards;
        let gleam = if cosine > 0.0 { mirrored.dot(&eye).max(0.0).powi(SHININESS) } else { 0.0 };
        strength * (color * cosine + Vector3::repeat(SPECULAR * gleam))
    });
    (AMBIENT * color + light.sum::<Vector3<f64>>()).map(|channel| channel.min(1.0))
}
