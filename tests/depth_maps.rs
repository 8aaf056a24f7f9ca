//! Depth maps with their cameras and masks, of real sensors and damaged.

mod common;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use common::{Scene, shared};
use png::{BitDepth, ColorType, Encoder};
use superquadric::view::{Camera, DepthMap, Mask};
use tempfile::TempDir;

const OBJECTS: [&str; 5] = ["blue_mug", "mustard", "pepper", "sugar", "white_bowl"];

/// A camera of 8 by 6 pixels.
const CAMERA: &str = r#"{"fx": 10, "fy": 11, "cx": 3.5, "cy": 2.5, "width": 8, "height": 6,
    "depth_units_m": 0.001}"#;

fn png(size: [u32; 2], color: ColorType, depth: BitDepth, bytes: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, size[0], size[1]);
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(bytes).expect("an image");
    writer.finish().expect("an end");
    file
}

/// A depth map of 8 by 6 pixels, 1 m in pixel 0 and 1 mm more in each after it.
fn depth_png() -> Vec<u8> {
    let counts: Vec<u8> = (0..48_u16).flat_map(|pixel| (1000 + pixel).to_be_bytes()).collect();
    png([8, 6], ColorType::Grayscale, BitDepth::Sixteen, &counts)
}

/// A folder of files to be read.
struct Files(TempDir);

impl Files {
    fn new() -> Self {
        let files = Self(TempDir::new().expect("a folder"));
        files.write("camera.json", CAMERA.as_bytes());
        files
    }

    fn write(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.path().join(name);
        fs::write(&path, bytes).expect("a written file");
        path
    }

    fn camera(&self) -> Camera {
        Camera::read(self.0.path().join("camera.json")).expect("a camera")
    }

    /// What is said about a depth map of those bytes.
    fn refusal(&self, bytes: &[u8]) -> String {
        let path = self.write("depth.png", bytes);
        let message = DepthMap::read(&path, self.camera(), None, None).unwrap_err().to_string();
        assert!(message.starts_with(path.to_str().unwrap()), "{message}");
        message
    }
}

#[test]
fn points_of_real_depth_maps_are_seen_in_their_masks() {
    let Some(folder) = shared("data/rgbd") else { return };
    let camera = Camera::read(folder.join("intrinsics.json")).expect("a camera");
    for object in OBJECTS {
        let path = |kind: &str| folder.join(format!("{object}_{kind}.png"));
        let mask = Mask::read(path("mask")).expect("a mask");
        let map = DepthMap::read(path("depth"), camera, Some(&path("mask")), None).expect("a map");
        let whole = DepthMap::read(path("depth"), camera, None, Some(1e-4)).expect("a map");
        let points = map.object_points();
        let pixels = mask.is_object().iter().filter(|is_object| **is_object).count();
        assert!(points.len() <= pixels && points.len() > pixels * 8 / 10, "{object}");
        for point in points.points() {
            let [column, row] = camera.project(&point.into()).expect("in front of the camera");
            assert!((column - column.round()).hypot(row - row.round()) < 1e-9);
            assert!(mask.is_object()[row.round() as usize * 640 + column.round() as usize]);
            assert!((0.2..2.0).contains(&point[2]), "{object}: {point:?}");
        }
        assert!(whole.object_points().len() > points.len());
        assert!(map.surroundings().len() > 1000, "{object}");
    }
}

#[test]
fn counts_become_metres_along_the_rays_and_masks_choose_among_them() {
    let files = Files::new();
    let path = files.write("depth.png", &depth_png());
    let map = DepthMap::read(&path, files.camera(), None, None).unwrap();
    assert_eq!(map.object_points().len(), 48);
    let point = map.object_points().point(8 + 6);
    for (found, expected) in point.into_iter().zip([1.014 * 0.25, 1.014 * -1.5 / 11.0, 1.014]) {
        assert!((found - expected).abs() < 1e-15);
    }
    // One bit a pixel, a palette, and colours with opacity: pixels 2 and 3 of each row.
    let masks = [
        png([8, 6], ColorType::Grayscale, BitDepth::One, &[0b0011_0000; 6]),
        png([8, 6], ColorType::Grayscale, BitDepth::Sixteen, &{
            let row = [0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0];
            row.repeat(6)
        }),
        png([8, 6], ColorType::Rgba, BitDepth::Eight, &{
            let (on, off) = ([0, 9, 0, 255], [0, 0, 0, 255]);
            [off, off, on, on, off, off, off, off].concat().repeat(6)
        }),
    ];
    for mask in masks {
        let mask = files.write("mask.png", &mask);
        let map = DepthMap::read(&path, files.camera(), Some(&mask), Some(2e-3)).unwrap();
        let points = map.object_points();
        assert_eq!(points.len(), 12);
        assert!((points.point(0)[2] - 2.004).abs() < 1e-15);
    }
}

#[test]
fn what_is_no_depth_map_of_the_camera_is_refused_by_what_was_expected() {
    let files = Files::new();
    let gray = |size, depth, bytes: &[u8]| png(size, ColorType::Grayscale, depth, bytes);
    let message = files.refusal(&gray([8, 6], BitDepth::Eight, &[1; 48]));
    assert!(message.contains("16 bits") && message.contains("found 8 bits"), "{message}");
    let message = files.refusal(&png([8, 6], ColorType::Rgb, BitDepth::Sixteen, &[1; 288]));
    assert!(message.contains("one channel"), "{message}");
    let message = files.refusal(&gray([6, 8], BitDepth::Sixteen, &[1; 96]));
    assert!(message.contains("[8, 6]") && message.contains("[6, 8]"), "{message}");
    let message = files.refusal(&gray([8, 6], BitDepth::Sixteen, &[0; 96]));
    assert!(message.contains("no pixel of the object has a depth"), "{message}");
    assert!(files.refusal(b"ply\nformat ascii 1.0\n").contains("PNG"));
    assert!(files.refusal(b"").contains("PNG"));

    let depth = files.write("depth.png", &depth_png());
    let mask = files.write("mask.png", &gray([8, 5], BitDepth::Eight, &[1; 40]));
    let error = DepthMap::read(&depth, files.camera(), Some(&mask), None).unwrap_err().to_string();
    assert!(error.starts_with(mask.to_str().unwrap()) && error.contains("[8, 5]"), "{error}");
    let unitless = Camera { depth_unit: None, ..files.camera() };
    let error = DepthMap::read(&depth, unitless, None, None).unwrap_err().to_string();
    assert!(error.contains("depth_units_m"), "{error}");
    let missing = Path::new("no-such-depth.png");
    let error = DepthMap::read(missing, files.camera(), None, None).unwrap_err().to_string();
    assert!(error.starts_with("no-such-depth.png: "), "{error}");
}

#[test]
fn a_file_cut_short_anywhere_is_refused() {
    let files = Files::new();
    let whole = depth_png();
    // The last chunk, of 12 bytes, only says that this was all.
    for length in 0..whole.len() - 12 {
        files.refusal(&whole[..length]);
    }
}

#[test]
fn headers_that_promise_more_than_there_is_take_no_memory() {
    let files = Files::new();
    for [width, height] in [[u32::MAX >> 1; 2], [1 << 20, 1 << 6], [1 << 16, 1 << 9]] {
        let mut header = b"IHDR".to_vec();
        header.extend(width.to_be_bytes());
        header.extend(height.to_be_bytes());
        header.extend([16, 0, 0, 0, 0]);
        let mut file = b"\x89PNG\r\n\x1a\n\0\0\0\x0d".to_vec();
        file.extend(&header);
        file.extend(crc32(&header).to_be_bytes());
        let message = files.refusal(&file);
        assert!(message.contains("pixels"), "{message}");
    }
}

/// The check that ends a chunk of PNG.
fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 };
    !bytes.iter().fold(u32::MAX, |crc, byte| (0..8).fold(crc ^ u32::from(*byte), step))
}

#[test]
fn damaged_files_are_read_or_refused_but_never_end_the_program() {
    let files = Files::new();
    let mut scene = Scene::new(5);
    let whole = depth_png();
    for _ in 0..2000 {
        let mut damaged = whole.clone();
        for _ in 0..3 {
            let at = scene.uniform(0.0, damaged.len() as f64) as usize;
            damaged[at] = scene.uniform(0.0, 256.0) as u8;
        }
        let path = files.write("depth.png", &damaged);
        if let Err(error) = DepthMap::read(&path, files.camera(), Some(&path), None) {
            assert!(error.to_string().starts_with(path.to_str().unwrap()));
        }
    }
}

#[test]
fn the_program_names_the_file_that_is_wrong() {
    let files = Files::new();
    let run = |arguments: &[&str]| {
        let program = Command::new(env!("CARGO_BIN_EXE_superquadric"))
            .args(arguments)
            .current_dir(files.0.path())
            .output()
            .expect("the program starts");
        (program.status.code(), String::from_utf8(program.stderr).expect("text"))
    };
    files.write("depth.png", &depth_png());
    files.write("broken.json", b"{\"fx\": 1,");
    for (arguments, expected) in [
        (&["fit", "depth.png"][..], "depth.png"),
        (&["fit", "depth.png", "--camera", "broken.json"], "broken.json: "),
        (&["fit", "depth.png", "--camera", "none.json"], "none.json: "),
        (&["fit", "camera.json", "--camera", "camera.json"], "camera.json: "),
        (&["fit", "depth.png", "--camera", "camera.json", "--mask", "camera.json"], "PNG"),
        (&["fit", "depth.png", "--mask", "depth.png"], "--camera"),
        (&["fit", "depth.png", "--camera", "camera.json", "--depth-unit", "0"], "--depth-unit"),
    ] {
        let (code, message) = run(arguments);
        assert_eq!(code, Some(2), "{message}");
        assert!(message.contains(expected), "{message:?} does not name {expected:?}");
    }
}
