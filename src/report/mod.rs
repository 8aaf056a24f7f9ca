//! Documents for machines (JSON) and tables for people.

mod deformation_document;
mod document;
mod primitive_document;
mod solid_document;
mod table;

pub use document::{
    DocumentError, FIT_SCHEMA, FitDocument, InfoDocument, ModelDocument, model_from_json,
};
pub use primitive_document::{PrimitiveInfoDocument, primitive_from_json};
pub use solid_document::solid_from_json;
pub use table::{fit_line, fit_table, model_table, primitive_table};
