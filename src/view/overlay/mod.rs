//! A model drawn over a picture of it, for a person to judge.

mod canvas;
mod residuals;

use std::io::{self, Write};
use std::path::Path;

use nalgebra::Vector3;
use png::{BitDepth, ColorType, Encoder, Transformations};

use super::camera::Camera;
use super::contour::Contour;
use super::error::{ImageError, ImageProblem};
use super::image::read_png;
use super::rim::RimError;
use super::wireframe::Wireframe;
use crate::cloud::PointCloud;
use crate::model::Model;
use canvas::{Canvas, Pen};

const CONTOUR: Pen = Pen { color: [255, 225, 0, 255], width: 1.8, dash: None };
const VISIBLE: Pen = Pen { color: [255, 255, 255, 190], width: 0.8, dash: None };
const HIDDEN: Pen = Pen { color: [255, 255, 255, 90], width: 0.6, dash: Some(4.0) };
const AXES: [Pen; 3] = [
    Pen { color: [255, 70, 70, 255], width: 1.6, dash: None },
    Pen { color: [70, 220, 70, 255], width: 1.6, dash: None },
    Pen { color: [90, 140, 255, 255], width: 1.6, dash: None },
];

/// How far the axes reach, in semi-axes.
const AXIS_REACH: f64 = 1.3;

/// A picture of a camera.
pub struct Picture {
    canvas: Canvas,
    camera: Camera,
}

impl Picture {
    /// Reads a PNG image of any kind, as a camera has taken it.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged, or is not of the camera's size.
    pub fn read(path: impl AsRef<Path>, camera: Camera) -> Result<Self, ImageError> {
        let path = path.as_ref();
        let read = || {
            let to_bytes = Transformations::EXPAND | Transformations::STRIP_16;
            let pixels = read_png(path, to_bytes)?;
            let expected = [camera.width, camera.height];
            if pixels.size != expected {
                let of = "the camera's file";
                return Err(ImageProblem::Size { expected, found: pixels.size, of });
            }
            Canvas::new(&pixels)
        };
        let canvas = read().map_err(|problem| ImageError::new(path, problem))?;
        Ok(Self { canvas, camera })
    }

    /// Draws points of the camera's frame, coloured by their distance from the model, its hidden
    /// and visible lines, its occluding contour, which is the image of its rim, and its axes x, y,
    /// z in red, green and blue. The model is given in the camera's frame too.
    ///
    /// # Errors
    /// If the model has no contour.
    pub fn draw(
        &mut self,
        model_camera: &Model,
        points_camera: &PointCloud,
    ) -> Result<(), RimError> {
        let contour = Contour::of(model_camera, &self.camera)?;
        let wireframe = Wireframe::of(model_camera, &self.camera);
        residuals::draw(&mut self.canvas, points_camera, model_camera, &self.camera);
        wireframe.hidden.iter().for_each(|line| self.canvas.line(line, false, HIDDEN));
        wireframe.visible.iter().for_each(|line| self.canvas.line(line, false, VISIBLE));
        self.canvas.line(contour.polygon(), true, CONTOUR);
        self.draw_axes(model_camera);
        Ok(())
    }

    fn draw_axes(&mut self, model_camera: &Model) {
        for (axis, pen) in AXES.into_iter().enumerate() {
            let mut end = Vector3::zeros();
            end[axis] = AXIS_REACH * model_camera.shape.size()[axis];
            let ends = [Vector3::zeros(), end].map(|x| model_camera.pose.world_from_model(&x));
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
