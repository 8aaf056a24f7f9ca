//! The JSON form of solids; its schema stands in `schema/solid-1.schema.json`.

use serde_json::{Value, json};

use super::document::to_json;
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

/// The JSON text of a solid, indented, with a final newline.
///
/// # Errors
/// If a profile is a function that has no document.
pub fn solid_to_json(solid: &Tree) -> Result<String, DocumentError> {
    Ok(to_json(&value_of(solid)?))
}

fn value_of(solid: &Tree) -> Result<Value, DocumentError> {
    let all = |parts: &mut dyn Iterator<Item = &Tree>| parts.map(value_of).collect();
    let parts = |parts: &[Tree]| -> Result<Vec<Value>, DocumentError> { all(&mut parts.iter()) };
    Ok(match solid {
        Tree::Leaf(primitive) => serde_json::to_value(ModelDocument::try_from(primitive)?)?,
        Tree::Union(of) => json!({ "union": parts(of)? }),
        Tree::Intersection(of) => json!({ "intersection": parts(of)? }),
        Tree::Difference(from, taken) => {
            let of: Vec<Value> = all(&mut std::iter::once(&**from).chain(taken))?;
            json!({ "difference": of })
        }
    })
}

/// The solid of a document; keys that mean nothing are left alone.
pub(super) fn solid_of(value: &Value) -> Result<Tree, DocumentError> {
    tree_of(value, &|_, _| Ok(()))
}

/// The solid of a document whose every key has a meaning: one that is misspelt is an error.
pub(super) fn strict_solid_of(value: &Value) -> Result<Tree, DocumentError> {
    tree_of(value, &|value, known| match unknown_key(value, known) {
        Some(path) => Err(DocumentError::UnknownKey(path[1..].to_owned())),
        None => Ok(()),
    })
}

/// What may be said of a document, given another that has all keys that are known.
type Check<'a> = &'a dyn Fn(&Value, &Value) -> Result<(), DocumentError>;

fn tree_of(value: &Value, check: Check) -> Result<Tree, DocumentError> {
    for key in ["union", "intersection", "difference"] {
        let Some(parts) = value.get(key) else { continue };
        check(value, &json!({ key: parts }))?;
        let parts = parts_of(key, parts, check)?;
        return Ok(match key {
            "union" => Tree::Union(parts),
            "intersection" => Tree::Intersection(parts),
            _ => difference(parts)?,
        });
    }
    let document: ModelDocument = document_of(value)?;
    check(value, &serde_json::to_value(&document)?)?;
    Ok(Primitive::try_from(&document)?.into())
}

fn parts_of(key: &str, value: &Value, check: Check) -> Result<Vec<Tree>, DocumentError> {
    let parts = value.as_array().filter(|parts| !parts.is_empty()).ok_or(DocumentError::Parts)?;
    let solid = |(i, part)| tree_of(part, check).map_err(|error| error.at(format!("{key}[{i}]")));
    parts.iter().enumerate().map(solid).collect()
}

fn difference(parts: Vec<Tree>) -> Result<Tree, DocumentError> {
    let mut parts = parts.into_iter();
    let from = parts.next().ok_or(DocumentError::Parts)?;
    Ok(Tree::Difference(Box::new(from), parts.collect()))
}

/// The first key of a document, by its path (`.pose.turn`), that another has not got.
fn unknown_key(value: &Value, known: &Value) -> Option<String> {
    match (value, known) {
        (Value::Object(value), Value::Object(known)) => value.iter().find_map(|(key, value)| {
            match known.get(key) {
                Some(known) => unknown_key(value, known).map(|inner| format!(".{key}{inner}")),
                // What optional keys have that say nothing.
                None => (![Value::Null, json!([])].contains(value)).then(|| format!(".{key}")),
            }
        }),
        (Value::Array(value), Value::Array(known)) => {
            value.iter().zip(known).enumerate().find_map(|(i, (value, known))| {
                unknown_key(value, known).map(|inner| format!("[{i}]{inner}"))
            })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn a_tree_comes_back_from_its_document() {
        let solid = solid_from_json(BORED).unwrap();
        let again = solid_from_json(&solid_to_json(&solid).unwrap()).unwrap();
        assert_eq!(again, solid);
    }

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
        let nested = message(r#"{"union": [{"intersection": [{"pose": {}}]}]}"#);
        assert!(nested.starts_with("union[0]: intersection[0]: ") && nested.contains("shape"));
    }

    #[test]
    fn where_every_key_counts_misspelt_ones_are_named() {
        let value = |text: &str| serde_json::from_str::<Value>(text).unwrap();
        assert_eq!(strict_solid_of(&value(BORED)).unwrap(), solid_from_json(BORED).unwrap());
        let pedantic = BORED.replace("\"pose\"", "\"deformations\": [], \"pose\"");
        assert_eq!(strict_solid_of(&value(&pedantic)).unwrap(), solid_from_json(BORED).unwrap());
        for (from, to, expected) in [
            ("translation", "translaton", "union[1]: unknown key `pose.translaton`"),
            ("deformations", "deformation", "difference[1]: unknown key `deformation`"),
            ("\"kind\"", "\"axle\": 1, \"kind\"", "unknown key `deformations[0].axle`"),
            ("{\"union\"", "{\"pose\": {}, \"union\"", "difference[0]: unknown key `pose`"),
            ("\"family\"", "\"ring\": 2, \"family\"", "unknown key `shape.ring`"),
        ] {
            let misspelt = BORED.replace(from, to);
            assert!(solid_from_json(&misspelt).is_ok(), "{misspelt}");
            let message = strict_solid_of(&value(&misspelt)).unwrap_err().to_string();
            assert!(message.contains(expected), "{message:?} does not name {expected:?}");
        }
    }
}
