//! The list of a suite's scenes.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::error::BatchError;

/// A suite, as `suite.json` describes it.
#[derive(Debug, Deserialize)]
pub(super) struct Suite {
    pub name: String,
    /// Degrees of difficulty, in the order in which they are reported.
    pub levels: Vec<String>,
    pub scenes: Vec<SceneEntry>,
    #[serde(skip)]
    folder: PathBuf,
}

/// A scene, as the suite lists it.
#[derive(Debug, Deserialize)]
pub(super) struct SceneEntry {
    pub name: String,
    pub level: String,
    pub family: String,
}

impl Suite {
    pub fn read(folder: &Path) -> Result<Self, BatchError> {
        let path = folder.join("suite.json");
        let text = fs::read_to_string(&path)
            .map_err(|source| BatchError::Io { path: path.clone(), source })?;
        let mut suite: Self = serde_json::from_str(&text).map_err(|source| {
            BatchError::Document { path: path.clone(), expected: "a suite of scenes", source }
        })?;
        if let Some(scene) = suite.scenes.iter().find(|scene| !is_plain(&scene.name)) {
            return Err(BatchError::SceneName { path, name: scene.name.clone() });
        }
        suite.folder = folder.to_path_buf();
        Ok(suite)
    }

    /// Where a scene's files are.
    pub fn scene_folder(&self, scene: &SceneEntry) -> PathBuf {
        self.folder.join("scenes").join(&scene.name)
    }
}

/// Whether a name stays in its folder.
fn is_plain(name: &str) -> bool {
    Path::new(name).file_name().is_some_and(|file_name| file_name == name)
}
