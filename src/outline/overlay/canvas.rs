//! A picture that lines, dots and words can be drawn on, legible on any ground.

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::text::{Baseline, Text};
use tiny_skia::{
    Color, FillRule, IntSize, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Rect, Stroke,
    StrokeDash, Transform,
};

use crate::view::{ImageProblem, Pixels};

/// Side, in pixels, of an image whose lines are as wide as they are given.
const PLAIN_SIDE: f32 = 800.0;

/// Width of the dark seam on either side of a line, in widths of the line.
const SEAM: f32 = 0.6;

/// How a line looks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pen {
    /// Red, green, blue, opacity.
    pub color: [u8; 4],
    pub width: f32,
    /// Length of dashes and gaps; none for a whole line.
    pub dash: Option<f32>,
}

/// A picture without transparency.
pub(super) struct Canvas {
    pixmap: Pixmap,
    /// Widths and lengths in the picture to those given.
    scale: f32,
}

impl Canvas {
    /// A canvas with a picture on it: 8 bits a channel, with or without colour and opacity.
    pub fn new(picture: &Pixels) -> Result<Self, ImageProblem> {
        let [width, height] = picture.size;
        let channels = picture.color.samples();
        let opaque = |pixel: &[u8]| match pixel {
            [gray] | [gray, _] => [*gray, *gray, *gray, 255],
            [red, green, blue, ..] => [*red, *green, *blue, 255],
            [] => [0, 0, 0, 255],
        };
        let bytes = picture.bytes.chunks_exact(channels).flat_map(opaque).collect();
        let size = IntSize::from_wh(width, height);
        let pixmap = size.and_then(|size| Pixmap::from_vec(bytes, size));
        let found = u64::from(width) * u64::from(height);
        let pixmap = pixmap.ok_or(ImageProblem::TooLarge { found, most: u64::from(u32::MAX) })?;
        let scale = (width.max(height) as f32 / PLAIN_SIDE).max(1.0);
        Ok(Self { pixmap, scale })
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        [self.pixmap.width(), self.pixmap.height()]
    }

    /// Pixels to a unit of length on the canvas.
    pub fn scale(&self) -> f32 {
        self.scale
    }

    /// Draws a line through pixels, whose centres are at integers; a closed one back to its start.
    pub fn line(&mut self, pixels: &[[f64; 2]], is_closed: bool, pen: Pen) {
        let Some(path) = path(pixels, is_closed) else { return };
        let seam = [0, 0, 0, pen.color[3] / 2];
        self.stroke(&path, Pen { color: seam, width: (1.0 + 2.0 * SEAM) * pen.width, ..pen });
        self.stroke(&path, pen);
    }

    /// Draws a dot with a dark rim.
    pub fn dot(&mut self, [column, row]: [f64; 2], radius: f32, color: [u8; 3]) {
        let radius = radius * self.scale;
        let [x, y] = [column, row].map(|at| at as f32);
        let [red, green, blue] = color;
        for (radius, color) in [(radius * 1.4, [0, 0, 0, 90]), (radius, [red, green, blue, 255])] {
            if let Some(circle) = PathBuilder::from_circle(x, y, radius) {
                self.pixmap.fill_path(&circle, &paint(color), FillRule::Winding, centres(), None);
            }
        }
    }

    /// Fills a box given in pixels' corners.
    pub fn fill(&mut self, [x, y]: [f32; 2], [width, height]: [f32; 2], color: [u8; 4]) {
        if let Some(rect) = Rect::from_xywh(x, y, width, height) {
            self.pixmap.fill_rect(rect, &paint(color), Transform::identity(), None);
        }
    }

    /// Writes white words, the upper left corner in a pixel.
    pub fn write(&mut self, words: &str, [x, y]: [f32; 2]) {
        let mut target = Letters { corner: [x, y], zoom: self.letter_zoom(), canvas: self };
        let style = MonoTextStyle::new(&FONT_10X20, BinaryColor::On);
        let text = Text::with_baseline(words, Point::zero(), style, Baseline::Top);
        // Drawing on a canvas does not fail.
        let _ = text.draw(&mut target);
    }

    /// Width and height of so many letters.
    pub fn letters(&self, count: usize) -> [f32; 2] {
        [10.0 * count as f32 * self.letter_zoom(), 20.0 * self.letter_zoom()]
    }

    /// Pixels to a pixel of a letter.
    fn letter_zoom(&self) -> f32 {
        self.scale.round().max(1.0)
    }

    /// Red, green and blue of all pixels, row by row.
    pub fn into_rgb(self) -> Vec<u8> {
        // All is opaque: nothing was multiplied.
        self.pixmap
            .data()
            .chunks_exact(4)
            .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
            .collect()
    }

    fn stroke(&mut self, path: &Path, pen: Pen) {
        let width = pen.width * self.scale;
        let dash = pen.dash.map(|length| length * self.scale);
        let stroke = Stroke {
            width,
            line_cap: if dash.is_some() { LineCap::Butt } else { LineCap::Round },
            line_join: LineJoin::Round,
            dash: dash.and_then(|length| StrokeDash::new(vec![length, length], 0.0)),
            ..Stroke::default()
        };
        self.pixmap.stroke_path(path, &paint(pen.color), &stroke, centres(), None);
    }
}

/// From pixels with centres at integers to those with corners at integers.
fn centres() -> Transform {
    Transform::from_translate(0.5, 0.5)
}

fn paint([red, green, blue, opacity]: [u8; 4]) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(Color::from_rgba8(red, green, blue, opacity));
    paint
}

fn path(pixels: &[[f64; 2]], is_closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for (i, [column, row]) in pixels.iter().enumerate() {
        let [x, y] = [*column as f32, *row as f32];
        if i == 0 { builder.move_to(x, y) } else { builder.line_to(x, y) }
    }
    if is_closed {
        builder.close();
    }
    builder.finish()
}

/// Where the pixels of letters go.
struct Letters<'c> {
    corner: [f32; 2],
    zoom: f32,
    canvas: &'c mut Canvas,
}

impl OriginDimensions for Letters<'_> {
    fn size(&self) -> Size {
        let [width, height] = self.canvas.size();
        Size::new(width, height)
    }
}

impl DrawTarget for Letters<'_> {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = embedded_graphics::Pixel<Self::Color>>,
    {
        for embedded_graphics::Pixel(at, color) in pixels {
            if color.is_on() {
                let x = self.corner[0] + self.zoom * at.x as f32;
                let y = self.corner[1] + self.zoom * at.y as f32;
                self.canvas.fill([x, y], [self.zoom; 2], [255; 4]);
            }
        }
        Ok(())
    }
}
