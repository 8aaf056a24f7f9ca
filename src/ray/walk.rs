//! A ray's way through the cells around a deformed shape.

use super::along::Along;
use super::cage::{Cage, Stretch};
use super::half_line::Ray;
use super::hits::Crossings;
use crate::deform::Deformed;
use crate::shape::LevelSet;

/// The crossings of a deformed shape's surface along a stretch of a ray, in ascending order; as
/// they are asked for.
///
/// Cells tell short stretches outside which there are none, and of most of these that they lead
/// all out of the solid or all into it, so that there is one or none. Others are searched as
/// [`Crossings`] does.
pub(super) struct Walk<'a, S> {
    along: Along<'a, Deformed<S>>,
    ahead: std::vec::IntoIter<Stretch>,
    /// Whether the ray is inside, as far as it has come.
    is_inside: bool,
    /// What is left of a stretch that may be crossed any number of times.
    searched: Option<Crossings<'a, Deformed<S>>>,
}

impl<'a, S: LevelSet> Walk<'a, S> {
    /// The crossings of a ray within a range; outside it is the solid's outside.
    pub fn new(solid: &'a Deformed<S>, cage: &Cage, ray: Ray, range: [f64; 2]) -> Self {
        let ahead = cage.stretches(solid, &ray, range).into_iter();
        let along = Along { solid, ray };
        let is_inside = range[0] == 0.0 && along.is_inside(0.0);
        Self { along, ahead, is_inside, searched: None }
    }

    /// Whether the ray is inside, as far as it has come.
    pub fn is_inside(&self) -> bool {
        self.is_inside
    }

    /// The ray, in the solid's frame.
    pub fn ray(&self) -> &Ray {
        &self.along.ray
    }

    /// The crossing within a stretch, if there is at most one; else a search begins.
    fn crossing(&mut self, Stretch { range, outwards }: Stretch) -> Option<f64> {
        if outwards.is_none() {
            self.searched = Some(Crossings::new(self.along.solid, self.along.ray, range));
            return None;
        }
        let is_crossed = self.along.is_inside(range[1]) != self.is_inside;
        is_crossed.then(|| {
            let middle = 0.5 * (range[0] + range[1]);
            self.along.crossing(range, self.is_inside, middle)
        })
    }
}

impl<S: LevelSet> Iterator for Walk<'_, S> {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        loop {
            let searched = self.searched.as_mut().and_then(Iterator::next);
            let crossing = match searched {
                Some(crossing) => Some(crossing),
                None => {
                    self.searched = None;
                    let stretch = self.ahead.next()?;
                    self.crossing(stretch)
                }
            };
            if crossing.is_some() {
                self.is_inside = !self.is_inside;
                return crossing;
            }
        }
    }
}
