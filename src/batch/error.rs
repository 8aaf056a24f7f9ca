//! Why a suite cannot be evaluated.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::output::OutputError;

/// A suite that cannot be read, or results that cannot be kept.
#[derive(Debug, Error)]
pub enum BatchError {
    /// A file or folder that cannot be read or made.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A document that is not what it should be.
    #[error("{}: expected {expected}: {source}", path.display())]
    Document {
        /// The file.
        path: PathBuf,
        /// What was expected.
        expected: &'static str,
        /// What was found.
        source: serde_json::Error,
    },
    /// A scene's name that could lead out of the suite's folder.
    #[error("{}: a scene's name must be a plain file name, found {name:?}", path.display())]
    SceneName {
        /// The suite's document.
        path: PathBuf,
        /// The name found.
        name: String,
    },
    /// Results of another suite, other options or another version.
    #[error("{}: holds results of {found}, not of {expected}: choose another folder", path.display())]
    OtherResults {
        /// The folder of the results.
        path: PathBuf,
        /// What the results there are of.
        found: String,
        /// What was to be evaluated.
        expected: String,
    },
    /// An evaluation that was asked to give up.
    #[error("interrupted: what is done is kept, the same call goes on from there")]
    Interrupted,
    /// Results that could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}
