//! The core's errors as Python exceptions.

use std::io;

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::batch::BatchError as CoreBatchError;
use crate::cloud::{Problem, ReadError};
use crate::error::ModelError as CoreModelError;
use crate::exchange::{ExportError as CoreExportError, ImportError as CoreImportError};
use crate::output::OutputError;
use crate::recover::FitError as CoreFitError;
use crate::report::DocumentError as CoreDocumentError;
use crate::surface::{ResolutionError, ToleranceError};
use crate::view::ImageError as CoreImageError;

create_exception!(
    superquadric,
    SuperquadricError,
    PyValueError,
    "What this package cannot work with; base of its exceptions."
);
create_exception!(superquadric, ArrayError, SuperquadricError, "An array of the wrong shape.");
create_exception!(
    superquadric,
    CloudError,
    SuperquadricError,
    "A file that does not hold a point cloud."
);
create_exception!(
    superquadric,
    FitError,
    SuperquadricError,
    "A point cloud that does not determine a solid."
);
create_exception!(
    superquadric,
    ModelError,
    SuperquadricError,
    "Parameters of a model outside their domain."
);
create_exception!(
    superquadric,
    DocumentError,
    SuperquadricError,
    "JSON that does not hold a model."
);

create_exception!(
    superquadric,
    ImageError,
    SuperquadricError,
    "A file that does not hold the image or the camera that it should."
);
create_exception!(
    superquadric,
    ViewError,
    SuperquadricError,
    "A view in which a model has no outline."
);
create_exception!(
    superquadric,
    BatchError,
    SuperquadricError,
    "A suite that cannot be evaluated, or results of another one."
);

create_exception!(
    superquadric,
    ExchangeError,
    SuperquadricError,
    "A shape that another program cannot express, or a text that is not its format's."
);

impl From<CoreExportError> for PyErr {
    fn from(error: CoreExportError) -> Self {
        ExchangeError::new_err(error.to_string())
    }
}

impl From<CoreImportError> for PyErr {
    fn from(error: CoreImportError) -> Self {
        ExchangeError::new_err(error.to_string())
    }
}

impl From<CoreModelError> for PyErr {
    fn from(error: CoreModelError) -> Self {
        ModelError::new_err(error.to_string())
    }
}

impl From<CoreFitError> for PyErr {
    fn from(error: CoreFitError) -> Self {
        FitError::new_err(error.to_string())
    }
}

impl From<CoreDocumentError> for PyErr {
    fn from(error: CoreDocumentError) -> Self {
        DocumentError::new_err(error.to_string())
    }
}

impl From<ResolutionError> for PyErr {
    fn from(error: ResolutionError) -> Self {
        ModelError::new_err(error.to_string())
    }
}

impl From<ToleranceError> for PyErr {
    fn from(error: ToleranceError) -> Self {
        ModelError::new_err(error.to_string())
    }
}

impl From<CoreBatchError> for PyErr {
    fn from(error: CoreBatchError) -> Self {
        match error {
            CoreBatchError::Io { ref source, .. } => os_error(source.kind(), error.to_string()),
            CoreBatchError::Output(error) => error.into(),
            _ => BatchError::new_err(error.to_string()),
        }
    }
}

impl From<OutputError> for PyErr {
    fn from(error: OutputError) -> Self {
        os_error(error.source.kind(), error.to_string())
    }
}

impl From<ReadError> for PyErr {
    fn from(error: ReadError) -> Self {
        let message = error.to_string();
        match error.problem() {
            Problem::Io(source) => os_error(source.kind(), message),
            Problem::Directory => os_error(io::ErrorKind::IsADirectory, message),
            _ => CloudError::new_err(message),
        }
    }
}

impl From<CoreImageError> for PyErr {
    fn from(error: CoreImageError) -> Self {
        match error.io_kind() {
            Some(kind) => os_error(kind, error.to_string()),
            None => ImageError::new_err(error.to_string()),
        }
    }
}

/// The `OSError`, or one of its subclasses, for a kind of failure.
pub(super) fn os_error(kind: io::ErrorKind, message: String) -> PyErr {
    io::Error::new(kind, message).into()
}
