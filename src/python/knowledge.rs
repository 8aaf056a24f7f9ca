//! What a caller knows besides the points, from keyword arguments.

use std::collections::HashMap;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::arrays::Doubles;
use super::errors::ArrayError;
use crate::recover::{Constraints, Plane, Sight, SightLine, Tie};

/// A sensor, if there is one.
pub(super) fn sight(
    viewpoint: Option<&Bound<'_, PyAny>>,
    free_rays: Option<&Bound<'_, PyAny>>,
) -> PyResult<Option<Sight>> {
    let Some(viewpoint) = viewpoint else {
        return match free_rays {
            Some(_) => Err(PyValueError::new_err("free_rays need a viewpoint")),
            None => Ok(None),
        };
    };
    let viewpoint = Doubles::new("viewpoint", viewpoint)?.vector::<3>()?;
    if viewpoint.iter().any(|coordinate| !coordinate.is_finite()) {
        return Err(ArrayError::new_err("viewpoint: expected finite coordinates"));
    }
    let free = free_rays.map_or(Ok(Vec::new()), rays)?;
    Ok(Some(Sight { viewpoint, free }))
}

fn rays(value: &Bound<'_, PyAny>) -> PyResult<Vec<SightLine>> {
    let rays = Doubles::new("free_rays", value)?;
    if !matches!(rays.shape(), [_, 4]) {
        return Err(rays.wrong_shape("(n, 4)"));
    }
    let line = |&[x, y, z, reach]: &[f64; 4]| {
        let is_ray = [x, y, z].iter().all(|along| along.is_finite()) && reach > 0.0;
        let message = "free_rays: expected finite directions and positive lengths";
        is_ray
            .then_some(SightLine { direction: [x, y, z], reach })
            .ok_or_else(|| ArrayError::new_err(message))
    };
    rays.values()?.as_chunks::<4>().0.iter().map(line).collect()
}

/// A plane from its coefficients.
pub(super) fn plane(value: &Bound<'_, PyAny>) -> PyResult<Plane> {
    let [a, b, c, d] = Doubles::new("support", value)?.vector::<4>()?;
    let message = "support: expected (a, b, c, d) with a normal (a, b, c) other than 0";
    Plane::new([a, b, c], d).ok_or_else(|| PyValueError::new_err(message))
}

/// Constraints from a class of shapes and what narrows it.
pub(super) fn constraints(
    shape: &str,
    fix: &HashMap<String, f64>,
    size_range: Option<[f64; 2]>,
    exponent_range: Option<[f64; 2]>,
    tie: Option<&str>,
) -> PyResult<Constraints> {
    let mut constraints = match shape {
        "any" => Constraints::NONE,
        "box" => Constraints::cuboid(),
        "cylinder" => Constraints::cylinder(),
        "ellipsoid" => Constraints::ellipsoid(),
        "sphere" => Constraints::sphere(),
        _ => return Err(unknown("shape", "any, box, cylinder, ellipsoid or sphere", shape)),
    };
    if let Some(range) = size_range {
        constraints.size = [range; 3];
    }
    if let Some(range) = exponent_range {
        constraints.exponents = [range; 2];
    }
    match tie {
        None => {}
        Some("none") => constraints.tie = Tie::None,
        Some("equator") => constraints.tie = Tie::Equator,
        Some("all") => constraints.tie = Tie::All,
        Some(name) => return Err(unknown("tie", "none, equator or all", name)),
    }
    for (name, value) in fix {
        if !constraints.fix(name, *value) {
            return Err(unknown("fix", "a1 a2 a3 e1 e2 x y z", name));
        }
    }
    Ok(constraints)
}

fn unknown(argument: &str, expected: &str, found: &str) -> PyErr {
    PyValueError::new_err(format!("{argument} must be of {expected}, found '{found}'"))
}
