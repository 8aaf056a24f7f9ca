//! Rays through any solid: where they meet its surface, and what a camera sees of it.

mod along;
mod cage;
mod enclosure;
mod half_line;
mod hits;
mod image;
mod passage;
mod render;
mod scene;
mod shading;
mod solid_target;
mod target;
mod walk;

pub use half_line::Ray;
pub use render::{Rays, Rendering, first_hit, render};
pub use scene::{Item, Lighting, Scene, camera_looking_at};
pub use shading::{Light, Material, Shading, Source};
pub use solid_target::SolidTarget;
pub(crate) use target::outward_normal;
pub use target::{Hit, Hittable, Target};

#[cfg(test)]
mod tests;
