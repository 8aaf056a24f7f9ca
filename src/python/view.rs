//! `superquadric.Camera` and `superquadric.read_depth`.

use std::path::PathBuf;

use numpy::PyArray1;
use pyo3::prelude::*;

use super::arrays::{Array, Doubles, Table, Vector, shaped, table};
use super::camera::project;
use super::errors::ModelError;
use crate::recover::SightLine;
use crate::view::{Camera, DepthMap, Distortion, find_plane};

/// A pinhole camera with a lens: x to the right, y down, z forward, as in OpenCV.
///
/// The centre of the pixel in column i and row j is (i, j).
///
/// Args:
///     fx: focal length along rows, in pixels.
///     fy: focal length along columns, in pixels.
///     cx: column of the principal point.
///     cy: row of the principal point.
///     width: number of columns.
///     height: number of rows.
///     distortion: OpenCV's coefficients `k1 k2 p1 p2 [k3 [k4 k5 k6]]`.
///     depth_unit: metres to one count of a depth map.
///
/// Raises:
///     ModelError: if a number is one that no camera has.
#[pyclass(frozen, eq, name = "Camera", module = "superquadric")]
#[derive(Clone, PartialEq)]
pub(super) struct PyCamera(pub Camera);

#[pymethods]
impl PyCamera {
    #[new]
    #[pyo3(signature = (fx, fy, cx, cy, width, height, *, distortion = None, depth_unit = None))]
    #[expect(clippy::too_many_arguments, reason = "a camera has that many numbers")]
    fn new(
        fx: f64,
        fy: f64,
        cx: f64,
        cy: f64,
        width: u32,
        height: u32,
        distortion: Option<Vec<f64>>,
        depth_unit: Option<f64>,
    ) -> PyResult<Self> {
        let distortion = Distortion::new(&distortion.unwrap_or_default());
        let distortion =
            distortion.map_err(|problem| ModelError::new_err(format!("expected {problem}")))?;
        let camera = Camera { fx, fy, cx, cy, width, height, depth_unit, distortion };
        Ok(Self(camera.checked().map_err(|error| ModelError::new_err(error.to_string()))?))
    }

    /// The camera in a file: OpenCV's or ROS's calibration in YAML, ROS's `camera_info`, or JSON
    /// with `fx fy cx cy width height` and, if there are any, `depth_units_m` and `distortion`.
    ///
    /// Raises:
    ///     ImageError: if the file holds no camera.
    ///     OSError: if it cannot be read.
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        Ok(Self(Camera::read(path)?))
    }

    /// Focal length along rows, in pixels.
    #[getter]
    fn fx(&self) -> f64 {
        self.0.fx
    }

    /// Focal length along columns, in pixels.
    #[getter]
    fn fy(&self) -> f64 {
        self.0.fy
    }

    /// Column of the principal point.
    #[getter]
    fn cx(&self) -> f64 {
        self.0.cx
    }

    /// Row of the principal point.
    #[getter]
    fn cy(&self) -> f64 {
        self.0.cy
    }

    /// Number of columns.
    #[getter]
    fn width(&self) -> u32 {
        self.0.width
    }

    /// Number of rows.
    #[getter]
    fn height(&self) -> u32 {
        self.0.height
    }

    /// Metres to one count of a depth map; None if the camera does not say.
    #[getter]
    fn depth_unit(&self) -> Option<f64> {
        self.0.depth_unit
    }

    /// OpenCV's coefficients `k1 k2 p1 p2 k3 k4 k5 k6`.
    #[getter]
    fn distortion(&self) -> [f64; 8] {
        self.0.distortion.coefficients()
    }

    /// Pixels (column, row), of shape (n, 2), at which points of the camera's frame, of shape
    /// (n, 3), are seen; not numbers behind the camera and where no ray comes through the lens.
    fn project<'py>(&self, points: &Bound<'py, PyAny>) -> PyResult<Array<'py>> {
        project(&self.0, points)
    }

    /// Directions, of shape (n, 3) and with z = 1, of the rays of pixels (column, row), of shape
    /// (n, 2); not numbers where no ray comes through the lens.
    fn rays<'py>(&self, pixels: &Bound<'py, PyAny>) -> PyResult<Table<'py>> {
        let py = pixels.py();
        let pixels = Doubles::new("pixels", pixels)?;
        let [_, 2] = *pixels.shape() else { return Err(pixels.wrong_shape("(n, 2)")) };
        let ray = |[column, row]: &[f64; 2]| self.0.ray(*column, *row).unwrap_or([f64::NAN; 3]);
        table(py, pixels.values()?.as_chunks().0.iter().map(ray).collect())
    }

    fn __repr__(&self) -> String {
        let Camera { fx, fy, cx, cy, width, height, .. } = self.0;
        format!("<Camera {width} x {height}, fx={fx}, fy={fy}, cx={cx}, cy={cy}>")
    }
}

/// Read the depth map of an object: a PNG image of 16 bits a pixel, 0 where there is no depth.
///
/// Args:
///     path: the depth map.
///     camera: the camera, or its file.
///     mask: a PNG image that is not 0 where the object is; without it all is the object.
///     depth_unit: metres to a count; by default the camera's.
///
/// Returns:
///     The depth map, in metres and in the camera's frame.
///
/// Raises:
///     ImageError: if a file is not what it should be, or of another size than the camera's.
///     OSError: if it cannot be read.
#[pyfunction]
#[pyo3(signature = (path, camera, *, mask = None, depth_unit = None))]
pub(super) fn read_depth(
    py: Python<'_>,
    path: PathBuf,
    camera: &Bound<'_, PyAny>,
    mask: Option<PathBuf>,
    depth_unit: Option<f64>,
) -> PyResult<PyDepthMap> {
    let camera = match camera.cast::<PyCamera>() {
        Ok(camera) => camera.get().0,
        Err(_) => Camera::read(camera.extract::<PathBuf>()?)?,
    };
    let camera = Camera { depth_unit: depth_unit.or(camera.depth_unit), ..camera };
    camera.checked().map_err(|error| ModelError::new_err(error.to_string()))?;
    py.detach(|| Ok(PyDepthMap(DepthMap::read(path, camera, mask.as_deref(), None)?)))
}

/// What a range camera sees of an object and around it; made by `read_depth`.
#[pyclass(frozen, name = "DepthMap", module = "superquadric")]
pub(super) struct PyDepthMap(DepthMap);

#[pymethods]
impl PyDepthMap {
    /// The camera.
    #[getter]
    fn camera(&self) -> PyCamera {
        PyCamera(*self.0.camera())
    }

    /// Depth along z, in metres, of shape (height, width); 0 where there is none.
    #[getter]
    fn depth<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let Camera { width, height, .. } = *self.0.camera();
        shaped(py, self.0.depths().to_vec(), &[height as usize, width as usize])
    }

    /// Points of the object in the camera's frame, of shape (n, 3), in metres.
    fn object_points<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        table(py, py.detach(|| self.0.object_points().points().collect()))
    }

    /// The same without the mask's rim, where a pixel may mix the depths of both sides: these are
    /// best to fit.
    fn inner_points<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        table(py, py.detach(|| self.0.inner_points().points().collect()))
    }

    /// Points around the object that are not of it, of shape (n, 3); none without a mask.
    fn surroundings<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        table(py, py.detach(|| self.0.surroundings().points().collect()))
    }

    /// Where the camera stood: zeros of shape (3,).
    #[getter]
    fn viewpoint<'py>(&self, py: Python<'py>) -> Vector<'py> {
        PyArray1::from_slice(py, &[0.0; 3])
    }

    /// Rays next to the object that came through, of shape (n, 4): a direction, and how far the ray
    /// came, in metres; none without a mask.
    fn free_rays<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let free = self.0.sight().free;
        let row = |line: &SightLine| line.direction.into_iter().chain([line.reach]);
        let rows: Vec<f64> = free.iter().flat_map(row).collect();
        shaped(py, rows, &[free.len(), 4])
    }

    /// The plane around the object that it stands on, (a, b, c, d) of shape (4,), positive on the
    /// camera's side; None if there is none.
    #[pyo3(signature = (*, seed = 0))]
    fn find_support<'py>(&self, py: Python<'py>, seed: u64) -> Option<Vector<'py>> {
        let plane = py.detach(|| find_plane(&self.0.surroundings(), [0.0; 3], seed))?;
        let [a, b, c] = plane.normal();
        Some(PyArray1::from_slice(py, &[a, b, c, plane.offset()]))
    }

    fn __repr__(&self) -> String {
        let Camera { width, height, .. } = *self.0.camera();
        format!("<DepthMap {width} x {height}>")
    }
}
