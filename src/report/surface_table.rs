//! Points of a surface, with its normals and curvatures.

use nalgebra::Vector3;
use thiserror::Error;

use super::point_table::PointTable;
use crate::deform::Deform;
use crate::ray::outward_normal;
use crate::shape::{Shape, Solid};
use crate::solid::Primitive;
use crate::surface::{Parameterization, sample_deformed_surface, sample_shape_surface};

/// Cosines of the angle from the axis of a clip above which normals are those of its caps.
const OF_CAP: f64 = 1.0 - 1e-12;

/// How points are spread over a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// So many at random, uniform by area, the caps of a clip included.
    Area {
        /// Number of points.
        count: usize,
        /// What the points are the same for.
        seed: u64,
    },
    /// In rows, as [`Parameterization::shape`] has them.
    Rows {
        /// Where along the rows they are.
        parameterization: Parameterization,
        /// Steps to a quarter of a turn.
        steps: usize,
    },
}

/// Exponents under which points are not uniform by area, or take without end.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("points uniform by area need exponents up to 2, of three from 1, found {found}")]
pub struct NotUniform {
    /// The exponent.
    pub found: f64,
}

/// Points of a model's boundary in the world: columns `x y z`, the outward unit normal `nx ny nz`
/// and, where nothing is deformed, the principal curvatures `k1 k2`, the greater first, in one over
/// the unit of length. On an edge normals are between those of its sides, and curvatures may be
/// infinite or NaN.
///
/// # Errors
/// If points are to be uniform by area, and the exponents are none of those for which
/// [`sample_shape_surface`] holds.
pub fn surface_table(
    primitive: &Primitive<Shape>,
    spread: Spread,
) -> Result<PointTable, NotUniform> {
    let plain = primitive.undeformed();
    let mut columns = vec!["x", "y", "z", "nx", "ny", "nz"];
    if plain.is_some() {
        columns.extend(["k1", "k2"]);
    }
    let row = |x_model: Vector3<f64>| {
        let x_world = primitive.pose.world_from_model(&x_model);
        let normal = outward_normal(&primitive.deformed, &x_model);
        let curvatures = plain.map(|plain| curvatures(&plain.shape, &x_model, &normal));
        let place: [[f64; 3]; 2] = [x_world.into(), (primitive.pose.rotation() * normal).into()];
        place.into_iter().flatten().chain(curvatures.into_iter().flatten()).collect::<Vec<f64>>()
    };
    let values = points(primitive, spread)?.into_iter().flat_map(row).collect();
    Ok(PointTable::new(columns, values))
}

/// The points in the model's frame.
fn points(primitive: &Primitive<Shape>, spread: Spread) -> Result<Vec<Vector3<f64>>, NotUniform> {
    let (shape, chain) = (primitive.deformed.shape(), primitive.deformed.chain());
    match spread {
        Spread::Area { count, seed } => {
            require_uniform(shape)?;
            Ok(match primitive.undeformed() {
                Some(plain) => sample_shape_surface(&plain.shape, count, seed),
                None => sample_deformed_surface(&primitive.deformed, count, seed),
            })
        }
        Spread::Rows { parameterization, steps } => {
            let rows = parameterization.shape(shape, steps);
            let deformed = |x: Vector3<f64>| Vector3::from(chain.forward_of(x.into()));
            Ok(rows.into_iter().flatten().map(deformed).collect())
        }
    }
}

fn require_uniform(shape: &Shape) -> Result<(), NotUniform> {
    let above = |exponents: [f64; 2]| exponents.into_iter().find(|&e| e > 2.0);
    let found = match shape {
        Shape::Superellipsoid(shape) => above(shape.exponents()),
        Shape::SuperhyperboloidOneSheet(shape) => above(shape.exponents()),
        Shape::SuperhyperboloidTwoSheets(shape) => above(shape.exponents()),
        Shape::Supertoroid(shape) => above(shape.exponents()),
        Shape::ThreeExponent(shape) => shape.exponents().into_iter().find(|&n| n < 1.0),
    };
    found.map_or(Ok(()), |found| Err(NotUniform { found }))
}

/// The principal curvatures of a shape's boundary, where its normal is known: none on a cap.
fn curvatures(shape: &Shape, x: &Vector3<f64>, normal: &Vector3<f64>) -> [f64; 2] {
    let axis_of_clip = match shape {
        Shape::SuperhyperboloidOneSheet(_) => Some(2),
        Shape::SuperhyperboloidTwoSheets(_) => Some(0),
        _ => None,
    };
    // Normals of the bodies themselves lead back to the middle.
    let is_of_cap = |axis: usize| normal[axis] * x[axis].signum() > OF_CAP;
    match axis_of_clip {
        Some(axis) if is_of_cap(axis) => [0.0; 2],
        _ => shape.curvatures(x).principal,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::pose::Pose;
    use crate::shape::{Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets};

    fn table(shape: impl Into<Shape>, spread: Spread) -> PointTable {
        let model = Model { shape: shape.into(), pose: Pose::identity() };
        surface_table(&model.into(), spread).unwrap()
    }

    #[test]
    fn caps_are_flat_and_their_normals_are_along_the_axis() {
        let spread = Spread::Area { count: 2000, seed: 1 };
        let tower = SuperhyperboloidOneSheet::new([1.0; 3], [1.0; 2], 0.7).unwrap();
        let bowls = SuperhyperboloidTwoSheets::new([1.0; 3], [1.0; 2], 1.7).unwrap();
        for (table, axis, clip) in [(table(tower, spread), 2, 0.7), (table(bowls, spread), 0, 1.7)]
        {
            let is_on_cap = |row: &&[f64]| (row[axis].abs() - clip).abs() < 1e-12;
            let mut caps = 0;
            for row in table.rows().filter(is_on_cap) {
                caps += 1;
                let mut normal = [0.0; 3];
                normal[axis] = row[axis].signum();
                assert_eq!((&row[3..6], &row[6..8]), (&normal[..], &[0.0, 0.0][..]));
            }
            assert!(caps > 100);
            for row in table.rows().filter(|row| !is_on_cap(row)) {
                // The quadrics are bent both ways, and one way only.
                assert_eq!(row[7] < 0.0, axis == 2, "{row:?}");
                let normal = Vector3::from_row_slice(&row[3..6]);
                assert!((normal.norm() - 1.0).abs() < 1e-14);
                let x = Vector3::from_row_slice(&row[..3]);
                let outward = if axis == 2 { [x.x, x.y, -x.z] } else { [-x.x, x.y, x.z] };
                assert!((normal - Vector3::from(outward).normalize()).norm() < 1e-12);
            }
        }
    }

    /// Where F is a difference of powers that leave no digit of it.
    #[test]
    fn steep_sides_are_no_caps() {
        let tower = SuperhyperboloidOneSheet::new([1.0; 3], [0.05, 1.0], 300.0).unwrap();
        let rows = Spread::Rows { parameterization: Parameterization::Explicit, steps: 4 };
        let table = table(tower, rows);
        let side = table.rows().filter(|row| row[2].abs() > 10.0 && row[2].abs() < 290.0);
        // A cone of half a right angle: across its lines, 1 / (r sqrt(2)).
        let defects = side.map(|row| row[6] * row[2].abs() * 2.0_f64.sqrt() - 1.0);
        let defects: Vec<f64> = defects.collect();
        assert!(defects.len() == 6 * 16 && defects.iter().all(|d| d.abs() < 1e-9), "{defects:?}");
    }

    #[test]
    fn exponents_for_which_areas_do_not_hold_are_refused() {
        let shape = Superellipsoid::new([1.0; 3], [0.5, 2.5]).unwrap();
        let model = Model { shape: Shape::from(shape), pose: Pose::identity() };
        let error = surface_table(&model.into(), Spread::Area { count: 1, seed: 0 }).unwrap_err();
        assert!(error.to_string().ends_with("found 2.5"));
        let rows = Spread::Rows { parameterization: Parameterization::EqualDistance, steps: 2 };
        assert_eq!(table(shape, rows).rows().len(), 5 * 8);
    }
}
