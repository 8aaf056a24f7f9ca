//! What a solid tells of points.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::point_table::PointTable;
use crate::cloud::PointCloud;
use crate::model::Model;
use crate::shape::{LevelSet, Shape, Solid, Superellipsoid};
use crate::solid::{Primitive, Tree};

/// Columns that every solid has.
const PLACE: [&str; 4] = ["x", "y", "z", "inside"];
/// Columns of one shape, deformed or not.
const FUNCTION: [&str; 4] = ["inside_outside", "gradient_x", "gradient_y", "gradient_z"];
/// Columns of a superellipsoid.
const NEAREST: [&str; 4] = ["euclidean_distance", "nearest_x", "nearest_y", "nearest_z"];

/// What is known of points of the world: a row for each of the cloud's, one of NaN for each that was
/// skipped.
///
/// Columns are `x y z`, and `inside`, 1 or 0; of one model the inside-outside function and its
/// gradient, `inside_outside gradient_x gradient_y gradient_z`, of the undeformed point if it is
/// deformed (B84 section 4). What is not deformed has a `radial_distance` (JLS Eq. 2.43), a
/// superellipsoid of exponents up to 2 also the signed `euclidean_distance` and its foot, `nearest_x
/// nearest_y nearest_z`. Of unions, intersections and differences there is the `level` (B81): below
/// 1 inside, 1 on the surface.
pub fn evaluation_table(solid: &Tree, cloud: &PointCloud) -> PointTable {
    match solid {
        Tree::Leaf(primitive) => match primitive.undeformed() {
            Some(model) => of_model(&model, cloud),
            None => of_deformed(primitive, cloud),
        },
        parts => {
            let level = |x: &Vector3<f64>| vec![parts.level((*x).into())];
            table(cloud, &["level"], |x| parts.contains(x), level)
        }
    }
}

fn of_model(model: &Model<Shape>, cloud: &PointCloud) -> PointTable {
    let superellipsoid = superellipsoid_of(model);
    let mut columns = FUNCTION.to_vec();
    columns.push("radial_distance");
    if superellipsoid.is_some() {
        columns.extend(NEAREST);
    }
    let values = |x_world: &Vector3<f64>| {
        let x = model.pose.model_from_world(x_world);
        let gradient = model.pose.rotation() * model.shape.inside_outside_gradient(&x);
        let mut values = vec![model.shape.inside_outside(&x)];
        values.extend(gradient.iter());
        values.push(Solid::radial_distance(&model.shape, &x));
        if let Some(shape) = &superellipsoid {
            let foot = shape.nearest_point(&x);
            let distance = (x - foot).norm();
            values.push(if shape.gauge(&x) < 1.0 { -distance } else { distance });
            values.extend(model.pose.world_from_model(&foot).iter());
        }
        values
    };
    table(cloud, &columns, |x| model.contains(x), values)
}

/// The superellipsoid, if it is one for whose points feet can be found.
fn superellipsoid_of(model: &Model<Shape>) -> Option<Superellipsoid> {
    match model.shape {
        Shape::Superellipsoid(shape) => {
            shape.exponents().iter().all(|&e| e <= 2.0).then_some(shape)
        }
        _ => None,
    }
}

fn of_deformed(primitive: &Primitive<Shape>, cloud: &PointCloud) -> PointTable {
    let values = |x_world: &Vector3<f64>| {
        let x = primitive.pose.model_from_world(x_world);
        let gradient = primitive.pose.rotation() * primitive.deformed.inside_outside_gradient(&x);
        let mut values = vec![primitive.deformed.inside_outside(&x)];
        values.extend(gradient.iter());
        values
    };
    table(cloud, &FUNCTION, |x| primitive.contains(x), values)
}

/// The table of columns besides those of the place.
fn table(
    cloud: &PointCloud,
    columns: &[&'static str],
    is_inside: impl Fn(&Vector3<f64>) -> bool + Sync,
    values: impl Fn(&Vector3<f64>) -> Vec<f64> + Sync,
) -> PointTable {
    let columns = [&PLACE[..], columns].concat();
    let row = |point: Option<[f64; 3]>| {
        let Some(point) = point else { return vec![f64::NAN; columns.len()] };
        let x = Vector3::from(point);
        let mut row = point.to_vec();
        row.push(f64::from(u8::from(is_inside(&x))));
        row.extend(values(&x));
        row
    };
    let values = input_rows(cloud).into_par_iter().flat_map_iter(row).collect();
    PointTable::new(columns, values)
}

/// The points in the order of the input, nothing where a row was skipped.
fn input_rows(cloud: &PointCloud) -> Vec<Option<[f64; 3]>> {
    let mut points = cloud.points();
    let skipped = cloud.skipped_rows();
    let row = |index| if skipped.binary_search(&index).is_ok() { None } else { points.next() };
    (0..cloud.rows()).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_were_skipped_keep_their_place() {
        let nan = f64::NAN;
        let rows = [[nan, 0.0, 0.0], [1.0, 2.0, 3.0], [0.0, nan, 0.0], [4.0, 5.0, 6.0]];
        let cloud = PointCloud::from_rows(rows);
        let expected = [None, Some(rows[1]), None, Some(rows[3])];
        assert_eq!(input_rows(&cloud), expected);
        let table = table(&cloud, &["sum"], |x| x.x > 2.0, |x| vec![x.sum()]);
        assert_eq!(table.columns(), ["x", "y", "z", "inside", "sum"]);
        let found: Vec<&[f64]> = table.rows().collect();
        assert_eq!(
            (found[1], found[3]),
            (&[1.0, 2.0, 3.0, 0.0, 6.0][..], &[4.0, 5.0, 6.0, 1.0, 15.0][..])
        );
        assert!([found[0], found[2]].concat().iter().all(|value| value.is_nan()));
    }
}
