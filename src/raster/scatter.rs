//! A superellipsoid in any orientation, written into a z-buffer point by point.

use nalgebra::{Rotation3, Vector3};

use super::height::Placement;
use super::z_buffer::ZBuffer;
use crate::shape::Superellipsoid;
use crate::surface::Parameterization;

/// Points are nowhere further apart than that, in pixels: within half a pixel of the middle of
/// each pixel of the outline, but for those that the outline only touches, there is one.
const SPACING: f64 = 0.5;

/// Writes the surface, turned by `camera_from_model` and seen along the camera's z axis in a
/// parallel view, into the z-buffer where it is nearer than what is there; the placement says
/// where the centre is seen, and is not moved to half pixels.
///
/// `visit` is told the place in [`ZBuffer::depths`] and the model's point, each time that a
/// point is nearer than what was there: the last one told is the one seen.
///
/// The points are spherical products of equally distant points of the superellipses (FB81's
/// method 5), half a pixel apart. Domain: any exponents; a pixel not too small for so many points
/// to be written.
pub fn scatter(
    buffer: &mut ZBuffer,
    shape: &Superellipsoid,
    camera_from_model: &Rotation3<f64>,
    placement: &Placement,
    mut visit: impl FnMut(usize, &Vector3<f64>),
) {
    let step = SPACING * placement.pixel;
    let [meridian, equator] = Parameterization::EqualDistance
        .product(shape, |quarter_length| (quarter_length / step).ceil() as usize);
    let camera_from_unit = camera_from_model.matrix() / placement.pixel;
    for &[scale, z] in &meridian {
        for &[x, y] in &equator {
            let x_model = Vector3::new(scale * x, scale * y, z);
            let seen = camera_from_unit * x_model;
            let pixel = [0, 1].map(|axis| (placement.centre[axis] + seen[axis]).round() as isize);
            let depth = placement.depth + seen.z * placement.pixel;
            if buffer.put(pixel, depth as f32)
                && let Some(index) = buffer.index(pixel)
            {
                visit(index, &x_model);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::write_heights;

    const EXPONENTS: [f64; 5] = [0.1, 0.5, 1.0, 1.5, 2.0];

    #[test]
    fn seen_along_the_z_axis_every_pixel_is_met() {
        for e1 in EXPONENTS {
            for e2 in EXPONENTS {
                let shape = Superellipsoid::new([1.0, 0.7, 0.8], [e1, e2]).unwrap();
                let placement = Placement { centre: [32.0, 32.0], depth: 2.0, pixel: 0.04 };
                let [mut expected, mut found] = [(); 2].map(|()| ZBuffer::new(65, 65).unwrap());
                write_heights(&mut expected, &shape, &placement);
                // The camera looks down on the model: z forward is the model's z backward.
                let camera_from_model =
                    Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI);
                scatter(&mut found, &shape, &camera_from_model, &placement, |_, _| {});
                for (expected, found) in expected.depths().iter().zip(found.depths()) {
                    assert!(found.is_finite() || !expected.is_finite(), "{e1} {e2}");
                }
            }
        }
    }

    #[test]
    fn the_points_told_are_those_seen() {
        let shape = Superellipsoid::new([1.0, 0.7, 0.8], [0.3, 1.2]).unwrap();
        let camera_from_model = Rotation3::from_euler_angles(0.4, 1.0, -2.0);
        let placement = Placement { centre: [40.3, 29.8], depth: 2.0, pixel: 0.05 };
        let mut buffer = ZBuffer::new(80, 60).unwrap();
        let mut seen = vec![None; 80 * 60];
        scatter(&mut buffer, &shape, &camera_from_model, &placement, |index, x| {
            seen[index] = Some(*x);
        });
        let filled = seen.iter().flatten().count();
        assert!(filled > 500, "{filled}");
        for (index, (depth, x_model)) in buffer.depths().iter().zip(&seen).enumerate() {
            assert_eq!(depth.is_finite(), x_model.is_some());
            let Some(x_model) = x_model else { continue };
            let x_camera = camera_from_model * x_model;
            assert!((shape.gauge(x_model) - 1.0).abs() < 1e-13);
            assert!((f64::from(*depth) - 2.0 - x_camera.z).abs() < 1e-6);
            let pixel = [40.3 + x_camera.x / 0.05, 29.8 + x_camera.y / 0.05];
            let middle = [(index % 80) as f64, (index / 80) as f64];
            assert!(pixel.iter().zip(middle).all(|(at, middle)| (at - middle).abs() <= 0.5));
            // Nearer than the centre's plane: what is behind is hidden.
            let normal = camera_from_model * shape.gauge_gradient(x_model);
            assert!(normal.z < 0.3 * normal.norm(), "{normal}");
        }
    }
}
