//! A ray's passage through a solid, by its passages through the parts.

use super::half_line::Ray;
use super::solid_target::Part;
use super::target::{Hit, outward_normal};
use super::walk::Walk;
use crate::shape::{LevelSet, Solid};
use crate::solid::Tree;

/// The hits of a ray with a solid, in ascending order; as they are asked for.
///
/// Wherever the ray crosses a part's surface, the tree tells whether it comes into the solid,
/// goes out of it, or neither.
pub(super) struct Passage<'a, S> {
    tree: &'a Tree<usize>,
    parts: &'a [Part<S>],
    ray: Ray,
    meetings: Vec<Option<Meeting<'a, S>>>,
    is_inside: bool,
}

/// A ray's meeting with a part.
struct Meeting<'a, S> {
    walk: Walk<'a, S>,
    /// Whether the ray is inside, as far as it has come.
    is_inside: bool,
    next: Next,
}

/// A ray's next crossing of a part's surface.
#[derive(Clone, Copy, PartialEq)]
enum Next {
    /// Not before this t.
    From(f64),
    At(f64),
    Never,
}

impl<'a, S: Solid + LevelSet> Meeting<'a, S> {
    /// That of a ray of the world, if it meets the part's box.
    fn of(part: &'a Part<S>, ray: &Ray) -> Option<Self> {
        let ray = ray.in_frame(&part.primitive.pose);
        let range = ray.clipped(&part.bounds)?;
        let walk = Walk::new(&part.primitive.deformed, &part.cage, ray, range);
        Some(Self { is_inside: walk.is_inside(), walk, next: Next::From(range[0]) })
    }

    /// Where the next crossing is or may be, and whether it is known to be there.
    fn ahead(&self) -> Option<(f64, bool)> {
        match self.next {
            Next::From(t) => Some((t, false)),
            Next::At(t) => Some((t, true)),
            Next::Never => None,
        }
    }

    fn look_ahead(&mut self) {
        self.next = self.walk.next().map_or(Next::Never, Next::At);
    }

    fn cross(&mut self, t: f64) {
        self.is_inside = !self.is_inside;
        self.next = Next::From(t);
    }
}

impl<'a, S: Solid + LevelSet> Passage<'a, S> {
    /// That of a ray, if it may come into the solid at all.
    pub fn of(tree: &'a Tree<usize>, parts: &'a [Part<S>], ray: &Ray) -> Option<Self> {
        let meetings: Vec<_> = parts.iter().map(|part| Meeting::of(part, ray)).collect();
        if !tree.can_hold(&|&part| meetings[part].is_some()) {
            return None;
        }
        let mut passage = Self { tree, parts, ray: *ray, meetings, is_inside: false };
        passage.is_inside = passage.tells_inside();
        Some(passage)
    }

    /// What the tree makes of the parts.
    fn tells_inside(&self) -> bool {
        self.tree.holds(&|&part| self.meetings[part].as_ref().is_some_and(|met| met.is_inside))
    }

    /// The part whose next crossing is nearest; of those as near, one not known to be there.
    fn nearest(&self) -> Option<(usize, f64, bool)> {
        let meetings = self.meetings.iter().enumerate();
        let ahead = meetings.filter_map(|(part, meeting)| {
            let (t, is_known) = meeting.as_ref()?.ahead()?;
            Some((part, t, is_known))
        });
        ahead.reduce(|a, b| if b.1 < a.1 || (b.1 == a.1 && !b.2) { b } else { a })
    }

    /// The hit at a crossing of a part's surface, at which the solid's is crossed, too.
    fn hit(&self, part: usize, t: f64) -> Option<Hit> {
        let meeting = self.meetings[part].as_ref()?;
        let primitive = &self.parts[part].primitive;
        let undeformed = primitive.deformed.undeformed(&meeting.walk.ray().at(t));
        let normal = outward_normal(primitive.deformed.shape(), &undeformed);
        let outward = primitive.deformed.deformed_normal(&undeformed, &normal);
        let is_taken_away = meeting.is_inside != self.is_inside;
        let normal = primitive.pose.rotation() * if is_taken_away { -outward } else { outward };
        Some(Hit { t, position: self.ray.at(t), normal })
    }
}

impl<S: Solid + LevelSet> Iterator for Passage<'_, S> {
    type Item = Hit;

    fn next(&mut self) -> Option<Hit> {
        loop {
            let (part, t, is_known) = self.nearest()?;
            if !is_known {
                self.meetings[part].as_mut()?.look_ahead();
                continue;
            }
            // Surfaces that coincide are crossed at once.
            let here = self.meetings.iter_mut().flatten().filter(|met| met.next == Next::At(t));
            here.for_each(|meeting| meeting.cross(t));
            if self.tells_inside() != self.is_inside {
                self.is_inside = !self.is_inside;
                return self.hit(part, t);
            }
        }
    }
}
