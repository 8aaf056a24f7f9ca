//! Makes the pictures of docs/gallery.md: figures of the papers, drawn anew.
//!
//! Usage: `cargo run --release --example gallery` (writes docs/pictures/gallery)

mod curves;
mod picture;
mod sampling;
mod shading;
mod solids;
mod volume_graph;

use std::error::Error;
use std::path::Path;

use picture::Picture;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/pictures/gallery");

/// A file's name and what draws it.
type Figure = (&'static str, fn() -> Picture);

const FIGURES: [Figure; 8] = [
    ("fb81-3.png", curves::nine_superellipses),
    ("fb81-4.png", curves::equal_steps_of_the_angle),
    ("fb81-5.png", sampling::parametric_and_explicit),
    ("jls-2-3.png", curves::lame_curves),
    ("jls-2-5.png", solids::nine_superellipsoids),
    ("jls-2-12.png", volume_graph::volume_ratio),
    ("jls-2-13.png", solids::phong),
    ("b81-7.png", solids::superellipsoids),
];

fn main() -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(FOLDER)?;
    for (name, draw) in FIGURES {
        draw().save(&Path::new(FOLDER).join(name))?;
    }
    Ok(())
}
