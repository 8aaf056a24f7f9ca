//! Deformations one after another.

use nalgebra::{Matrix3, Vector3};

use super::deformation::Deformation;
use super::error::DeformError;
use super::map::Deform;
use crate::math::{Interval, Scalar};

/// Deformations that are applied in their order, the first to the undeformed object; none of
/// them is the identity.
///
/// Its Jacobian and normal transform are the products of theirs, each at the point that has
/// come to it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Chain {
    stages: Vec<Deformation>,
}

impl Chain {
    /// The chain of some deformations.
    pub fn new(stages: impl IntoIterator<Item = Deformation>) -> Self {
        Self { stages: stages.into_iter().collect() }
    }

    /// The deformations, the first that is applied first.
    pub fn stages(&self) -> &[Deformation] {
        &self.stages
    }

    /// The product of one matrix a stage, the last stage's to the left.
    fn product(
        &self,
        x: &Vector3<f64>,
        matrix: impl Fn(&Deformation, &Vector3<f64>) -> Matrix3<f64>,
    ) -> Matrix3<f64> {
        let start = (Matrix3::identity(), *x);
        let (product, _) = self.stages.iter().fold(start, |(product, x), stage| {
            (matrix(stage, &x) * product, stage.forward_of(x.into()).into())
        });
        product
    }
}

impl Deform for Chain {
    fn forward_of<S: Scalar>(&self, x: [S; 3]) -> [S; 3] {
        self.stages.iter().fold(x, |x, stage| stage.forward_of(x))
    }

    fn inverse_of<S: Scalar>(&self, x_deformed: [S; 3]) -> [S; 3] {
        self.stages.iter().rev().fold(x_deformed, |x, stage| stage.inverse_of(x))
    }

    fn check(&self, mut region: [Interval; 3]) -> Result<(), DeformError> {
        for stage in &self.stages {
            stage.check(region)?;
            region = stage.forward_of(region);
        }
        Ok(())
    }

    fn jacobian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        self.product(x, Deformation::jacobian)
    }

    fn determinant(&self, x: &Vector3<f64>) -> f64 {
        let (product, _) = self.stages.iter().fold((1.0, *x), |(product, x), stage| {
            (product * stage.determinant(&x), stage.forward_of(x.into()).into())
        });
        product
    }

    fn normal_transform(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        self.product(x, Deformation::normal_transform)
    }
}
