//! Documents for machines (JSON), tables for people, and tables of points for both.

mod camera_document;
mod curve_document;
mod curve_drawing;
mod deformation_document;
mod document;
mod evaluation;
mod info;
mod model_document;
mod point_table;
mod primitive_document;
mod scene_document;
mod shape_document;
mod solid_document;
mod solid_info;
mod surface_table;
mod table;

pub use curve_document::{curve_from_json, curve_to_json};
pub use curve_drawing::{CurveFormat, UnknownCurveFormat};
pub use document::{FIT_SCHEMA, FitDocument};
pub use evaluation::evaluation_table;
pub use info::InfoDocument;
pub use model_document::{DocumentError, ModelDocument, any_model_from_json, model_from_json};
pub use point_table::{PointTable, PointTableFormat, UnknownPointTableFormat};
pub use primitive_document::{PrimitiveInfoDocument, primitive_from_json};
pub use scene_document::{scene_from_json, scene_from_toml};
pub use solid_document::{solid_from_json, solid_to_json};
pub use solid_info::{SceneInfoDocument, SolidInfoDocument};
pub use surface_table::{NotUniform, Spread, surface_table};
pub use table::{fit_line, fit_table, model_table, primitive_table, scene_table, solid_table};
