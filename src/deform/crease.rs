//! Where deformations are not smooth: planes in the frames of theirs.

use nalgebra::Vector3;

use super::chain::Chain;
use super::deformation::{Deformation, Kind};
use super::map::Deform;

/// Axes of a deformation's own frame.
const Y: usize = 1;
const Z: usize = 2;

impl Kind {
    /// The axis along which the deformation has creases, and where.
    fn creases(&self) -> (usize, Vec<f64>) {
        match self {
            Self::Scale(_) => (Z, Vec::new()),
            Self::Taper(taper) => (Z, taper.profile().creases()),
            Self::Twist(twist) => (Z, twist.profile().creases()),
            Self::Bend(bend) if bend.rate() == 0.0 => (Y, Vec::new()),
            Self::Bend(bend) => (Y, bend.range().to_vec()),
        }
    }
}

/// The creases of a chain of deformations, in the undeformed space.
#[derive(Debug)]
pub(super) struct Creases<'a> {
    /// Every stage up to the last that has any, its axis and places.
    stages: Vec<(&'a Deformation, usize, Vec<f64>)>,
}

impl<'a> Creases<'a> {
    /// Those of a chain.
    pub fn of(chain: &'a Chain) -> Self {
        let mut stages: Vec<_> = chain
            .stages()
            .iter()
            .map(|stage| {
                let (axis, places) = stage.kind().creases();
                (stage, axis, places)
            })
            .collect();
        while stages.last().is_some_and(|(_, _, places)| places.is_empty()) {
            stages.pop();
        }
        Self { stages }
    }

    /// By how much a point, when its turn comes, is beyond each crease.
    pub fn offsets(&self, x: &Vector3<f64>) -> Vec<f64> {
        let (mut x, mut offsets) = (*x, Vec::new());
        for (stage, axis, places) in &self.stages {
            let along = stage.frame().model_from_world(&x)[*axis];
            offsets.extend(places.iter().map(|place| along - place));
            x = stage.forward_of(x.into()).into();
        }
        offsets
    }
}
