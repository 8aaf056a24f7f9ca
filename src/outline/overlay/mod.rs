//! A model drawn over a picture of it, for a person to judge.

mod canvas;
mod residuals;

use std::io::{self, Write};
use std::path::Path;

use png::{BitDepth, ColorType, Encoder, Transformations};

use self::canvas::{Canvas, Pen};
use super::axes::axes;
use super::rim_curve::RimCurve;
use super::silhouette::Outline;
use super::wireframe::Wireframe;
use crate::cloud::PointCloud;
use crate::solid::Tree;
use crate::view::{AnyCamera, ImageError, ImageProblem, Projection, RimError, read_png};

const CONTOUR: Pen = Pen { color: [255, 225, 0, 255], width: 1.8, dash: None };
const VISIBLE: Pen = Pen { color: [255, 255, 255, 190], width: 0.8, dash: None };
const HIDDEN: Pen = Pen { color: [255, 255, 255, 90], width: 0.6, dash: Some(4.0) };
const RIM: Pen = Pen { color: [255, 150, 0, 255], width: 1.2, dash: None };
const HIDDEN_RIM: Pen = Pen { color: [255, 150, 0, 150], width: 0.9, dash: Some(4.0) };
const AXES: [Pen; 3] = [
    Pen { color: [255, 70, 70, 255], width: 1.6, dash: None },
    Pen { color: [70, 220, 70, 255], width: 1.6, dash: None },
    Pen { color: [90, 140, 255, 255], width: 1.6, dash: None },
];

/// A picture of a camera.
pub struct Picture {
    canvas: Canvas,
    camera: AnyCamera,
}

impl Picture {
    /// Reads a PNG image of any kind, as a camera has taken it.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged, or is not of the camera's size.
    pub fn read(path: impl AsRef<Path>, camera: AnyCamera) -> Result<Self, ImageError> {
        let path = path.as_ref();
        let read = || {
            let to_bytes = Transformations::EXPAND | Transformations::STRIP_16;
            let pixels = read_png(path, to_bytes)?;
            let expected = camera.size();
            if pixels.size != expected {
                let of = "the camera's file";
                return Err(ImageProblem::Size { expected, found: pixels.size, of });
            }
            Canvas::new(&pixels)
        };
        let canvas = read().map_err(|problem| ImageError::new(path, problem))?;
        Ok(Self { canvas, camera })
    }

    /// Draws points of the camera's frame, coloured by their distance from a solid, and the
    /// solid, given in the camera's frame too: its hidden and visible lines, its rim, dashed where
    /// it is hidden, its occluding contour, and the axes x, y, z of a solid that is one primitive
    /// in red, green and blue.
    ///
    /// # Errors
    /// If the solid has no contour.
    pub fn draw(
        &mut self,
        solid_camera: &Tree,
        points_camera: &PointCloud,
    ) -> Result<(), RimError> {
        let outline = Outline::of(solid_camera, &self.camera)?;
        let wireframe = Wireframe::of(solid_camera, &self.camera);
        residuals::draw(&mut self.canvas, points_camera, solid_camera, &self.camera);
        wireframe.hidden.iter().for_each(|line| self.canvas.line(line, false, HIDDEN));
        wireframe.visible.iter().for_each(|line| self.canvas.line(line, false, VISIBLE));
        self.draw_rim(outline.rim_camera());
        outline.polygons().iter().for_each(|polygon| self.canvas.line(polygon, true, CONTOUR));
        self.draw_axes(solid_camera);
        Ok(())
    }

    /// What of the rim is hidden, and above it what is seen.
    fn draw_rim(&mut self, curves: &[RimCurve]) {
        for (is_hidden, pen) in [(true, HIDDEN_RIM), (false, RIM)] {
            for run in curves.iter().flat_map(|curve| curve.runs(is_hidden)) {
                let pixels: Option<Vec<_>> = run.iter().map(|x| self.camera.project(x)).collect();
                if let Some(pixels) = pixels {
                    self.canvas.line(&pixels, false, pen);
                }
            }
        }
    }

    fn draw_axes(&mut self, solid_camera: &Tree) {
        let axes = axes(solid_camera).into_iter().flatten();
        for (ends, pen) in axes.zip(AXES) {
            if let [Some(centre), Some(tip)] = ends.map(|x| self.camera.project(&x)) {
                self.canvas.line(&[centre, tip], false, pen);
            }
        }
    }

    /// Writes the picture as PNG, 8 bits a channel.
    ///
    /// # Errors
    /// If `writer` fails.
    pub fn write(self, writer: &mut (impl Write + ?Sized)) -> io::Result<()> {
        let [width, height] = self.canvas.size();
        let mut encoder = Encoder::new(writer, width, height);
        encoder.set_color(ColorType::Rgb);
        encoder.set_depth(BitDepth::Eight);
        let mut image = encoder.write_header()?;
        image.write_image_data(&self.canvas.into_rgb())?;
        Ok(image.finish()?)
    }
}
