//! The form of scenes in JSON and TOML; its schema stands in `schema/scene-1.schema.json`.

use nalgebra::Vector3;
use serde::Deserialize;
use serde_json::Value;

use super::camera_document::CameraDocument;
use super::model_document::DocumentError;
use super::solid_document::{solid_of, strict_solid_of};
use crate::pose::Pose;
use crate::ray::{Item, Light, Lighting, Material, Scene, Shading, Source};

/// Name of the documents' schema and its version.
const SCENE_SCHEMA: &str = "superquadric.scene/1";

/// What tells a scene from a solid.
const SOLIDS: &str = "solids";

/// The scene in a JSON text, or a solid alone: then in the frame of a camera that is not told.
///
/// # Errors
/// If the text is not JSON, a key is missing, unknown or has the wrong type, or a value is outside
/// its domain; the place is named.
pub fn scene_from_json(text: &str) -> Result<Scene, DocumentError> {
    scene_of(serde_json::from_str(text)?)
}

/// The same in TOML.
///
/// # Errors
/// As [`scene_from_json`].
pub fn scene_from_toml(text: &str) -> Result<Scene, DocumentError> {
    scene_of(toml::from_str(text).map_err(|error| DocumentError::Toml(error.to_string()))?)
}

fn scene_of(value: Value) -> Result<Scene, DocumentError> {
    if value.get(SOLIDS).is_none() {
        return Ok(solid_of(&value)?.into());
    }
    let document: SceneDocument = serde_path_to_error::deserialize(value)
        .map_err(|error| DocumentError::Scene(error.to_string()))?;
    document.to_scene()
}

/// `{"solids": [..], "camera": {..}, "ambient": [..], "lights": [..], "background": [..]}`, all but
/// the first if need be.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneDocument {
    schema: Option<String>,
    solids: Vec<ItemDocument>,
    camera: Option<CameraDocument>,
    ambient: Option<[f64; 3]>,
    lights: Option<Vec<LightDocument>>,
    background: Option<[f64; 3]>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ItemDocument {
    solid: Value,
    #[serde(default)]
    material: MaterialDocument,
}

/// What is not given is that of [`Material::default`].
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct MaterialDocument {
    color: Option<[f64; 3]>,
    diffuse: Option<f64>,
    specular: Option<f64>,
    shininess: Option<f64>,
}

/// A light in the world.
#[derive(Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
enum LightDocument {
    /// From far away: towards it, of any length.
    Directional {
        to_light: [f64; 3],
        #[serde(default = "white")]
        color: [f64; 3],
        #[serde(default = "full")]
        intensity: f64,
    },
    /// From a point; the intensity is that at a distance of 1.
    Point {
        position: [f64; 3],
        #[serde(default = "white")]
        color: [f64; 3],
        #[serde(default = "full")]
        intensity: f64,
    },
}

fn white() -> [f64; 3] {
    [1.0; 3]
}

fn full() -> f64 {
    1.0
}

impl SceneDocument {
    fn to_scene(&self) -> Result<Scene, DocumentError> {
        if let Some(schema) = self.schema.as_ref().filter(|schema| *schema != SCENE_SCHEMA) {
            return Err(invalid(format!("schema \"{SCENE_SCHEMA}\""), schema));
        }
        if self.solids.is_empty() {
            return Err(invalid("at least one solid in solids", "none"));
        }
        let items =
            self.solids.iter().enumerate().map(|(i, item)| {
                item.to_item().map_err(|error| error.at(format!("{SOLIDS}[{i}]")))
            });
        let placed = self.camera.as_ref().map(CameraDocument::placed).transpose();
        let placed = placed.map_err(|error| error.at("camera"))?;
        let background = self.background.map(|color| shares("background", color)).transpose()?;
        Ok(Scene {
            items: items.collect::<Result<_, _>>()?,
            camera: placed.map(|(camera, _)| camera),
            camera_from_world: placed.map_or(Pose::identity(), |(_, pose)| pose),
            lighting: self.lighting()?,
            background: background.map_or(Shading::default().background, |color| {
                color.map(|share| (255.0 * share).round() as u8)
            }),
        })
    }

    /// None if the scene says nothing of light.
    fn lighting(&self) -> Result<Option<Lighting>, DocumentError> {
        if self.lights.is_none() && self.ambient.is_none() {
            return Ok(None);
        }
        let lights =
            self.lights.iter().flatten().enumerate().map(|(i, light)| {
                light.to_light().map_err(|error| error.at(format!("lights[{i}]")))
            });
        let ambient = match self.ambient {
            Some(ambient) => ambient,
            None => Shading::default().ambient,
        };
        for part in ambient {
            within("ambient", part, [0.0, f64::MAX])?;
        }
        Ok(Some(Lighting { lights: lights.collect::<Result<_, _>>()?, ambient }))
    }
}

impl ItemDocument {
    fn to_item(&self) -> Result<Item, DocumentError> {
        let solid = strict_solid_of(&self.solid).map_err(|error| error.at("solid"))?;
        let material = self.material.to_material().map_err(|error| error.at("material"))?;
        Ok(Item { solid, material })
    }
}

impl MaterialDocument {
    fn to_material(&self) -> Result<Material, DocumentError> {
        let usual = Material::default();
        let of = |name, given: Option<f64>, usual, most| {
            within(name, given.unwrap_or(usual), [0.0, most])
        };
        Ok(Material {
            color: shares("color", self.color.unwrap_or(usual.color))?,
            diffuse: of("diffuse", self.diffuse, usual.diffuse, 1.0)?,
            specular: of("specular", self.specular, usual.specular, 1.0)?,
            shininess: of("shininess", self.shininess, usual.shininess, f64::MAX)?,
        })
    }
}

impl LightDocument {
    fn to_light(&self) -> Result<Light, DocumentError> {
        let (source, color, intensity) = match *self {
            Self::Directional { to_light, color, intensity } => {
                let direction = Vector3::from(to_light).try_normalize(0.0);
                let direction = direction.filter(|d| d.iter().all(|part| part.is_finite()));
                let expected = "a to_light other than 0";
                let direction = direction.ok_or_else(|| invalid(expected, format!("{to_light:?}")));
                (Source::Far(direction?), color, intensity)
            }
            Self::Point { position, color, intensity } => {
                (Source::Near(position.into()), color, intensity)
            }
        };
        let intensity = within("intensity", intensity, [0.0, f64::MAX])?;
        Ok(Light { source, power: shares("color", color)?.map(|share| share * intensity) })
    }
}

/// Red, green and blue, each from 0 to 1.
fn shares(name: &str, color: [f64; 3]) -> Result<[f64; 3], DocumentError> {
    for part in color {
        within(name, part, [0.0, 1.0])?;
    }
    Ok(color)
}

fn within(name: &str, value: f64, [least, most]: [f64; 2]) -> Result<f64, DocumentError> {
    if least <= value && value <= most {
        return Ok(value);
    }
    let up_to = if most < f64::MAX { format!(" to {most}") } else { " up".to_owned() };
    Err(invalid(format!("{name} from {least}{up_to}"), value))
}

fn invalid(expected: impl Into<String>, found: impl ToString) -> DocumentError {
    DocumentError::Value { expected: expected.into(), found: found.to_string() }
}

#[cfg(test)]
mod tests;
