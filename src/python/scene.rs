//! `superquadric.Scene`: solids that rays are shot at and cameras look at.

use std::path::PathBuf;
use std::sync::OnceLock;

use nalgebra::Matrix3;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};
use rayon::prelude::*;

use super::arrays::{Doubles, shaped};
use super::document::{from_python, read_text};
use super::errors::{ArrayError, ModelError};
use super::tree::tree_of;
use super::view::PyCamera;
use crate::pose::Pose;
use crate::ray::{Hit, Item, Material, Ray, Scene, SolidTarget, first_hit};
use crate::report::{scene_from_json, scene_from_toml};
use crate::solid::Tree;
use crate::view::AnyCamera;

/// Solids, and if a document says so camera and lights, in one world.
///
/// Args:
///     solids: a list of models of any family, deformed or not, fits, or solids.
#[pyclass(frozen, name = "Scene", module = "superquadric")]
pub(super) struct PyScene {
    scene: Scene,
    /// The solids, made ready for rays when they are first asked for.
    targets: OnceLock<Vec<SolidTarget>>,
}

impl From<Scene> for PyScene {
    fn from(scene: Scene) -> Self {
        Self { scene, targets: OnceLock::new() }
    }
}

/// What becomes of a ray: t, position, normal, and the number of the solid.
type Row = (f64, [f64; 3], [f64; 3], i64);

#[pymethods]
impl PyScene {
    #[new]
    fn new(solids: &Bound<'_, PyAny>) -> PyResult<Self> {
        let solids = solids.try_iter()?.map(|solid| tree_of(&solid?));
        let solids = solids.collect::<PyResult<Vec<Tree>>>()?;
        let item = |solid| Item { solid, material: Material::default() };
        let items = solids.into_iter().map(item).collect();
        Ok(Scene { items, ..Scene::from(Tree::Union(Vec::new())) }.into())
    }

    /// The first hits of rays.
    ///
    /// Args:
    ///     origins: where they begin, of shape (..., 3).
    ///     directions: where they go, of any length but 0 and of the same shape.
    ///
    /// Returns:
    ///     A dictionary of `t`, float64 of shape (...), in units of a direction's length, infinite
    ///     where nothing is hit; `positions` and outward unit `normals`, float64 of shape (..., 3),
    ///     NaN there; and `solids`, int64 of shape (...), the number of the solid, -1 there.
    fn first_hits<'py>(
        &self,
        origins: &Bound<'py, PyAny>,
        directions: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let py = origins.py();
        let pair = py.import("numpy")?.call_method1("broadcast_arrays", (origins, directions))?;
        let origins = Doubles::new("origins", &pair.get_item(0)?)?;
        let directions = Doubles::new("directions", &pair.get_item(1)?)?;
        let (starts, ways) = (origins.rows()?, directions.rows()?);
        let rows: Vec<Row> = py.detach(|| {
            let targets = self.targets.get_or_init(|| self.scene.targets());
            let rays = starts.par_iter().zip(ways);
            rays.map(|(&origin, &way)| row(targets, origin, way)).collect()
        });
        let shape = origins.shape();
        let count = &shape[..shape.len() - 1];
        let hits = PyDict::new(py);
        hits.set_item("t", shaped(py, rows.iter().map(|row| row.0).collect(), count)?)?;
        let flat = |of: fn(&Row) -> [f64; 3]| rows.iter().flat_map(of).collect::<Vec<f64>>();
        hits.set_item("positions", shaped(py, flat(|row| row.1), shape)?)?;
        hits.set_item("normals", shaped(py, flat(|row| row.2), shape)?)?;
        hits.set_item("solids", shaped(py, rows.iter().map(|row| row.3).collect(), count)?)?;
        Ok(hits)
    }

    /// What a camera sees.
    ///
    /// Args:
    ///     camera: a pinhole camera; that of the scene if none is given.
    ///     camera_from_world: the motion to the camera's frame, of shape (3, 4), rows `[R | t]`;
    ///         where the scene's camera stands if none is given.
    ///
    /// Returns:
    ///     A dictionary of `depth`, z in the camera's frame, float64 of shape (rows, columns), 0
    ///     where nothing is hit; `normals` there in the camera's frame, float64 of shape (rows,
    ///     columns, 3); `solids`, int64, the number of the solid, -1 where nothing is hit; and
    ///     `shaded`, the picture, uint8 of shape (rows, columns, 3).
    ///
    /// Raises:
    ///     ModelError: if there is no camera, or the motion is none.
    #[pyo3(signature = (camera = None, *, camera_from_world = None))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        camera: Option<&PyCamera>,
        camera_from_world: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let mut scene = self.scene.clone();
        let camera = camera.map(|camera| AnyCamera::Pinhole(camera.0)).or(scene.camera);
        let camera =
            camera.ok_or_else(|| ModelError::new_err("the scene has no camera: give one"))?;
        if let Some(motion) = camera_from_world {
            scene.camera_from_world = motion_of(motion)?;
        }
        let (rendering, picture) = py.detach(|| {
            let rendering = scene.rendering(&camera, || ());
            let picture = scene.shading().picture(&rendering, &camera);
            (rendering, picture)
        });
        let [width, height] = rendering.size.map(|side| side as usize);
        let solid = |(depth, &solid): (&f64, &usize)| if *depth > 0.0 { solid as i64 } else { -1 };
        let solids = rendering.depths.iter().zip(&rendering.solids).map(solid).collect();
        let normals = rendering.normals.iter().flat_map(|n| [n.x, n.y, n.z]).collect();
        let images = PyDict::new(py);
        images.set_item("depth", shaped(py, rendering.depths, &[height, width])?)?;
        images.set_item("normals", shaped(py, normals, &[height, width, 3])?)?;
        images.set_item("solids", shaped::<i64>(py, solids, &[height, width])?)?;
        images.set_item("shaded", shaped(py, picture, &[height, width, 3])?)?;
        Ok(images)
    }

    /// The scene, solid or model in a JSON text.
    #[classmethod]
    fn from_json(_cls: &Bound<'_, PyType>, text: &str) -> PyResult<Self> {
        Ok(scene_from_json(text)?.into())
    }

    /// The scene, solid or model in a dictionary.
    #[classmethod]
    fn from_dict(_cls: &Bound<'_, PyType>, document: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(scene_from_json(&from_python(document)?)?.into())
    }

    /// The scene, solid or model in a JSON or TOML file.
    #[classmethod]
    fn load(_cls: &Bound<'_, PyType>, path: PathBuf) -> PyResult<Self> {
        let text = read_text(&path)?;
        let is_toml = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
        Ok(if is_toml { scene_from_toml(&text)? } else { scene_from_json(&text)? }.into())
    }

    fn __len__(&self) -> usize {
        self.scene.items.len()
    }

    fn __repr__(&self) -> String {
        format!("Scene of {} solids", self.scene.items.len())
    }
}

fn row(targets: &[SolidTarget], origin: [f64; 3], direction: [f64; 3]) -> Row {
    let ray = Ray { origin: origin.into(), direction: direction.into() };
    let is_ray = origin.iter().chain(&direction).all(|part| part.is_finite())
        && direction.iter().any(|&part| part != 0.0);
    match is_ray.then(|| first_hit(targets, &ray)).flatten() {
        Some((Hit { t, position, normal }, solid)) => {
            (t, position.into(), normal.into(), solid as i64)
        }
        None => (f64::INFINITY, [f64::NAN; 3], [f64::NAN; 3], -1),
    }
}

/// A motion from rows `[R | t]`.
fn motion_of(value: &Bound<'_, PyAny>) -> PyResult<Pose> {
    let rows = Doubles::new("camera_from_world", value)?;
    let ([3, 4], Ok(&[a, b, c, x, d, e, f, y, g, h, i, z])) =
        (rows.shape(), <&[f64; 12]>::try_from(rows.values()?))
    else {
        return Err(rows.wrong_shape("(3, 4)"));
    };
    if ![x, y, z].iter().all(|part| part.is_finite()) {
        return Err(ArrayError::new_err("camera_from_world: expected finite numbers"));
    }
    Ok(Pose::from_matrix(Matrix3::new(a, b, c, d, e, f, g, h, i), [x, y, z].into())?)
}
