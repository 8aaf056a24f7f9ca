//! The JSON form of solids; its schema stands in `schema/solid-1.schema.json`.

use serde_json::Value;

use super::model_document::{DocumentError, ModelDocument, document_of};
use crate::solid::{Primitive, Tree};

/// The solid in a JSON text: a model or a fit, or `{"union": [..]}`, `{"intersection": [..]}` or
/// `{"difference": [..]}` of solids, the first of which the others are taken from.
///
/// # Errors
/// If the text is not JSON, or a part is not the document of a solid.
pub fn solid_from_json(text: &str) -> Result<Tree, DocumentError> {
    solid_of(&serde_json::from_str(text)?)
}

fn solid_of(value: &Value) -> Result<Tree, DocumentError> {
    let parts = |key: &str| value.get(key).map(parts_of);
    if let Some(parts) = parts("union") {
        return Ok(Tree::Union(parts?));
    }
    if let Some(parts) = parts("intersection") {
        return Ok(Tree::Intersection(parts?));
    }
    if let Some(parts) = parts("difference") {
        let mut parts = parts?.into_iter();
        let from = parts.next().ok_or(DocumentError::Parts)?;
        return Ok(Tree::Difference(Box::new(from), parts.collect()));
    }
    let document: ModelDocument = document_of(value)?;
    Ok(Primitive::try_from(&document)?.into())
}

fn parts_of(value: &Value) -> Result<Vec<Tree>, DocumentError> {
    let parts = value.as_array().filter(|parts| !parts.is_empty()).ok_or(DocumentError::Parts)?;
    parts.iter().map(solid_of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    const BORED: &str = r#"{"difference": [
        {"union": [
            {"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [0.2, 0.2]}},
            {"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]},
             "pose": {"translation": [0, 0, 1]}}
        ]},
        {"shape": {"family": "superellipsoid", "size": [0.3, 0.3, 3], "exponents": [0.2, 1]},
         "deformations": [{"kind": "scale", "factors": [1, 2, 1]}]}
    ]}"#;

    #[test]
    fn a_tree_is_read_as_it_is_nested() {
        let solid = solid_from_json(BORED).unwrap();
        for (x, is_inside) in [
            ([0.8, 0.8, 0.8], true),
            ([0.7, 0.0, 1.6], true),
            ([0.0, 0.0, 0.5], false),
            ([0.0, 0.5, 0.5], false),
            ([0.5, 0.0, 0.5], true),
            ([0.0, 0.0, 2.5], false),
        ] {
            assert_eq!(solid.contains(&Vector3::from(x)), is_inside, "{x:?}");
        }
    }

    #[test]
    fn what_is_wrong_with_a_tree_is_named() {
        let message = |text: &str| solid_from_json(text).unwrap_err().to_string();
        assert!(message(r#"{"union": []}"#).contains("at least one"));
        assert!(message(r#"{"union": {}}"#).contains("at least one"));
        assert!(message(&BORED.replace("[0.2, 1]", "[0.2, -1]")).contains("exponents[1]"));
        assert!(message(r#"{"union": [{"pose": {}}]}"#).contains("shape"));
    }
}
