//! Documents for machines (JSON) and tables for people.

mod document;
mod info;
mod model_document;
mod shape_document;
mod table;

pub use document::{FIT_SCHEMA, FitDocument};
pub use info::InfoDocument;
pub use model_document::{DocumentError, ModelDocument, any_model_from_json, model_from_json};
pub use table::{fit_line, fit_table, model_table};
