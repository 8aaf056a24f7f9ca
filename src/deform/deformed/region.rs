//! Boxes that cover a shape.

use nalgebra::Vector3;

use crate::math::Interval;
use crate::shape::Solid;

/// A box, and the sides of the one it was cut from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Region {
    sides: [Interval; 3],
    whole: [f64; 3],
}

impl Region {
    /// The box around a shape, a little wider than it.
    pub fn around(shape: &impl Solid) -> Self {
        let [min, max] = shape.bounding_box();
        let slack = 1e-12;
        let sides = std::array::from_fn(|i| {
            Interval::new(min[i], max[i]).widened(slack * (max[i] - min[i]))
        });
        Self { sides, whole: sides.map(Interval::width) }
    }

    /// The sides.
    pub fn sides(&self) -> [Interval; 3] {
        self.sides
    }

    /// The point in the middle.
    pub fn middle(&self) -> Vector3<f64> {
        self.sides.map(Interval::middle).into()
    }

    /// The longest side, as a share of the whole one.
    pub fn share(&self) -> f64 {
        (0..3).map(|i| self.share_of(i)).fold(0.0, f64::max)
    }

    /// Two halves, across the side that is the longest share of the whole one.
    pub fn halves(&self) -> [Self; 2] {
        let longest =
            (1..3).fold(0, |a, b| if self.share_of(b) > self.share_of(a) { b } else { a });
        self.sides[longest].halves().map(|half| {
            let mut sides = self.sides;
            sides[longest] = half;
            Self { sides, ..*self }
        })
    }

    fn share_of(&self, axis: usize) -> f64 {
        self.sides[axis].width() / self.whole[axis]
    }
}
