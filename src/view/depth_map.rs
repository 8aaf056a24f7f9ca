//! Depth maps: what a range camera sees, pixel by pixel.

use std::path::Path;

use png::{BitDepth, ColorType, Transformations};

use super::camera::Camera;
use super::error::{ImageError, ImageProblem};
use super::image::read_png;
use super::mask::Mask;
use crate::cloud::PointCloud;
use crate::recover::{Sight, SightLine};

/// Steps from the mask between which rays beside the object are looked along: beyond what a mask
/// may be wrong by, near enough to hold the outline.
const BESIDE: std::ops::RangeInclusive<u32> = 4..=12;

/// Pixels along the mask's outline that are left out.
const RIM: u32 = 2;

/// Most rays beside the object: so many hold its outline as well as all.
const RAYS_BESIDE: usize = 200;

/// How far around the object its surroundings reach, in the greater side of the mask's box.
const SURROUNDINGS: f64 = 0.5;

/// A depth map in its camera's frame, in metres, and which of its pixels are the object's.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthMap {
    camera: Camera,
    /// Metres along z, row by row; 0 where there is none.
    depths: Vec<f64>,
    mask: Option<Mask>,
}

impl DepthMap {
    /// Reads a PNG image of 16 bits a pixel, a count of `depth_unit` metres each, 0 where there is
    /// no depth; and the object's mask. By default the unit is the camera's.
    ///
    /// # Errors
    /// If a file cannot be read, is damaged, of another kind or size than the camera's, if no unit
    /// is known, or no pixel of the object has a depth.
    pub fn read(
        path: impl AsRef<Path>,
        camera: Camera,
        mask: Option<&Path>,
        depth_unit: Option<f64>,
    ) -> Result<Self, ImageError> {
        let path = path.as_ref();
        let about = |problem| ImageError::new(path, problem);
        let unit = depth_unit.or(camera.depth_unit);
        let unit = unit.ok_or_else(|| about(ImageProblem::NoDepthUnit))?;
        let counts = read_counts(path, [camera.width, camera.height]).map_err(about)?;
        let read_mask = |path: &Path| {
            let mask = Mask::read(path)?;
            let of_size = mask.require_size([camera.width, camera.height]);
            of_size.map(|()| mask).map_err(|problem| ImageError::new(path, problem))
        };
        let mask = mask.map(read_mask).transpose()?;
        let depths = counts.into_iter().map(|count| f64::from(count) * unit).collect();
        let map = Self { camera, depths, mask };
        if map.object_pixels(map.mask.as_ref()).next().is_none() {
            return Err(about(ImageProblem::NoObject));
        }
        Ok(map)
    }

    /// The camera.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Depth along z of each pixel, in metres, row by row; 0 where there is none.
    pub fn depths(&self) -> &[f64] {
        &self.depths
    }

    /// The points of the object, in the camera's frame.
    pub fn object_points(&self) -> PointCloud {
        self.points_of(self.mask.as_ref())
    }

    /// The points of the object in the camera's frame, but for the rim of the mask: there a pixel
    /// may mix the depths of both sides, and masks are wrong by a pixel or two. All of them where
    /// the rim is most of the object.
    pub fn inner_points(&self) -> PointCloud {
        let inner = self.mask.as_ref().map(|mask| mask.without_rim(RIM));
        let points = self.points_of(inner.as_ref());
        let all = self.object_points();
        if 2 * points.len() < all.len() { all } else { points }
    }

    fn points_of(&self, mask: Option<&Mask>) -> PointCloud {
        self.object_pixels(mask).filter_map(|pixel| self.point(pixel)).collect()
    }

    /// Where the camera stood and what it saw beside the object. Without a mask it saw nothing
    /// else.
    pub fn sight(&self) -> Sight {
        let mut sight = Sight::from_viewpoint([0.0; 3]);
        if let Some(mask) = &self.mask {
            let distances = mask.distances();
            let beside: Vec<usize> = (0..self.depths.len())
                .filter(|&pixel| BESIDE.contains(&distances[pixel]) && self.depths[pixel] > 0.0)
                .collect();
            let count = beside.len().min(RAYS_BESIDE);
            let chosen = (0..count).map(|i| beside[i * beside.len() / count]);
            sight.free = chosen.filter_map(|pixel| self.line(pixel)).collect();
        }
        sight
    }

    /// Points around the object that are not of it, in the camera's frame; none without a mask.
    pub fn surroundings(&self) -> PointCloud {
        let Some(mask) = &self.mask else { return PointCloud::new() };
        let reach = (SURROUNDINGS * f64::from(self.mask_side(mask))).ceil() as u32;
        let distances = mask.distances();
        let is_around = |pixel: &usize| {
            let is_beside = distances[*pixel] >= *BESIDE.start() && distances[*pixel] <= reach;
            is_beside && self.depths[*pixel] > 0.0
        };
        (0..self.depths.len()).filter(is_around).filter_map(|pixel| self.point(pixel)).collect()
    }

    /// The greater side of the mask's box, in pixels.
    fn mask_side(&self, mask: &Mask) -> u32 {
        let (mut low, mut high) = ([u32::MAX; 2], [0; 2]);
        let objects = mask.is_object().iter().enumerate().filter(|(_, is_object)| **is_object);
        for (pixel, _) in objects {
            for (k, place) in self.place(pixel).into_iter().enumerate() {
                low[k] = low[k].min(place);
                high[k] = high[k].max(place);
            }
        }
        (0..2).map(|k| high[k].saturating_sub(low[k]) + 1).max().unwrap_or(0)
    }

    /// Pixels of a mask, or of the image, that have a depth.
    fn object_pixels<'a>(&'a self, mask: Option<&'a Mask>) -> impl Iterator<Item = usize> + 'a {
        let is_object = mask.map(Mask::is_object);
        (0..self.depths.len()).filter(move |&pixel| {
            self.depths[pixel] > 0.0 && is_object.is_none_or(|is_object| is_object[pixel])
        })
    }

    /// Column and row of a pixel.
    fn place(&self, pixel: usize) -> [u32; 2] {
        let width = self.camera.width as usize;
        [pixel % width, pixel / width].map(|place| place as u32)
    }

    fn ray(&self, pixel: usize) -> Option<[f64; 3]> {
        let [column, row] = self.place(pixel).map(f64::from);
        self.camera.ray(column, row)
    }

    /// The point seen in a pixel; none where distortion lets no ray through.
    fn point(&self, pixel: usize) -> Option<[f64; 3]> {
        Some(self.ray(pixel)?.map(|along| along * self.depths[pixel]))
    }

    /// The line of sight to the point seen in a pixel.
    fn line(&self, pixel: usize) -> Option<SightLine> {
        let direction = self.ray(pixel)?;
        let length = direction.iter().map(|along| along * along).sum::<f64>().sqrt();
        Some(SightLine { direction, reach: self.depths[pixel] * length })
    }
}

/// The counts of a depth map of that size, row by row.
fn read_counts(path: &Path, expected: [u32; 2]) -> Result<Vec<u16>, ImageProblem> {
    let pixels = read_png(path, Transformations::IDENTITY)?;
    if (pixels.color, pixels.depth) != (ColorType::Grayscale, BitDepth::Sixteen) {
        let bits = pixels.depth as u8;
        return Err(ImageProblem::NotDepth(format!("{bits} bits of {:?}", pixels.color)));
    }
    if pixels.size != expected {
        return Err(ImageProblem::Size { expected, found: pixels.size, of: "the camera's file" });
    }
    let count = |bytes: &[u8]| u16::from_be_bytes([bytes[0], bytes[1]]);
    Ok(pixels.bytes.chunks_exact(2).map(count).collect())
}
