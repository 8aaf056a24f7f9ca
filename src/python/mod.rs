//! The Python package's extension module: the crate's own functions on NumPy arrays.

mod arrays;
mod batch;
mod camera;
mod contour;
mod curves;
mod deformed;
mod derivatives;
mod document;
mod errors;
mod exchange;
mod families;
mod fit;
mod interrupt;
mod knowledge;
mod model;
mod polyline;
mod pose;
mod read;
mod scene;
mod score;
mod shape;
mod solid;
mod surface;
mod tree;
mod view;
mod wireframe;

use pyo3::prelude::*;

/// Superquadrics in Rust; import `superquadric` instead.
#[pymodule(name = "_core")]
mod core {
    #[pymodule_export]
    use super::batch::evaluate_suite;
    #[pymodule_export]
    use super::camera::{PyOrthographicCamera, load_camera};
    #[pymodule_export]
    use super::contour::{PyContour, PyRimCurve, contour, rim};
    #[pymodule_export]
    use super::curves::{PyLameCurve, PySuperellipse, PySuperhyperbola, spherical_product};
    #[pymodule_export]
    use super::deformed::PyDeformed;
    #[pymodule_export]
    use super::errors::{
        ArrayError, BatchError, CloudError, DocumentError, ExchangeError, FitError, ImageError,
        ModelError, SuperquadricError, ViewError,
    };
    #[pymodule_export]
    use super::exchange::{export_model, import_models, read_mesh_model, write_mesh};
    #[pymodule_export]
    use super::families::{PyOneSheet, PySupertoroid, PyThreeExponent, PyTwoSheets};
    #[pymodule_export]
    use super::fit::{PyFit, fit};
    #[pymodule_export]
    use super::model::PyModel;
    #[pymodule_export]
    use super::polyline::PyPolyline;
    #[pymodule_export]
    use super::read::read;
    #[pymodule_export]
    use super::scene::PyScene;
    #[pymodule_export]
    use super::score::{PyScore, score};
    #[pymodule_export]
    use super::shape::PyShape;
    #[pymodule_export]
    use super::tree::PySolid;
    #[pymodule_export]
    use super::view::{PyCamera, PyDepthMap, read_depth};
    #[pymodule_export]
    use super::wireframe::{axes, residual, wireframe};

    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "the name that Python expects")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
