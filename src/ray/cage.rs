//! The space around a solid in cells that tell where its surface may be.

use std::sync::OnceLock;

use nalgebra::Vector3;

use super::enclosure::{Image, Tangent, slopes_of};
use super::half_line::Ray;
use crate::deform::{Deform, Deformed};
use crate::math::Interval;
use crate::shape::{LevelSet, Solid};

/// Halvings of a side after which cells are not cut across it any more.
const MOST_HALVINGS: u32 = 6;

/// Share of a level's change across a cell by which it may differ from a linear function there,
/// for the cell to be cut no more.
const FLATNESS: f64 = 0.25;

/// Halvings in all up to which a cell's hull is the box around those of its halves: images of
/// large cells are far from linear.
const HALVINGS_OF_BOXES: u32 = 10;

/// Share of the undeformed box's size by which it is widened.
const MARGIN: f64 = 1e-9;

/// The box around an undeformed shape, halved and halved again where the surface is; each cell
/// with its deformed image.
///
/// A cell is judged when it is first asked for, so that only what rays come by is ever cut.
#[derive(Debug, Clone)]
pub(super) struct Cage {
    root: Cell,
}

/// A box of undeformed space, which may not have been judged yet.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    sides: [Interval; 3],
    /// Of each side.
    halvings: [u32; 3],
    content: OnceLock<Content>,
}

/// What is known of a cell.
#[derive(Debug, Clone)]
pub(super) enum Content {
    /// The surface is not in it.
    Apart,
    /// The surface may be in it, and the level is about linear.
    Surface(Box<(Hull, Tangent)>),
    /// The surface may be in it: its halves tell more.
    Cut(Box<(Hull, [Cell; 2])>),
}

/// What of deformed space holds the surface that a cell may have.
#[derive(Debug, Clone)]
pub(super) enum Hull {
    /// All of it, as far as is known.
    Unknown,
    /// A box `[min, max]`.
    Box([Vector3<f64>; 2]),
    /// The cell's image.
    Image(Image),
}

/// What of a ray's stretch may cross the surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub range: [f64; 2],
    /// Whether every crossing leads out of the solid, or into it; nothing, if that is unknown.
    pub outwards: Option<bool>,
}

impl Cage {
    /// The cage of a shape.
    pub fn new(shape: &impl Solid) -> Self {
        let [min, max] = shape.bounding_box();
        let sides = std::array::from_fn(|i| {
            Interval::new(min[i], max[i]).widened(MARGIN * (max[i] - min[i]))
        });
        Self { root: Cell::new(sides, [0; 3]) }
    }

    /// A box around the deformed solid, `[min, max]`; none, if cells do not tell enough.
    pub fn bounds(&self, solid: &Deformed<impl LevelSet>) -> Option<[Vector3<f64>; 2]> {
        self.root.hull(solid)?.bounds()
    }

    /// The stretches of a ray that may cross the surface, in ascending order and apart from each
    /// other.
    pub fn stretches(
        &self,
        solid: &Deformed<impl LevelSet>,
        ray: &Ray,
        range: [f64; 2],
    ) -> Vec<Stretch> {
        let mut found = Vec::new();
        self.root.find(solid, ray, range, &mut found);
        found.sort_unstable_by(|a, b| a.range[0].total_cmp(&b.range[0]));
        found.dedup_by(|next, last| {
            let overlap = next.range[0] <= last.range[1];
            if overlap {
                last.range[1] = last.range[1].max(next.range[1]);
                last.outwards = last.outwards.filter(|_| next.outwards == last.outwards);
            }
            overlap
        });
        found
    }
}

impl Cell {
    fn new(sides: [Interval; 3], halvings: [u32; 3]) -> Self {
        Self { sides, halvings, content: OnceLock::new() }
    }

    fn content(&self, solid: &Deformed<impl LevelSet>) -> &Content {
        self.content.get_or_init(|| self.judged(solid))
    }

    fn find(
        &self,
        solid: &Deformed<impl LevelSet>,
        ray: &Ray,
        range: [f64; 2],
        found: &mut Vec<Stretch>,
    ) {
        match self.content(solid) {
            Content::Apart => {}
            Content::Cut(cut) => {
                let (hull, halves) = &**cut;
                if let Some(range) = hull.clipped(ray, range) {
                    halves.iter().for_each(|half| half.find(solid, ray, range, found));
                }
            }
            Content::Surface(surface) => {
                let (hull, tangent) = &**surface;
                let range = hull.clipped(ray, range);
                found.extend(range.and_then(|range| tangent.stretch(ray, range)));
            }
        }
    }

    /// The hull of the surface that the cell may have, if it may have any.
    fn hull(&self, solid: &Deformed<impl LevelSet>) -> Option<&Hull> {
        match self.content(solid) {
            Content::Apart => None,
            Content::Cut(cut) => Some(&cut.0),
            Content::Surface(surface) => Some(&surface.0),
        }
    }

    fn judged(&self, solid: &Deformed<impl LevelSet>) -> Content {
        if !solid.shape().level(self.sides).contains(1.0) {
            return Content::Apart;
        }
        let jacobian = slopes_of(self.sides, |x| solid.chain().forward_of(x));
        let image = Image::of(solid.chain(), self.sides, &jacobian);
        let is_of_domain = solid.chain().check(self.sides).is_ok();
        let jacobian = is_of_domain.then_some(&jacobian);
        let tangent = Tangent::of(solid.shape(), self.sides, image.as_ref(), jacobian);
        if tangent.is_apart() {
            return Content::Apart;
        }
        let own = image.map_or(Hull::Unknown, Hull::Image);
        let across = match tangent.errors() {
            Some(errors) => self.side_to_cut(&errors, FLATNESS * tangent.change()),
            None => self.side_to_cut(&self.shares(), 0.0),
        };
        let Some(across) = across else {
            return Content::Surface(Box::new((own, tangent)));
        };
        let halves = self.halves(across);
        let is_large = self.halvings.iter().sum::<u32>() < HALVINGS_OF_BOXES;
        let hull = if is_large { Hull::around(&halves, solid) } else { own };
        Content::Cut(Box::new((hull, halves)))
    }

    /// The side that most of the error is due to, of those that may still be cut; none, if their
    /// errors add up to less than is tolerated.
    fn side_to_cut(&self, errors: &[f64; 3], tolerated: f64) -> Option<usize> {
        let left = (0..3).filter(|&side| self.halvings[side] < MOST_HALVINGS);
        let sum: f64 = left.clone().map(|side| errors[side]).sum();
        let worst = left.max_by(|&a, &b| errors[a].total_cmp(&errors[b]))?;
        (sum > tolerated).then_some(worst)
    }

    /// The sides as shares of the whole ones.
    fn shares(&self) -> [f64; 3] {
        self.halvings.map(|halvings| f64::from(1 << halvings).recip())
    }

    /// The halves across a side.
    fn halves(&self, across: usize) -> [Self; 2] {
        self.sides[across].halves().map(|half| {
            let (mut sides, mut halvings) = (self.sides, self.halvings);
            sides[across] = half;
            halvings[across] += 1;
            Self::new(sides, halvings)
        })
    }
}

impl Hull {
    /// The box around the hulls of some cells.
    fn around(cells: &[Cell; 2], solid: &Deformed<impl LevelSet>) -> Self {
        let nothing = Vector3::from_element(f64::INFINITY);
        let hulls = cells.iter().filter_map(|cell| cell.hull(solid));
        let bounds = hulls.map(Self::bounds).try_fold([nothing, -nothing], |[min, max], next| {
            next.map(|[low, high]| [min.inf(&low), max.sup(&high)])
        });
        bounds.map_or(Self::Unknown, Self::Box)
    }

    fn bounds(&self) -> Option<[Vector3<f64>; 2]> {
        match self {
            Self::Unknown => None,
            Self::Box(bounds) => Some(*bounds),
            Self::Image(image) => Some(image.bounds()),
        }
    }

    /// What of a ray's range lies in it.
    fn clipped(&self, ray: &Ray, range: [f64; 2]) -> Option<[f64; 2]> {
        match self {
            Self::Unknown => Some(range),
            Self::Box(bounds) => ray.clipped_within(bounds, range),
            Self::Image(image) => image.clipped(ray, range),
        }
    }
}
