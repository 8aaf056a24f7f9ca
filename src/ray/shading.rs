//! Light on a rendering (Lambert 1760, Phong 1975).

use nalgebra::Vector3;

use super::render::{Rays, Rendering};
use crate::pose::Pose;

/// Where light comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// From far away: the unit vector towards it.
    Far(Vector3<f64>),
    /// From a point; its light falls with the square of the distance, and is of full power at a
    /// distance of 1.
    Near(Vector3<f64>),
}

/// A light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Where it is, in the frame of what it lights.
    pub source: Source,
    /// Its red, green and blue: 1 lights a surface that faces it fully.
    pub power: [f64; 3],
}

impl Light {
    /// The light after a motion.
    pub fn moved(&self, motion: &Pose) -> Self {
        let source = match &self.source {
            Source::Far(to_light) => Source::Far(motion.rotation() * to_light),
            Source::Near(position) => Source::Near(motion.world_from_model(position)),
        };
        Self { source, ..*self }
    }

    /// The unit vector towards the light from a point, and the share of its power that arrives.
    fn at(&self, x: &Vector3<f64>) -> (Vector3<f64>, f64) {
        match self.source {
            Source::Far(to_light) => (to_light, 1.0),
            Source::Near(position) => {
                let offset = position - x;
                let distance = offset.norm();
                (offset / distance, distance.powi(-2))
            }
        }
    }
}

/// How a surface takes light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Red, green and blue, each from 0 to 1.
    pub color: [f64; 3],
    /// Share that is scattered evenly (Lambert).
    pub diffuse: f64,
    /// Share that is mirrored, in the light's own colour (Phong); 0 is a matt surface.
    pub specular: f64,
    /// How sharply it is mirrored.
    pub shininess: f64,
}

impl Default for Material {
    /// Blue plastic.
    fn default() -> Self {
        Self { color: [0.45, 0.62, 0.85], diffuse: 0.85, specular: 0.3, shininess: 30.0 }
    }
}

/// Lights and what is lit.
///
/// The brightness of a surface is `color (ambient + sum of power diffuse n.l) + sum of power specular
/// (r.v)^shininess`, r being the light's mirrored direction and v that of the viewer. Nothing casts
/// a shadow.
#[derive(Debug, Clone, PartialEq)]
pub struct Shading {
    /// The lights, in the camera's frame.
    pub lights: Vec<Light>,
    /// Red, green and blue of the light that comes from everywhere.
    pub ambient: [f64; 3],
    /// What the solids are made of, in their order.
    pub materials: Vec<Material>,
    /// Red, green and blue where nothing is hit.
    pub background: [u8; 3],
}

impl Default for Shading {
    /// Three lights, from the upper left, the right and behind the camera, on one solid.
    fn default() -> Self {
        let lights = [([-0.5, -0.7, -0.6], 0.7), ([0.9, 0.1, -0.5], 0.3), ([0.0, 0.0, -1.0], 0.25)];
        let light = |(to_light, power)| Light {
            source: Source::Far(Vector3::from(to_light).normalize()),
            power: [power; 3],
        };
        Self {
            lights: lights.map(light).into(),
            ambient: [0.12; 3],
            materials: vec![Material::default()],
            background: [255; 3],
        }
    }
}

impl Shading {
    /// The picture of a rendering by the camera that it was made with: red, green and blue of
    /// every pixel, row by row. A solid without a material is of the default one.
    pub fn picture(&self, rendering: &Rendering, camera: &impl Rays) -> Vec<u8> {
        let width = rendering.size[0];
        let pixel = |(index, normal): (usize, &Vector3<f64>)| {
            let [column, row] = [index as u32 % width, index as u32 / width];
            let ray = camera.ray(f64::from(column), f64::from(row));
            let depth = rendering.depths[index];
            let Some(ray) = ray.filter(|_| depth != 0.0) else { return self.background };
            let material = self.materials.get(rendering.solids[index]).copied();
            self.color(
                &material.unwrap_or_default(),
                &Seen {
                    // Along a pixel's ray z grows by 1 with t, from 0.
                    position: ray.at(depth),
                    normal: *normal,
                    to_viewer: -ray.direction.normalize(),
                },
            )
        };
        rendering.normals.iter().enumerate().flat_map(pixel).collect()
    }

    /// The colour of a surface.
    fn color(&self, material: &Material, seen: &Seen) -> [u8; 3] {
        let (mut scattered, mut mirrored) = (self.ambient, [0.0; 3]);
        for light in &self.lights {
            let (to_light, share) = light.at(&seen.position);
            let facing = seen.normal.dot(&to_light);
            // Written so that NaN, of a light on the surface, lights nothing.
            if facing > 0.0 {
                let mirror = 2.0 * facing * seen.normal - to_light;
                let towards = mirror.dot(&seen.to_viewer).max(0.0).powf(material.shininess);
                for channel in 0..3 {
                    let power = light.power[channel] * share;
                    scattered[channel] += power * material.diffuse * facing;
                    mirrored[channel] += power * material.specular * towards;
                }
            }
        }
        std::array::from_fn(|channel| {
            let brightness = material.color[channel] * scattered[channel] + mirrored[channel];
            (255.0 * brightness).round().clamp(0.0, 255.0) as u8
        })
    }
}

/// A surface as it is seen.
struct Seen {
    position: Vector3<f64>,
    /// Of unit length, outwards.
    normal: Vector3<f64>,
    /// Of unit length.
    to_viewer: Vector3<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shaded(source: Source, specular: f64, [normal, to_viewer]: [Vector3<f64>; 2]) -> [u8; 3] {
        let material = Material { color: [1.0, 0.5, 0.0], diffuse: 0.8, specular, shininess: 20.0 };
        let lights = vec![Light { source, power: [1.0; 3] }];
        let (ambient, background) = ([0.0; 3], [0; 3]);
        let shading = Shading { lights, ambient, materials: vec![material], background };
        shading.color(&material, &Seen { position: Vector3::zeros(), normal, to_viewer })
    }

    const BEHIND: Source = Source::Far(Vector3::new(0.0, 0.0, -1.0));

    #[test]
    fn matt_surfaces_follow_the_cosine_from_wherever_they_are_seen() {
        for angle in [0.0_f64, 0.4, 1.0, 1.5] {
            let normal = Vector3::new(angle.sin(), 0.0, -angle.cos());
            let expected = [204.0, 102.0, 0.0].map(|part| (part * angle.cos()).round() as u8);
            for viewer in [-Vector3::z(), Vector3::x()] {
                assert_eq!(shaded(BEHIND, 0.0, [normal, viewer]), expected);
            }
        }
        assert_eq!(shaded(BEHIND, 0.5, [Vector3::z(), -Vector3::z()]), [0, 0, 0]);
    }

    #[test]
    fn the_mirrored_light_is_brightest_where_it_is_mirrored_to() {
        let normal = Vector3::new(0.3, 0.0, -1.0).normalize();
        let mirror = 2.0 * normal.dot(&-Vector3::z()) * normal + Vector3::z();
        let blue = |viewer: Vector3<f64>| shaded(BEHIND, 0.6, [normal, viewer.normalize()])[2];
        assert_eq!(blue(mirror), 153);
        assert!(blue(mirror + 0.1 * Vector3::y()) < 153 && blue(-Vector3::z()) < blue(mirror));
    }

    #[test]
    fn near_light_falls_with_the_square_of_the_distance() {
        for distance in [1.0, 2.0, 3.5] {
            let source = Source::Near(Vector3::new(0.0, 0.0, -distance));
            let expected = [204.0, 102.0, 0.0].map(|part: f64| (part / distance.powi(2)).round());
            let found = shaded(source, 0.0, [-Vector3::z(), Vector3::x()]);
            assert_eq!(found.map(f64::from), expected);
        }
        let on_surface = Source::Near(Vector3::zeros());
        assert_eq!(shaded(on_surface, 0.0, [-Vector3::z(), Vector3::x()]), [0; 3]);
    }

    #[test]
    fn lights_move_with_their_frame() {
        let motion = Pose::from_euler_zyz([0.3, 0.7, -0.2], Vector3::new(1.0, 2.0, 3.0));
        let x = Vector3::new(0.4, -0.5, 0.6);
        for source in [Source::Far(Vector3::y()), Source::Near(Vector3::new(3.0, 1.0, -2.0))] {
            let light = Light { source, power: [1.0, 0.5, 0.2] };
            let moved = light.moved(&motion);
            let [(before, share), (after, moved_share)] =
                [light.at(&x), moved.at(&motion.world_from_model(&x))];
            assert!((motion.rotation() * before - after).norm() < 1e-15);
            assert!((share - moved_share).abs() < 1e-15);
            assert_eq!(moved.power, light.power);
        }
    }
}
