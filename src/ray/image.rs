//! Renderings as image files.

use std::io::{self, Write};

use png::{BitDepth, ColorType, Encoder};

use super::render::Rendering;

/// Greatest number of 16 bits.
const GREATEST_COUNT: f64 = 65_535.0;

impl Rendering {
    /// Writes the depths as PNG of 16 bits, in counts of `unit`; 0 where nothing is hit.
    ///
    /// # Errors
    /// If `writer` fails, or a depth is more than 65,535 units.
    pub fn write_depth_png(&self, unit: f64, writer: impl Write) -> io::Result<()> {
        let count = |depth: &f64| {
            let count = (depth / unit).round();
            if count > GREATEST_COUNT {
                let message = format!("a depth of {depth} is more than 65535 units of {unit}");
                return Err(io::Error::new(io::ErrorKind::InvalidData, message));
            }
            // What is hit is not 0, however near.
            Ok(if *depth > 0.0 { count.max(1.0) as u16 } else { 0 })
        };
        let counts = self.depths.iter().map(count).collect::<io::Result<Vec<u16>>>()?;
        let bytes: Vec<u8> = counts.into_iter().flat_map(u16::to_be_bytes).collect();
        write_png(writer, self.size, ColorType::Grayscale, BitDepth::Sixteen, &bytes)
    }

    /// Writes the depths as NPY, an array of doubles of shape (rows, columns).
    ///
    /// # Errors
    /// If `writer` fails.
    pub fn write_depth_npy(&self, mut writer: impl Write) -> io::Result<()> {
        let [width, height] = self.size;
        let mut header =
            format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({height}, {width}), }}");
        // Magic, version, length and header fill whole lines of 64 bytes (NumPy's format 1.0).
        let padding = 63 - (10 + header.len()) % 64;
        header.extend(std::iter::repeat_n(' ', padding));
        header.push('\n');
        writer.write_all(b"\x93NUMPY\x01\x00")?;
        writer.write_all(&(header.len() as u16).to_le_bytes())?;
        writer.write_all(header.as_bytes())?;
        self.depths.iter().try_for_each(|depth| writer.write_all(&depth.to_le_bytes()))
    }

    /// Writes the normals as PNG: red, green and blue are x, y and z of the camera's frame, -1 at
    /// 0, 1 at 255; black where nothing is hit.
    ///
    /// # Errors
    /// If `writer` fails.
    pub fn write_normals_png(&self, writer: impl Write) -> io::Result<()> {
        let pixel = |(depth, normal): (&f64, &nalgebra::Vector3<f64>)| {
            let shade = |part: f64| (127.5 * (part + 1.0)).round().clamp(0.0, 255.0) as u8;
            if *depth == 0.0 { [0; 3] } else { [normal.x, normal.y, normal.z].map(shade) }
        };
        let bytes: Vec<u8> = self.depths.iter().zip(&self.normals).flat_map(pixel).collect();
        self.write_picture(&bytes, writer)
    }

    /// Writes a picture of the rendering's size, red, green and blue of every pixel, as PNG.
    ///
    /// # Errors
    /// If `writer` fails.
    pub fn write_picture(&self, picture: &[u8], writer: impl Write) -> io::Result<()> {
        write_png(writer, self.size, ColorType::Rgb, BitDepth::Eight, picture)
    }
}

fn write_png(
    writer: impl Write,
    [width, height]: [u32; 2],
    color: ColorType,
    depth: BitDepth,
    bytes: &[u8],
) -> io::Result<()> {
    let mut encoder = Encoder::new(writer, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut image = encoder.write_header()?;
    image.write_image_data(bytes)?;
    Ok(image.finish()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud;
    use nalgebra::Vector3;
    use std::io::Cursor;

    fn rendering() -> Rendering {
        let depths = vec![0.0, 1.5, 2.0001, 1e-9, 0.25, 0.0];
        let normals =
            depths.iter().map(|depth| if *depth > 0.0 { -Vector3::z() } else { Vector3::zeros() });
        Rendering { size: [3, 2], normals: normals.collect(), solids: vec![0; 6], depths }
    }

    fn decoded(bytes: Vec<u8>) -> (png::OutputInfo, Vec<u8>) {
        let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        (reader.next_frame(&mut pixels).unwrap(), pixels)
    }

    #[test]
    fn depths_come_back_from_png_in_counts() {
        let mut bytes = Vec::new();
        rendering().write_depth_png(1e-3, &mut bytes).unwrap();
        let (info, pixels) = decoded(bytes);
        assert_eq!((info.width, info.height, info.bit_depth), (3, 2, BitDepth::Sixteen));
        let counts: Vec<u16> =
            pixels.chunks(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect();
        assert_eq!(counts, [0, 1500, 2000, 1, 250, 0]);
        assert!(rendering().write_depth_png(1e-5, &mut Vec::new()).is_err());
    }

    #[test]
    fn depths_come_back_from_npy_exactly() {
        let mut bytes = Vec::new();
        rendering().write_depth_npy(&mut bytes).unwrap();
        assert_eq!(bytes.len() % 64, 6 * 8);
        // Two rows of three numbers are two points to a reader of clouds.
        let cloud = cloud::read_stream("depths", Cursor::new(bytes)).unwrap();
        let points: Vec<[f64; 3]> = cloud.points().collect();
        assert_eq!(points, [[0.0, 1.5, 2.0001], [1e-9, 0.25, 0.0]]);
    }

    #[test]
    fn normals_are_colours() {
        let mut bytes = Vec::new();
        rendering().write_normals_png(&mut bytes).unwrap();
        let (_, pixels) = decoded(bytes);
        assert_eq!(&pixels[..6], [0, 0, 0, 128, 128, 0]);
    }
}
