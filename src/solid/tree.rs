//! Union, intersection and difference of solids (B81).

use nalgebra::Vector3;

use super::primitive::Primitive;
use crate::math::Scalar;
use crate::pose::Pose;
use crate::shape::{LevelSet, Shape, Solid};

/// A solid made of posed, deformed primitives.
///
/// Levels are combined as B81 combines inside-outside functions: the least for a union, the
/// greatest for an intersection, and for what is taken away the level mirrored at 1.
#[derive(Debug, Clone, PartialEq)]
pub enum Tree<L = Primitive<Shape>> {
    /// A primitive.
    Leaf(L),
    /// What is in any of the parts.
    Union(Vec<Self>),
    /// What is in all of the parts.
    Intersection(Vec<Self>),
    /// What is in the first, but in none of the others.
    Difference(Box<Self>, Vec<Self>),
}

impl<S> From<Primitive<S>> for Tree<Primitive<S>> {
    fn from(primitive: Primitive<S>) -> Self {
        Self::Leaf(primitive)
    }
}

impl<L> Tree<L> {
    /// The number of leaves.
    pub fn leaves(&self) -> usize {
        let of = |parts: &[Self]| parts.iter().map(Self::leaves).sum::<usize>();
        match self {
            Self::Leaf(_) => 1,
            Self::Union(parts) | Self::Intersection(parts) => of(parts),
            Self::Difference(from, parts) => from.leaves() + of(parts),
        }
    }

    /// The tree of what a function makes of the leaves.
    pub fn map<M>(&self, function: &mut impl FnMut(&L) -> M) -> Tree<M> {
        match self {
            Self::Leaf(leaf) => Tree::Leaf(function(leaf)),
            Self::Union(parts) => Tree::Union(Self::map_all(parts, function)),
            Self::Intersection(parts) => Tree::Intersection(Self::map_all(parts, function)),
            Self::Difference(from, parts) => {
                let from = Box::new(from.map(function));
                Tree::Difference(from, Self::map_all(parts, function))
            }
        }
    }

    fn map_all<M>(parts: &[Self], function: &mut impl FnMut(&L) -> M) -> Vec<Tree<M>> {
        parts.iter().map(|part| part.map(function)).collect()
    }

    /// Whether what is in some of the leaves is in the solid.
    pub fn holds(&self, is_in: &impl Fn(&L) -> bool) -> bool {
        match self {
            Self::Leaf(leaf) => is_in(leaf),
            Self::Union(parts) => parts.iter().any(|part| part.holds(is_in)),
            Self::Intersection(parts) => parts.iter().all(|part| part.holds(is_in)),
            Self::Difference(from, parts) => {
                from.holds(is_in) && !parts.iter().any(|part| part.holds(is_in))
            }
        }
    }

    /// Whether what is in some of the leaves, and in no others, may be in the solid.
    pub(crate) fn can_hold(&self, may_be_in: &impl Fn(&L) -> bool) -> bool {
        match self {
            Self::Leaf(leaf) => may_be_in(leaf),
            Self::Union(parts) => parts.iter().any(|part| part.can_hold(may_be_in)),
            Self::Intersection(parts) => parts.iter().all(|part| part.can_hold(may_be_in)),
            Self::Difference(from, _) => from.can_hold(may_be_in),
        }
    }
}

impl<S: Clone> Tree<Primitive<S>> {
    /// The solid after a motion.
    pub fn moved(&self, motion: &Pose) -> Self {
        self.map(&mut |primitive| Primitive {
            deformed: primitive.deformed.clone(),
            pose: motion.after(&primitive.pose),
        })
    }
}

impl<S: Solid + LevelSet> Tree<Primitive<S>> {
    /// Whether a point of the world is inside.
    pub fn contains(&self, x: &Vector3<f64>) -> bool {
        self.holds(&|primitive| primitive.contains(x))
    }

    /// A box along the world's axes that holds the solid, `[min, max]`; empty, its ends the
    /// wrong way round or infinitely far apart, where boxes tell that nothing is left.
    pub fn bounding_box(&self) -> [Vector3<f64>; 2] {
        let infinite = Vector3::from_element(f64::INFINITY);
        match self {
            Self::Leaf(primitive) => primitive.bounding_box(),
            Self::Union(parts) => {
                let boxes = parts.iter().map(Self::bounding_box);
                boxes.fold([infinite, -infinite], |[min, max], [low, high]| {
                    [min.inf(&low), max.sup(&high)]
                })
            }
            Self::Intersection(parts) => {
                let boxes = parts.iter().map(Self::bounding_box);
                boxes.fold([-infinite, infinite], |[min, max], [low, high]| {
                    [min.sup(&low), max.inf(&high)]
                })
            }
            Self::Difference(from, _) => from.bounding_box(),
        }
    }
}

impl<L: LevelSet> LevelSet for Tree<L> {
    fn level<T: Scalar>(&self, x: [T; 3]) -> T {
        let of = |parts: &[Self], choose: fn(T, T) -> T| {
            parts.iter().map(|part| part.level(x)).reduce(choose)
        };
        match self {
            Self::Leaf(primitive) => primitive.level(x),
            Self::Union(parts) => of(parts, T::min).unwrap_or(T::constant(f64::INFINITY)),
            Self::Intersection(parts) => of(parts, T::max).unwrap_or(T::constant(0.0)),
            Self::Difference(from, parts) => match of(parts, T::min) {
                Some(taken) => from.level(x).max(-taken + 2.0),
                None => from.level(x),
            },
        }
    }
}

#[cfg(test)]
mod tests;
