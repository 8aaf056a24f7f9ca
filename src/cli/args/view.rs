//! What a camera looks at: outlines and overlays.

use std::path::PathBuf;

use super::parse::positive;

/// Solids, a camera, and how they stand to each other.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct ViewArgs {
    /// A fit, a bare model, a solid or a scene, .json or .toml; - is stdin, for JSON. What is no
    /// scene is in the camera's frame (x right, y down, z forward) unless --pose tells another.
    pub model: PathBuf,
    /// Intrinsics, in the place of a scene's: JSON with fx, fy, cx, cy, width, height and
    /// distortion, OpenCV's or ROS's calibration in YAML, or ROS's camera_info. Or an orthographic
    /// camera: {"model": "orthographic", "scale": [pixels per unit, along rows and columns],
    /// "origin": [column, row], "width": .., "height": ..}.
    #[arg(long, value_name = "CAM")]
    pub camera: Option<PathBuf>,
    /// The model is in the world's frame: JSON with camera_from_world or world_from_camera, rows
    /// [R | t], such as a scene's truth.json.
    #[arg(long, value_name = "POSE.json")]
    pub pose: Option<PathBuf>,
}

/// Write the outline of a model, a solid or a scene as a camera sees it.
///
/// Models may be of any family and deformed, solids unions, intersections and differences of them.
///
/// JSON has closed polygons of [column, row] in pixels, pixel centres at integers, the rim in the
/// camera's frame with what is hidden of it, area and bounding box; SVG is to be laid over the
/// image.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct ContourArgs {
    #[command(flatten)]
    pub view: ViewArgs,
    /// File to write: .json or .svg; - is stdout, for JSON.
    #[arg(short, long, value_name = "CONTOUR")]
    pub output: PathBuf,
}

/// Draw a model, a solid or a scene over a picture of it.
///
/// Its outline, its rim and lines on its surface (dashed where they are hidden), and the axes x, y,
/// z of a model in red, green and blue; and points coloured by their distance from it.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct OverlayArgs {
    #[command(flatten)]
    pub view: ViewArgs,
    /// Picture of the camera: PNG.
    #[arg(long, value_name = "PHOTO.png")]
    pub image: PathBuf,
    /// Points to colour, in the model's frame: PLY, PCD, NPY or text.
    #[arg(long, value_name = "CLOUD", conflicts_with = "depth")]
    pub points: Option<PathBuf>,
    /// Points to colour: a depth map of the camera, PNG of 16 bits, in metres as the model.
    #[arg(long, value_name = "DEPTH.png")]
    pub depth: Option<PathBuf>,
    /// The object in the depth map: PNG, not 0 where it is.
    #[arg(long, value_name = "MASK.png", requires = "depth")]
    pub mask: Option<PathBuf>,
    /// Metres to a count of the depth map [default: depth_units_m of the camera].
    #[arg(long, value_name = "METRES", requires = "depth", value_parser = positive)]
    pub depth_unit: Option<f64>,
    /// File to write.
    #[arg(short, long, value_name = "OUT.png")]
    pub output: PathBuf,
}

/// Cast rays at a scene, a solid or a model: depths, normals, a shaded picture.
///
/// A solid is a model, or {"union": [..]}, {"intersection": [..]} or {"difference": [..]} of solids;
/// models may be deformed. A scene, in JSON or TOML, has solids, each with its material, a camera
/// and lights: {"solids": [{"solid": {..}, "material": {..}}], "camera": {..}, "lights": [..]}.
#[derive(Debug, clap::Args)]
#[command(group = clap::ArgGroup::new("outputs").required(true).multiple(true))]
pub(in crate::cli) struct RenderArgs {
    /// A scene, a solid, a fit or a bare model, .json or .toml; - is stdin, for JSON. What is no
    /// scene is in the camera's frame (x right, y down, z forward) unless --pose tells another.
    pub scene: PathBuf,
    /// Intrinsics, in the place of the scene's: a file as `contour` takes it.
    #[arg(long, value_name = "CAM")]
    pub camera: Option<PathBuf>,
    /// Where the camera stands, in the place of the scene's: JSON with camera_from_world or
    /// world_from_camera, rows [R | t].
    #[arg(long, value_name = "POSE.json")]
    pub pose: Option<PathBuf>,
    /// Depths to write, z in the camera's frame and 0 where nothing is hit: .npy, or PNG of 16
    /// bits.
    #[arg(long, value_name = "DEPTH", group = "outputs")]
    pub depth: Option<PathBuf>,
    /// Unit of the counts of a depth PNG [default: depth_units_m of the camera, or 0.001].
    #[arg(long, value_name = "UNIT", requires = "depth", value_parser = positive)]
    pub depth_unit: Option<f64>,
    /// Normals to write: PNG, x, y and z of the camera's frame as red, green and blue.
    #[arg(long, value_name = "N.png", group = "outputs")]
    pub normals: Option<PathBuf>,
    /// Picture to write, lit by the scene's lights, or by three: PNG.
    #[arg(long, value_name = "S.png", group = "outputs")]
    pub shaded: Option<PathBuf>,
}
