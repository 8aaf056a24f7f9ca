//! Light on a rendering (Lambert 1760, Phong 1975).

use nalgebra::Vector3;

use super::render::{Rays, Rendering};

/// A light from far away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Towards the light, in the camera's frame, of unit length.
    pub direction: Vector3<f64>,
    /// Its strength: 1 lights a surface that faces it fully.
    pub strength: f64,
}

/// Lights and a material: the brightness of a surface is `ambient + sum strength (diffuse n.l +
/// specular (r.v)^shininess)`, r being the light's mirrored direction and v that of the viewer.
#[derive(Debug, Clone, PartialEq)]
pub struct Shading {
    /// The lights.
    pub lights: Vec<Light>,
    /// Red, green and blue of the material, each from 0 to 1.
    pub color: [f64; 3],
    /// Share of the light that comes from everywhere.
    pub ambient: f64,
    /// Share that is scattered evenly (Lambert).
    pub diffuse: f64,
    /// Share that is mirrored, in white (Phong); 0 is a matt surface.
    pub specular: f64,
    /// How sharply it is mirrored.
    pub shininess: f64,
    /// Red, green and blue where nothing is hit.
    pub background: [u8; 3],
}

impl Default for Shading {
    /// Three lights, from the upper left, the right and behind the camera, on blue plastic.
    fn default() -> Self {
        let lights = [([-0.5, -0.7, -0.6], 0.7), ([0.9, 0.1, -0.5], 0.3), ([0.0, 0.0, -1.0], 0.25)];
        let light = |(direction, strength)| Light {
            direction: Vector3::from(direction).normalize(),
            strength,
        };
        Self {
            lights: lights.map(light).into(),
            color: [0.45, 0.62, 0.85],
            ambient: 0.12,
            diffuse: 0.85,
            specular: 0.3,
            shininess: 30.0,
            background: [255; 3],
        }
    }
}

impl Shading {
    /// The picture of a rendering by the camera that it was made with: red, green and blue of
    /// every pixel, row by row.
    pub fn picture(&self, rendering: &Rendering, camera: &impl Rays) -> Vec<u8> {
        let width = rendering.size[0];
        let pixel = |(index, normal): (usize, &Vector3<f64>)| {
            let [column, row] = [index as u32 % width, index as u32 / width];
            let ray = camera.ray(f64::from(column), f64::from(row));
            match ray.filter(|_| rendering.depths[index] != 0.0) {
                Some(ray) => self.color(normal, &-ray.direction.normalize()),
                None => self.background,
            }
        };
        rendering.normals.iter().enumerate().flat_map(pixel).collect()
    }

    /// The colour of a surface of a unit normal, seen from a direction of unit length.
    fn color(&self, normal: &Vector3<f64>, viewer: &Vector3<f64>) -> [u8; 3] {
        let (mut scattered, mut mirrored) = (self.ambient, 0.0);
        for light in &self.lights {
            let facing = normal.dot(&light.direction);
            if facing > 0.0 {
                let mirror = 2.0 * facing * normal - light.direction;
                scattered += light.strength * self.diffuse * facing;
                let towards = mirror.dot(viewer).max(0.0);
                mirrored += light.strength * self.specular * towards.powf(self.shininess);
            }
        }
        self.color
            .map(|share| (255.0 * (share * scattered + mirrored)).round().clamp(0.0, 255.0) as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shading(specular: f64) -> Shading {
        let lights = vec![Light { direction: -Vector3::z(), strength: 1.0 }];
        let [color, background] = [[1.0, 0.5, 0.0], [0.0; 3]];
        let background = background.map(|part: f64| part as u8);
        Shading { lights, color, ambient: 0.0, diffuse: 0.8, specular, shininess: 20.0, background }
    }

    #[test]
    fn matt_surfaces_follow_the_cosine_from_wherever_they_are_seen() {
        for angle in [0.0_f64, 0.4, 1.0, 1.5] {
            let normal = Vector3::new(angle.sin(), 0.0, -angle.cos());
            let expected = [204.0, 102.0, 0.0].map(|part| (part * angle.cos()).round() as u8);
            for viewer in [-Vector3::z(), Vector3::x()] {
                assert_eq!(shading(0.0).color(&normal, &viewer), expected);
            }
        }
        assert_eq!(shading(0.5).color(&Vector3::z(), &-Vector3::z()), [0, 0, 0]);
    }

    #[test]
    fn the_mirrored_light_is_brightest_where_it_is_mirrored_to() {
        let normal = Vector3::new(0.3, 0.0, -1.0).normalize();
        let mirror = 2.0 * normal.dot(&-Vector3::z()) * normal + Vector3::z();
        let blue = |viewer: Vector3<f64>| shading(0.6).color(&normal, &viewer.normalize())[2];
        assert_eq!(blue(mirror), 153);
        assert!(blue(mirror + 0.1 * Vector3::y()) < 153 && blue(-Vector3::z()) < blue(mirror));
    }
}
