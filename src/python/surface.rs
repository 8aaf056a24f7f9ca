//! Surfaces of any family as arrays of points and of triangles.

use nalgebra::Vector3;
use pyo3::prelude::*;

use super::arrays::{Array, Table, require_room, shaped, table, vectors};
use super::errors::ModelError;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::Shape;
use crate::surface::{
    Mesh, MeshMethod, Parameterization, Resolution, tessellate_shape, tessellate_within,
};

/// Vertices and triangles.
pub(super) type MeshArrays<'py> = (Table<'py>, Table<'py, u32>);

/// How fine a mesh is to be, as it is asked for.
pub(super) struct Fineness<'a> {
    pub resolution: Option<usize>,
    pub tolerance: Option<f64>,
    pub method: Option<&'a str>,
}

impl Fineness<'_> {
    /// The mesh of a shape that is meant, in its own frame.
    fn mesh(&self, shape: &Shape) -> PyResult<Mesh> {
        match *self {
            Self { resolution: Some(_), tolerance: Some(_), .. } => {
                Err(ModelError::new_err("expected a resolution or a tolerance, found both"))
            }
            Self { method: Some(_), tolerance: None, .. } => {
                Err(ModelError::new_err("a method is one of meshes within a tolerance, found none"))
            }
            Self { tolerance: Some(tolerance), method, .. } => {
                Ok(tessellate_within(*shape, tolerance, method_of(method)?)?)
            }
            Self { resolution, .. } => {
                let resolution = resolution.map_or(Ok(Resolution::default()), Resolution::new)?;
                Ok(tessellate_shape(shape, resolution))
            }
        }
    }
}

/// The mesh of a model in the world.
pub(super) fn mesh<'py>(
    py: Python<'py>,
    model: &Model<Shape>,
    fineness: &Fineness,
) -> PyResult<MeshArrays<'py>> {
    let mesh = py.detach(|| fineness.mesh(&model.shape))?.transformed(&model.pose);
    mesh_arrays(py, &mesh)
}

/// A mesh's vertices and triangles.
pub(super) fn mesh_arrays<'py>(py: Python<'py>, mesh: &Mesh) -> PyResult<MeshArrays<'py>> {
    Ok((vectors(py, mesh.vertices())?, table(py, mesh.triangles().to_vec())?))
}

/// So many points of a solid in the world, as a function of their number draws them in the model's
/// frame.
pub(super) fn sample<'py>(
    py: Python<'py>,
    pose: &Pose,
    count: usize,
    draw: impl FnOnce(usize) -> Vec<Vector3<f64>> + Send,
) -> PyResult<Table<'py>> {
    require_room(count)?;
    let world = || draw(count).iter().map(|x| pose.world_from_model(x)).collect::<Vec<_>>();
    vectors(py, &py.detach(world))
}

/// Rows of points of a model's surface in the world, in an array of shape (rows, points, 3).
pub(super) fn grid<'py>(
    py: Python<'py>,
    model: &Model<Shape>,
    n: usize,
    parameterization: &str,
) -> PyResult<Array<'py>> {
    let parameterization = parameterization_of(parameterization)?;
    require_room(n.saturating_mul(n).saturating_mul(16))?;
    let Model { shape, pose } = model;
    let rows = py.detach(|| parameterization.shape(shape, n));
    let counts = [rows.len(), rows.first().map_or(0, Vec::len), 3];
    let points = rows.iter().flatten();
    let values = points.flat_map(|x| <[f64; 3]>::from(pose.world_from_model(x))).collect();
    shaped(py, values, &counts)
}

/// The method of a name.
fn method_of(name: Option<&str>) -> PyResult<MeshMethod> {
    match name {
        None => Ok(MeshMethod::default()),
        Some("lattice") => Ok(MeshMethod::Lattice),
        Some("curvature") => Ok(MeshMethod::Curvature),
        Some("subdivision") => Ok(MeshMethod::Subdivision),
        Some(found) => Err(ModelError::new_err(format!(
            "method: expected \"lattice\", \"curvature\" or \"subdivision\", found {found:?}"
        ))),
    }
}

/// The parameterisation of a name.
fn parameterization_of(name: &str) -> PyResult<Parameterization> {
    match name {
        "trigonometric" => Ok(Parameterization::Trigonometric),
        "angle_centre" => Ok(Parameterization::AngleCentre),
        "explicit" => Ok(Parameterization::Explicit),
        "equal_distance" => Ok(Parameterization::EqualDistance),
        found => Err(ModelError::new_err(format!(
            "parameterization: expected \"trigonometric\", \"angle_centre\", \"explicit\" or \
             \"equal_distance\", found {found:?}"
        ))),
    }
}
