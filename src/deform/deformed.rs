//! A shape after a chain of deformations.

mod domain;
mod extent;
mod mass;
mod region;

use nalgebra::Vector3;

use super::chain::Chain;
use super::error::DeformError;
use super::map::Deform;
use crate::math::Scalar;
use crate::shape::{LevelSet, Parametric, Solid, Superellipsoid};

pub use mass::MassEstimate;

/// A deformed primitive: a shape and the deformations of its space, in the shape's frame.
///
/// The whole shape lies in the deformations' domain, so that they neither fold it nor make it
/// overlap itself, and points of the deformed solid are those whose undeformed ones are of the
/// shape.
#[derive(Debug, Clone, PartialEq)]
pub struct Deformed<S = Superellipsoid> {
    shape: S,
    chain: Chain,
}

impl<S> Deformed<S> {
    /// A shape that nothing deforms.
    pub fn plain(shape: S) -> Self {
        Self { shape, chain: Chain::default() }
    }

    /// The shape before the deformations.
    pub fn shape(&self) -> &S {
        &self.shape
    }

    /// The deformations.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// A normal of the shape at `x`, of unit length, after the deformations.
    pub(crate) fn deformed_normal(&self, x: &Vector3<f64>, normal: &Vector3<f64>) -> Vector3<f64> {
        (self.chain.normal_transform(x) * normal).normalize()
    }
}

impl<S: Solid + LevelSet> Deformed<S> {
    /// A shape after deformations.
    ///
    /// # Errors
    /// If a part of the shape is not of the deformations' domain, or comes within a hundredth of
    /// its size of what is not, so that this cannot be told.
    pub fn new(shape: S, chain: Chain) -> Result<Self, DeformError> {
        domain::check(&shape, &chain)?;
        Ok(Self { shape, chain })
    }

    /// The inside-outside function F of the undeformed point (B84 section 4): below 1 inside, 1
    /// on the surface, above 1 outside; infinite where no point is deformed to.
    pub fn inside_outside(&self, x: &Vector3<f64>) -> f64 {
        let f = self.shape.inside_outside(&self.undeformed(x));
        if f.is_nan() { f64::INFINITY } else { f }
    }

    /// Gradient of [`inside_outside`](Self::inside_outside), `J^-T grad F`; on the surface it
    /// points outwards along the normal.
    pub fn inside_outside_gradient(&self, x: &Vector3<f64>) -> Vector3<f64> {
        let undeformed = self.undeformed(x);
        let gradient = self.shape.inside_outside_gradient(&undeformed);
        self.chain.normal_transform(&undeformed) * gradient / self.chain.determinant(&undeformed)
    }

    /// Whether a point is inside.
    pub fn contains(&self, x: &Vector3<f64>) -> bool {
        self.shape.contains(&self.undeformed(x))
    }

    /// The point that is deformed to `x`, or one outside the shape if there is none.
    pub fn undeformed(&self, x: &Vector3<f64>) -> Vector3<f64> {
        self.chain.inverse_of((*x).into()).into()
    }
}

impl<S: Parametric> Deformed<S> {
    /// The surface point at latitude `eta` and longitude `omega` of the shape.
    pub fn position(&self, eta: f64, omega: f64) -> Vector3<f64> {
        self.chain.forward_of(self.shape.position(eta, omega).into()).into()
    }

    /// The outward unit normal there, by the normal transform (B84 appendix A).
    pub fn normal(&self, eta: f64, omega: f64) -> Vector3<f64> {
        self.deformed_normal(&self.shape.position(eta, omega), &self.shape.normal(eta, omega))
    }
}

impl<S: LevelSet> LevelSet for Deformed<S> {
    /// The level of the undeformed point.
    fn level<T: Scalar>(&self, x: [T; 3]) -> T {
        self.shape.level(self.chain.inverse_of(x))
    }
}

#[cfg(test)]
mod tests;
