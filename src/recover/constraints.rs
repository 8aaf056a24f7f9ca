//! What the caller knows of the parameters: bounds, of which a fixed value is the narrowest, and
//! ties. Classes of shapes are made of these.

use super::chart::EXPONENT_BOUNDS;
use super::normalization::Normalization;
use crate::model::Model;

/// Semi-axes that are equal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tie {
    /// None need be.
    #[default]
    None,
    /// `a1 = a2`.
    Equator,
    /// `a1 = a2 = a3`.
    All,
}

impl Tie {
    /// How many of the semi-axes, counted from the first, are equal.
    fn count(self) -> usize {
        match self {
            Self::None => 1,
            Self::Equator => 2,
            Self::All => 3,
        }
    }
}

/// Bounds `[low, high]`, ends included; a value is fixed where both are the same.
pub type Bounds = [f64; 2];

/// What is known of the parameters. By default nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constraints {
    /// Bounds of the semi-axes `a1 a2 a3`, in the cloud's unit.
    pub size: [Bounds; 3],
    /// Bounds of the exponents `e1 e2`, within 0.05..2.
    pub exponents: [Bounds; 2],
    /// Which semi-axes are equal.
    pub tie: Tie,
    /// Coordinates of the centre that are fixed, in the cloud's frame.
    pub centre: [Option<f64>; 3],
}

/// Sharp edges: exponents up to this make a box or the rim of a can.
const SHARP: Bounds = [EXPONENT_BOUNDS[0], 0.4];

/// Round.
const ROUND: Bounds = [1.0, 1.0];

impl Default for Constraints {
    fn default() -> Self {
        Self::NONE
    }
}

impl Constraints {
    /// Nothing is known.
    pub const NONE: Self = Self {
        size: [[0.0, f64::INFINITY]; 3],
        exponents: [EXPONENT_BOUNDS; 2],
        tie: Tie::None,
        centre: [None; 3],
    };

    /// A box with more or less sharp edges: both exponents up to 0.4.
    pub fn cuboid() -> Self {
        Self { exponents: [SHARP; 2], ..Self::default() }
    }

    /// A circular cylinder along z: `a1 = a2`, `e2 = 1`, `e1` up to 0.4.
    pub fn cylinder() -> Self {
        Self { exponents: [SHARP, ROUND], tie: Tie::Equator, ..Self::default() }
    }

    /// An ellipsoid: both exponents 1.
    pub fn ellipsoid() -> Self {
        Self { exponents: [ROUND; 2], ..Self::default() }
    }

    /// A sphere: an ellipsoid whose semi-axes are equal.
    pub fn sphere() -> Self {
        Self { tie: Tie::All, ..Self::ellipsoid() }
    }

    /// Fixes the parameter of a name: a1 a2 a3 e1 e2, or the centre's x y z. Whether there is one.
    pub fn fix(&mut self, name: &str, value: f64) -> bool {
        match name {
            "a1" => self.size[0] = [value; 2],
            "a2" => self.size[1] = [value; 2],
            "a3" => self.size[2] = [value; 2],
            "e1" => self.exponents[0] = [value; 2],
            "e2" => self.exponents[1] = [value; 2],
            "x" => self.centre[0] = Some(value),
            "y" => self.centre[1] = Some(value),
            "z" => self.centre[2] = Some(value),
            _ => return false,
        }
        true
    }

    /// Why these cannot hold, if they cannot.
    pub(crate) fn contradiction(&self) -> Option<String> {
        let named = ["a1", "a2", "a3", "e1", "e2"].into_iter();
        let (least, greatest) = (EXPONENT_BOUNDS[0], EXPONENT_BOUNDS[1]);
        for (name, [low, high]) in named.zip(self.size.into_iter().chain(self.exponents)) {
            let is_exponent = name.starts_with('e');
            // Written so that NaN is refused too.
            let is_range = low <= high;
            if !is_range {
                return Some(format!("{name} is to be from {low} to {high}: nothing is"));
            }
            if is_exponent && (low < least || high > greatest) {
                return Some(format!(
                    "{name} is to be from {low} to {high}, but exponents are from {least} to {greatest}"
                ));
            }
            if !is_exponent && (low < 0.0 || high <= 0.0) {
                return Some(format!("{name} is to be from {low} to {high}: sizes are positive"));
            }
        }
        let [low, high] = self.tied_bounds();
        if low > high {
            return Some("the bounds of semi-axes that are to be equal do not overlap".to_owned());
        }
        let is_finite = self.centre.iter().flatten().all(|coordinate| coordinate.is_finite());
        (!is_finite).then(|| "the centre is to be at a coordinate that is not finite".to_owned())
    }

    /// The bounds that all tied semi-axes keep.
    fn tied_bounds(&self) -> Bounds {
        let tied = &self.size[..self.tie.count()];
        let [mut low, mut high] = tied[0];
        for bounds in tied {
            (low, high) = (low.max(bounds[0]), high.min(bounds[1]));
        }
        [low, high]
    }

    /// The same in normalised coordinates.
    pub(crate) fn normalized(&self, normalization: &Normalization) -> NormalizedConstraints {
        let tied = self.tied_bounds();
        let log = |bounds: Bounds| bounds.map(|size| (size * normalization.inverse_radius).ln());
        let centre = std::array::from_fn(|k| {
            let centroid = normalization.centroid[k];
            self.centre[k].map(|at| (at - centroid) * normalization.inverse_radius)
        });
        NormalizedConstraints {
            log_size: std::array::from_fn(|k| {
                log(if k < self.tie.count() { tied } else { self.size[k] })
            }),
            exponents: self.exponents,
            tied: self.tie.count(),
            centre,
        }
    }
}

/// Constraints in normalised coordinates, as the optimiser needs them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NormalizedConstraints {
    /// Bounds of `ln a`.
    pub log_size: [Bounds; 3],
    pub exponents: [Bounds; 2],
    /// How many of the semi-axes, counted from the first, are equal.
    pub tied: usize,
    pub centre: [Option<f64>; 3],
}

impl NormalizedConstraints {
    /// Nothing is known.
    #[cfg(test)]
    pub const NONE: Self = Self {
        log_size: [[f64::NEG_INFINITY, f64::INFINITY]; 3],
        exponents: [EXPONENT_BOUNDS; 2],
        tied: 1,
        centre: [None; 3],
    };

    /// The one form that stands for all equivalent ones, unless bounds of the sizes name the axes.
    pub fn final_form(&self, model: &Model) -> Model {
        let name_axes = self.log_size.iter().flatten().any(|bound| bound.is_finite());
        if name_axes { *model } else { model.canonical() }
    }

    /// That form, where the optimiser may start from it: it may name the axes that are tied anew.
    pub fn start_form(&self, model: &Model) -> Model {
        if self.tied > 1 { *model } else { self.final_form(model) }
    }

    /// In another normalisation of the same cloud.
    pub fn renormalized(&self, from: &Normalization, to: &Normalization) -> Self {
        let log_ratio = (from.radius * to.inverse_radius).ln();
        let shift = to.normalized(from.centroid);
        let ratio = from.radius * to.inverse_radius;
        Self {
            log_size: self.log_size.map(|bounds| bounds.map(|log| log + log_ratio)),
            centre: std::array::from_fn(|k| self.centre[k].map(|at| at * ratio + shift[k])),
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_hold_is_said() {
        let none = Constraints::default();
        assert_eq!(none.contradiction(), None);
        for class in [
            Constraints::cuboid(),
            Constraints::cylinder(),
            Constraints::ellipsoid(),
            Constraints::sphere(),
        ] {
            assert_eq!(class.contradiction(), None);
        }
        let mut sizes = none;
        sizes.size[1] = [2.0, 1.0];
        assert!(sizes.contradiction().unwrap().starts_with("a2 is to be from 2 to 1"));
        sizes.size[1] = [-1.0, 1.0];
        assert!(sizes.contradiction().unwrap().ends_with("sizes are positive"));
        sizes.size[1] = [f64::NAN, 1.0];
        assert!(sizes.contradiction().is_some());
        let exponents = Constraints { exponents: [[0.0, 1.0], [1.0, 1.0]], ..none };
        assert!(exponents.contradiction().unwrap().starts_with("e1"));
        let apart = [[1.0, 2.0], [3.0, 4.0], [1.0, 9.0]];
        let tied = Constraints { size: apart, tie: Tie::Equator, ..none };
        assert!(tied.contradiction().unwrap().contains("overlap"));
        assert_eq!(Constraints { tie: Tie::None, ..tied }.contradiction(), None);
    }

    #[test]
    fn parameters_are_fixed_by_their_names() {
        let mut fixed = Constraints::default();
        for (value, name) in (1..).zip(["a1", "a2", "a3", "e1", "e2", "x", "y", "z"]) {
            assert!(fixed.fix(name, f64::from(value)));
        }
        assert!(!fixed.fix("a4", 1.0));
        assert_eq!(fixed.size, [[1.0; 2], [2.0; 2], [3.0; 2]]);
        assert_eq!(fixed.exponents, [[4.0; 2], [5.0; 2]]);
        assert_eq!(fixed.centre, [Some(6.0), Some(7.0), Some(8.0)]);
    }

    #[test]
    fn another_normalisation_has_the_same_constraints() {
        let from = Normalization { centroid: [1.0, 2.0, 3.0], radius: 2.0, inverse_radius: 0.5 };
        let to = Normalization { centroid: [-1.0, 0.0, 3.5], radius: 4.0, inverse_radius: 0.25 };
        let known = Constraints {
            size: [[1.0, 2.0], [1.5, 9.0], [0.5, 0.5]],
            tie: Tie::Equator,
            centre: [Some(4.0), None, Some(-2.0)],
            ..Constraints::default()
        };
        let direct = known.normalized(&to);
        let indirect = known.normalized(&from).renormalized(&from, &to);
        assert_eq!(direct.log_size[0], [(1.5_f64 / 4.0).ln(), (2.0_f64 / 4.0).ln()]);
        for k in 0..3 {
            for end in 0..2 {
                assert!((direct.log_size[k][end] - indirect.log_size[k][end]).abs() < 1e-14);
            }
            assert_eq!(direct.centre[k].is_some(), known.centre[k].is_some());
            let difference = direct.centre[k].unwrap_or(0.0) - indirect.centre[k].unwrap_or(0.0);
            assert!(difference.abs() < 1e-14);
        }
    }
}
