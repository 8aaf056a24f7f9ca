//! Solids shaded with Phong's model and three lights, by the library's z-buffer.

use nalgebra::{Rotation3, Vector3};
use superquadric::raster::{Placement, ZBuffer, scatter};
use superquadric::shape::{Shape, Solid};
use superquadric::surface::{Resolution, tessellate_shape};

use crate::picture::{Panel, Picture};

/// Samples along each side of a pixel.
const FINER: usize = 3;

/// Unit vectors towards the lights in the camera's frame (x right, y down, z forward), and their
/// strengths.
const LIGHTS: [([f64; 3], f64); 3] =
    [([-0.5, -0.7, -0.5], 0.75), ([0.8, -0.2, -0.55], 0.35), ([0.1, 0.6, -0.8], 0.15)];

/// Segments of the meshes of families other than superellipsoids.
const SEGMENTS: usize = 64;

/// Least cosine of a facet's normal and the gradient of a surface that the facet is laid on; a
/// cap's is less.
const LAID_ON: f64 = 0.7;

const AMBIENT: f64 = 0.15;
const SPECULAR: f64 = 0.35;
const SHININESS: i32 = 30;

/// A solid and how it is looked at.
pub struct View<'a> {
    pub shape: &'a Shape,
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
    let (buffer, normals) = sampled(view, side);
    for row in 0..panel.side {
        for column in 0..panel.side {
            let samples = (0..FINER * FINER).filter_map(|i| {
                let sample = [FINER * column + i % FINER, FINER * row + i / FINER];
                let index = sample[1] * side + sample[0];
                buffer.depths()[index].is_finite().then(|| shade(view, &normals[index]))
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

/// The z-buffer of a view, and the normal, in the model's frame, at each of its places.
pub fn sampled(view: &View, side: usize) -> (ZBuffer, Vec<Vector3<f64>>) {
    let mut buffer = ZBuffer::new(side, side).expect("a valid size");
    let mut normals = vec![Vector3::zeros(); side * side];
    let pixel = 2.0 * view.half_width / side as f64;
    let placement = Placement { centre: [0.5 * (side as f64 - 1.0); 2], depth: 0.0, pixel };
    if let Shape::Superellipsoid(shape) = view.shape {
        scatter(&mut buffer, shape, &view.camera_from_model, &placement, |index, x| {
            normals[index] = shape.gauge_gradient(x);
        });
    } else {
        put_mesh(&mut buffer, &mut normals, view, &placement);
    }
    (buffer, normals)
}

/// Puts the points of a mesh of any family into the z-buffer, half a pixel apart.
fn put_mesh(
    buffer: &mut ZBuffer,
    normals: &mut [Vector3<f64>],
    view: &View,
    placement: &Placement,
) {
    let resolution = Resolution::new(SEGMENTS).expect("a valid resolution");
    for [a, b, c] in tessellate_shape(view.shape, resolution).corners() {
        let facet_normal = (b - a).cross(&(c - a));
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        let steps = (2.0 * longest / placement.pixel).ceil().max(1.0) as u32;
        for (i, j) in (0..=steps).flat_map(|i| (0..=steps - i).map(move |j| (i, j))) {
            let [u, v] = [i, j].map(|step| f64::from(step) / f64::from(steps));
            let x_model = a + (b - a) * u + (c - a) * v;
            let x_camera = view.camera_from_model * x_model;
            let place = |axis: usize| placement.centre[axis] + x_camera[axis] / placement.pixel;
            let pixel = [0, 1].map(|axis| place(axis).round() as isize);
            if buffer.put(pixel, x_camera.z as f32)
                && let Some(index) = buffer.index(pixel)
            {
                normals[index] = normal(view.shape, &x_model, &facet_normal);
            }
        }
    }
}

/// The gradient at a point of a facet, or the facet's own normal where that is of a cap.
fn normal(shape: &Shape, x: &Vector3<f64>, facet_normal: &Vector3<f64>) -> Vector3<f64> {
    let facet_normal = facet_normal.normalize();
    let gradient = shape.inside_outside_gradient(x).normalize();
    // Written so that a gradient that overflows is not taken.
    if gradient.dot(&facet_normal) > LAID_ON { gradient } else { facet_normal }
}

/// Phong's model at a normal of the model: ambient, diffuse and specular light.
fn shade(view: &View, normal: &Vector3<f64>) -> Vector3<f64> {
    let normal = (view.camera_from_model * normal).normalize();
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
