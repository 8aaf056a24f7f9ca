//! A picture of panels, with lines, dots and shaded solids.

use std::error::Error;
use std::fs::File;
use std::path::Path;

use tiny_skia::{Color, FillRule, LineJoin, Paint, PathBuilder, Pixmap, Stroke, Transform};

/// A colour without transparency: red, green, blue.
pub type Rgb = [u8; 3];

pub const INK: Rgb = [40, 44, 52];
pub const PALE: Rgb = [205, 208, 214];
pub const BLUE: Rgb = [46, 102, 178];

/// A white picture that is drawn on in pixels, from the upper left.
pub struct Picture {
    pixels: Pixmap,
}

impl Picture {
    /// A picture of so many columns and rows, both above 0.
    pub fn new(columns: u32, rows: u32) -> Self {
        let mut pixels = Pixmap::new(columns, rows).expect("columns and rows are above 0");
        pixels.fill(Color::WHITE);
        Self { pixels }
    }

    /// A line through points.
    pub fn line(&mut self, points: &[[f64; 2]], width: f32, color: Rgb) {
        let Some(path) = path(points, false) else { return };
        let stroke = Stroke { width, line_join: LineJoin::Round, ..Stroke::default() };
        self.pixels.stroke_path(&path, &paint(color), &stroke, Transform::identity(), None);
    }

    /// A filled polygon.
    pub fn polygon(&mut self, points: &[[f64; 2]], color: Rgb) {
        let Some(path) = path(points, true) else { return };
        let rule = FillRule::Winding;
        self.pixels.fill_path(&path, &paint(color), rule, Transform::identity(), None);
    }

    /// A disc.
    pub fn dot(&mut self, [x, y]: [f64; 2], radius: f32, color: Rgb) {
        let Some(path) = PathBuilder::from_circle(x as f32, y as f32, radius) else { return };
        let rule = FillRule::Winding;
        self.pixels.fill_path(&path, &paint(color), rule, Transform::identity(), None);
    }

    /// Lays a colour over a pixel of the picture, covering a share of it.
    pub fn cover(&mut self, [column, row]: [usize; 2], color: [f64; 3], share: f64) {
        let place = 4 * (row * self.pixels.width() as usize + column);
        let pixel = &mut self.pixels.data_mut()[place..place + 3];
        for (channel, color) in pixel.iter_mut().zip(color) {
            let mixed = f64::from(*channel) * (1.0 - share) + 255.0 * color * share;
            *channel = mixed.round() as u8;
        }
    }

    /// Writes the picture as PNG.
    pub fn save(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        let [columns, rows] = [self.pixels.width(), self.pixels.height()];
        let mut encoder = png::Encoder::new(File::create(path)?, columns, rows);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::High);
        let opaque: Vec<u8> =
            self.pixels.data().chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect();
        encoder.write_header()?.write_image_data(&opaque)?;
        Ok(())
    }
}

fn path(points: &[[f64; 2]], is_closed: bool) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    let ([x, y], rest) = points.split_first()?;
    builder.move_to(*x as f32, *y as f32);
    rest.iter().for_each(|[x, y]| builder.line_to(*x as f32, *y as f32));
    if is_closed {
        builder.close();
    }
    builder.finish()
}

fn paint(color: Rgb) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color_rgba8(color[0], color[1], color[2], 255);
    paint
}

/// A square part of a picture, with coordinates from -1 to 1 along both axes, y upwards.
#[derive(Clone, Copy)]
pub struct Panel {
    /// Pixels of the upper left corner.
    pub corner: [usize; 2],
    /// Pixels along each side.
    pub side: usize,
}

impl Panel {
    /// The panels of a grid, row by row.
    pub fn grid(columns: usize, rows: usize, side: usize) -> Vec<Self> {
        let corner = |i: usize| [i % columns * side, i / columns * side];
        (0..columns * rows).map(|i| Self { corner: corner(i), side }).collect()
    }

    /// The place in the picture of a point of the panel.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let half = 0.5 * self.side as f64;
        [self.corner[0] as f64 + half * (1.0 + x), self.corner[1] as f64 + half * (1.0 - y)]
    }

    /// Places of many points.
    pub fn places(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.iter().map(|&point| self.place(point)).collect()
    }

    /// Draws both axes.
    pub fn axes(&self, picture: &mut Picture) {
        picture.line(&self.places(&[[-0.95, 0.0], [0.95, 0.0]]), 1.0, PALE);
        picture.line(&self.places(&[[0.0, -0.95], [0.0, 0.95]]), 1.0, PALE);
    }
}
