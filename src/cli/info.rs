//! `superquadric info`: a model, a solid or a scene in, what is known of it out.

use super::DONE;
use super::args::InfoArgs;
use super::error::CliError;
use super::input::{name, read_scene};
use super::output::print;
use crate::ray::{Item, Scene};
use crate::report::{
    DocumentError, InfoDocument, PrimitiveInfoDocument, SceneInfoDocument, SolidInfoDocument,
    model_table, primitive_table, scene_table, solid_table,
};
use crate::shape::Shape;
use crate::solid::{Primitive, Tree};

pub(super) fn run(args: &InfoArgs) -> Result<u8, CliError> {
    let scene = read_scene(&args.model)?;
    let text = scene_text(&scene, args.json)
        .map_err(|source| CliError::Document { name: name(&args.model), source })?;
    print(&text)?;
    Ok(DONE)
}

fn scene_text(scene: &Scene, as_json: bool) -> Result<String, DocumentError> {
    match scene.items.as_slice() {
        [Item { solid: Tree::Leaf(primitive), .. }] => text(primitive, as_json),
        [Item { solid, .. }] => {
            let info = SolidInfoDocument::new(solid);
            Ok(if as_json { info.to_json() } else { solid_table(&info) })
        }
        _ => {
            let info = SceneInfoDocument::new(scene);
            Ok(if as_json { info.to_json() } else { scene_table(&info) })
        }
    }
}

fn text(primitive: &Primitive<Shape>, as_json: bool) -> Result<String, DocumentError> {
    Ok(match (primitive.undeformed(), as_json) {
        (Some(model), false) => model_table(&model),
        (Some(model), true) => InfoDocument::new(&model).to_json(),
        (None, false) => primitive_table(primitive),
        (None, true) => PrimitiveInfoDocument::new(primitive)?.to_json(),
    })
}
