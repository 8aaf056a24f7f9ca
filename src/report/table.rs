//! Tables for a person at a terminal.

use std::fmt::Write;

use super::primitive_document::masses;
use super::solid_info::{SceneInfoDocument, SolidInfoDocument};
use crate::model::Model;
use crate::recover::{Fit, RangeNoise};
use crate::shape::{Shape, Solid};
use crate::solid::Primitive;

/// Digits to which a person wants to read a parameter.
const DIGITS: usize = 6;

/// Digits of an error.
const ROUGH: usize = 2;

/// What a fit has found, in a few lines.
pub fn fit_table(fit: &Fit, seconds: f64) -> String {
    let mut table = parameters(&fit.model.into());
    let half = fit.covariance.half_intervals();
    line(
        &mut table,
        "+- (95 %)",
        &format!(
            "{} size, {} exponents, {} centre",
            vector(&half[..3], ROUGH),
            vector(&half[3..5], ROUGH),
            vector(&half[8..], ROUGH)
        ),
    );
    let percent = 100.0 * fit.relative_rms();
    line(
        &mut table,
        "residual",
        &format!(
            "{} radial RMS ({percent:.2} % of the mean semi-axis), {} geometric",
            number(fit.rms_radial, DIGITS),
            number(fit.rms_geometric, DIGITS),
        ),
    );
    if let Some(RangeNoise { along, across }) = fit.range_noise {
        let [along, across] = [along, across].map(|deviation| number(deviation, ROUGH));
        line(&mut table, "noise", &format!("{along} along the sensor's rays, {across} across"));
    }
    line(
        &mut table,
        "points",
        &format!(
            "{} used, {} of them strays; {} skipped",
            fit.points,
            fit.points - fit.inliers(),
            fit.points_skipped
        ),
    );
    line(
        &mut table,
        "search",
        &format!(
            "{} starts, {} evaluations, {:.1} ms, {} ({})",
            fit.starts,
            fit.evaluations,
            1e3 * seconds,
            fit.termination.status(),
            fit.termination.reason.replace('_', " "),
        ),
    );
    if fit.is_trusted() {
        line(&mut table, "verdict", "can be trusted");
    }
    for doubt in &fit.doubts {
        line(&mut table, "verdict", &format!("not to be trusted: {doubt}"));
    }
    table
}

/// What a fit has found, in one line after the cloud's name.
pub fn fit_line(name: &str, fit: &Fit) -> String {
    let verdict = if fit.is_trusted() { "trusted" } else { "not trusted" };
    let size = vector(&fit.model.shape.size(), DIGITS);
    let exponents = vector(&fit.model.shape.exponents(), DIGITS);
    format!("{name}  size {size}  exponents {exponents}  {verdict}\n")
}

/// What is known of a model, in a few lines.
pub fn model_table(model: &Model<Shape>) -> String {
    let mut table = parameters(model);
    let [least, greatest] = model.shape.bounding_box();
    let mass = model.shape.mass_properties();
    line(&mut table, "extents", &vector((greatest - least).as_slice(), DIGITS));
    line(&mut table, "volume", &number(mass.volume(), DIGITS));
    line(&mut table, "area", &number(model.shape.surface_area(), DIGITS));
    let inertia = mass.inertia().diagonal();
    let [min, max] = model.bounding_box();
    line(&mut table, "inertia", &format!("{}  (model axes)", vector(inertia.as_slice(), DIGITS)));
    line(&mut table, "box min", &vector(min.as_slice(), DIGITS));
    line(&mut table, "box max", &vector(max.as_slice(), DIGITS));
    table
}

/// What is known of a deformed model, in a few lines.
pub fn primitive_table(primitive: &Primitive<Shape>) -> String {
    let Primitive { deformed, pose } = primitive;
    let mut table = parameters(&Model { shape: *deformed.shape(), pose: *pose });
    for stage in deformed.chain().stages() {
        line(&mut table, "then", stage.kind().name());
    }
    let estimate = masses(primitive);
    let [min, max] = primitive.bounding_box();
    let inertia = estimate.properties.inertia();
    line(&mut table, "volume", &number(estimate.properties.volume(), DIGITS));
    line(&mut table, "area", &number(estimate.surface_area, DIGITS));
    for (name, row) in ["inertia", "", ""].iter().zip(inertia.row_iter()) {
        line(&mut table, name, &vector(row.transpose().as_slice(), DIGITS));
    }
    line(&mut table, "mass error", &format!("{:.0e} at most", estimate.error));
    line(&mut table, "box min", &vector(min.as_slice(), DIGITS));
    line(&mut table, "box max", &vector(max.as_slice(), DIGITS));
    table
}

/// What is known of a solid that is made of several models, for people.
pub fn solid_table(info: &SolidInfoDocument) -> String {
    let mut table = String::new();
    let [least, most] = info.volume_bounds.map(|bound| number(bound, DIGITS));
    line(&mut table, "models", &info.models.to_string());
    line(&mut table, "volume", &format!("{least} to {most}"));
    box_lines(&mut table, info.bounding_box);
    table
}

/// What is known of a scene, for people.
pub fn scene_table(info: &SceneInfoDocument) -> String {
    let mut table = String::new();
    for (i, solid) in info.solids.iter().enumerate() {
        line(&mut table, "solid", &(i + 1).to_string());
        table += &solid_table(solid);
    }
    line(&mut table, "all", &format!("{} solids", info.solids.len()));
    box_lines(&mut table, info.bounding_box);
    table
}

fn box_lines(table: &mut String, bounding_box: Option<[[f64; 3]; 2]>) {
    let Some([min, max]) = bounding_box else { return line(table, "box", "empty") };
    line(table, "box min", &vector(&min, DIGITS));
    line(table, "box max", &vector(&max, DIGITS));
}

fn parameters(model: &Model<Shape>) -> String {
    let mut table = of_shape(&model.shape);
    let [phi, theta, psi] = model.pose.euler_zyz().map(f64::to_degrees);
    line(&mut table, "centre", &vector(model.pose.translation().as_slice(), DIGITS));
    line(&mut table, "rotation", &format!("{phi:.3} {theta:.3} {psi:.3}  (Euler ZYZ, degrees)"));
    for (name, axis) in ["axis x", "axis y", "axis z"].iter().zip(0..) {
        line(
            &mut table,
            name,
            &vector(model.pose.rotation().matrix().column(axis).as_slice(), DIGITS),
        );
    }
    table
}

/// The parameters of a shape; the family is named where it is not a superellipsoid.
fn of_shape(shape: &Shape) -> String {
    let mut table = String::new();
    let (size, exponents, names, more) = match shape {
        Shape::Superellipsoid(s) => (s.size(), s.exponents().to_vec(), "e1 e2", None),
        Shape::SuperhyperboloidOneSheet(s) => {
            (s.size(), s.exponents().to_vec(), "e1 e2", Some(("clip", s.clip(), "greatest |z|")))
        }
        Shape::SuperhyperboloidTwoSheets(s) => {
            (s.size(), s.exponents().to_vec(), "e1 e2", Some(("clip", s.clip(), "greatest |x|")))
        }
        Shape::Supertoroid(s) => (
            s.size(),
            s.exponents().to_vec(),
            "e1 e2",
            Some(("ring", s.ring(), "a4, in a1 and a2")),
        ),
        Shape::ThreeExponent(s) => (s.size(), s.exponents().to_vec(), "n1 n2 n3", None),
    };
    if !matches!(shape, Shape::Superellipsoid(_)) {
        line(&mut table, "family", &shape.family().replace('_', " "));
    }
    line(&mut table, "size", &format!("{}  (semi-axes a1 a2 a3)", vector(&size, DIGITS)));
    line(&mut table, "exponents", &format!("{}  ({names})", vector(&exponents, DIGITS)));
    if let Some((name, value, meaning)) = more {
        line(&mut table, name, &format!("{}  ({meaning})", number(value, DIGITS)));
    }
    table
}

fn line(table: &mut String, name: &str, value: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(table, "{name:<10} {value}");
}

fn vector(values: &[f64], digits: usize) -> String {
    values.iter().map(|value| number(*value, digits)).collect::<Vec<_>>().join(" ")
}

/// A number with some significant digits, in the plainer of the two notations.
fn number(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-4..9).contains(&magnitude) {
        return format!("{value:.*e}", digits - 1);
    }
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_six_significant_digits() {
        for (value, text) in [
            (0.0, "0"),
            (1.0, "1.00000"),
            (-123.456789, "-123.457"),
            (1234567.8, "1234568"),
            (0.000123456789, "0.000123457"),
            (1.23456789e-9, "1.23457e-9"),
            (-9.8765432e12, "-9.87654e12"),
        ] {
            assert_eq!(number(value, DIGITS), text);
        }
    }
}
