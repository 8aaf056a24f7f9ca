//! Whether all of a shape lies in the domain of its deformations.

use super::region::Region;
use crate::deform::chain::Chain;
use crate::deform::error::DeformError;
use crate::deform::map::Deform;
use crate::shape::{LevelSet, Solid};

/// Share of the shape's size below which boxes are not cut any more.
const FINEST: f64 = 0.01;

/// Makes sure that the shape is covered by boxes of the domain.
pub(super) fn check(shape: &(impl Solid + LevelSet), chain: &Chain) -> Result<(), DeformError> {
    let mut left = vec![Region::around(shape)];
    while let Some(region) = left.pop() {
        let is_outside = shape.level(region.sides()).lo() > 1.0;
        if is_outside {
            continue;
        }
        match chain.check(region.sides()) {
            Ok(()) => {}
            Err(error) if region.share() < FINEST => return Err(error),
            Err(_) => left.extend(region.halves()),
        }
    }
    Ok(())
}
