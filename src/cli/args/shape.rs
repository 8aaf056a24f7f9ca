//! What is known of the shape.

use clap::ValueEnum;

use super::parse::vector;
use crate::recover::{Constraints, Tie};

/// What is known of the shape.
#[derive(Debug, clap::Args)]
pub(in crate::cli) struct ShapeArgs {
    /// What kind of shape it is.
    #[arg(long, value_enum, default_value_t)]
    pub class: ClassArg,
    /// Fix a parameter: a1, a2, a3, e1, e2, or the centre's x, y, z. May be repeated.
    #[arg(long, value_name = "NAME=VALUE", value_parser = fixed)]
    pub fix: Vec<(String, f64)>,
    /// Semi-axes are from LOW to HIGH, in the cloud's unit.
    #[arg(long, value_name = "LOW,HIGH", value_parser = vector::<2>)]
    pub size_range: Option<[f64; 2]>,
    /// Exponents are from LOW to HIGH, within 0.05 to 2.
    #[arg(long, value_name = "LOW,HIGH", value_parser = vector::<2>)]
    pub exponent_range: Option<[f64; 2]>,
    /// Semi-axes that are equal.
    #[arg(long, value_enum)]
    pub tie: Option<TieArg>,
}

/// A class of shapes, as it is typed.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(in crate::cli) enum ClassArg {
    /// Any superellipsoid.
    #[default]
    Any,
    /// A box: exponents up to 0.4.
    Box,
    /// A circular cylinder along z: a1 = a2, e2 = 1, e1 up to 0.4.
    Cylinder,
    /// Exponents 1.
    Ellipsoid,
    /// Exponents 1 and equal semi-axes.
    Sphere,
}

/// Semi-axes that are equal, as it is typed.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(in crate::cli) enum TieArg {
    /// a1 = a2.
    Equator,
    /// a1 = a2 = a3.
    All,
}

impl ShapeArgs {
    /// The constraints that are meant: those of the class, then what narrows them.
    pub fn constraints(&self) -> Constraints {
        let mut constraints = match self.class {
            ClassArg::Any => Constraints::NONE,
            ClassArg::Box => Constraints::cuboid(),
            ClassArg::Cylinder => Constraints::cylinder(),
            ClassArg::Ellipsoid => Constraints::ellipsoid(),
            ClassArg::Sphere => Constraints::sphere(),
        };
        if let Some(range) = self.size_range {
            constraints.size = [range; 3];
        }
        if let Some(range) = self.exponent_range {
            constraints.exponents = [range; 2];
        }
        match self.tie {
            Some(TieArg::Equator) => constraints.tie = Tie::Equator,
            Some(TieArg::All) => constraints.tie = Tie::All,
            None => {}
        }
        for (name, value) in &self.fix {
            constraints.fix(name, *value);
        }
        constraints
    }
}

/// The name of a parameter and its value.
fn fixed(text: &str) -> Result<(String, f64), String> {
    let expected = || "expected one of a1 a2 a3 e1 e2 x y z, =, and a number".to_owned();
    let (name, value) = text.split_once('=').ok_or_else(expected)?;
    let [value] = vector(value).map_err(|_| expected())?;
    let is_name = Constraints::NONE.clone().fix(name.trim(), value);
    if is_name { Ok((name.trim().to_owned(), value)) } else { Err(expected()) }
}
