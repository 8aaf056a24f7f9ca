//! Points coloured by their distance from the model, and what the colours mean.

use super::canvas::Canvas;
use crate::cloud::PointCloud;
use crate::outline::residual::Residual;
use crate::solid::Tree;
use crate::view::Projection;

/// Most points that are drawn: more would cover each other.
const MOST_POINTS: usize = 1500;

/// Share of the points whose distance is within the scale.
const WITHIN_SCALE: f64 = 0.95;

/// Ends of the scale, blue within the model and red outside, and its middle.
const INSIDE: [f64; 3] = [40.0, 90.0, 255.0];
const ON_SURFACE: [f64; 3] = [245.0, 245.0, 245.0];
const OUTSIDE: [f64; 3] = [255.0, 50.0, 30.0];

/// Radius of a dot.
const DOT: f32 = 1.3;

/// Draws points of the camera's frame, coloured by their distance from a solid, and the scale;
/// nothing if there are none.
pub(super) fn draw(
    canvas: &mut Canvas,
    points_camera: &PointCloud,
    solid_camera: &Tree,
    camera: &impl Projection,
) {
    let residual = Residual::of(solid_camera);
    let step = points_camera.len().div_ceil(MOST_POINTS).max(1);
    let points: Vec<_> =
        points_camera.points().step_by(step).map(nalgebra::Vector3::from).collect();
    let distances: Vec<f64> = points.iter().map(|x| residual.at(x)).collect();
    let Some(end) = scale_end(&distances) else { return };
    for (x, distance) in points.iter().zip(&distances) {
        if let Some(pixel) = camera.project(x) {
            canvas.dot(pixel, DOT, color(distance / end));
        }
    }
    draw_scale(canvas, residual.name(), end);
}

/// A round number that most distances are within; none without points.
fn scale_end(distances: &[f64]) -> Option<f64> {
    let mut magnitudes: Vec<f64> = distances.iter().map(|distance| distance.abs()).collect();
    magnitudes.sort_by(f64::total_cmp);
    let last = magnitudes.len().checked_sub(1)?;
    let magnitude = magnitudes[(WITHIN_SCALE * last as f64) as usize];
    if !magnitude.is_normal() {
        return Some(1.0);
    }
    let decade = 10.0_f64.powf(magnitude.log10().floor());
    let round = [1.0, 2.0, 5.0, 10.0].into_iter().find(|digit| digit * decade >= magnitude);
    Some(round.unwrap_or(10.0) * decade)
}

/// The colour of a distance in ends of the scale.
fn color(share: f64) -> [u8; 3] {
    let end = if share < 0.0 { INSIDE } else { OUTSIDE };
    let weight = share.abs().min(1.0);
    std::array::from_fn(|i| (ON_SURFACE[i] + weight * (end[i] - ON_SURFACE[i])).round() as u8)
}

/// The scale, in the lower left corner, on a dark ground.
fn draw_scale(canvas: &mut Canvas, name: &str, end: f64) {
    let title = &format!("{name}, in the model's unit");
    let ends = [format!("-{end}"), "0".to_owned(), format!("+{end}")];
    let [width, height] = canvas.letters(title.len());
    let margin = 6.0 * canvas.scale();
    let bar_height = 10.0 * canvas.scale();
    let ground = [width + 2.0 * margin, 2.0 * height + bar_height + 4.0 * margin];
    let left = margin;
    let top = canvas.size()[1] as f32 - ground[1] - margin;
    canvas.fill([left, top], ground, [0, 0, 0, 170]);
    canvas.write(title, [left + margin, top + margin]);

    let bar_top = top + 2.0 * margin + height;
    let steps = width.max(1.0) as u32;
    for step in 0..steps {
        let share = 2.0 * (f64::from(step) + 0.5) / f64::from(steps) - 1.0;
        let [red, green, blue] = color(share);
        let x = left + margin + step as f32;
        canvas.fill([x, bar_top], [1.0, bar_height], [red, green, blue, 255]);
    }
    let text_top = bar_top + bar_height + margin;
    for (share, text) in [0.0, 0.5, 1.0].into_iter().zip(ends) {
        let indent = share * (width - canvas.letters(text.len())[0]);
        canvas.write(&text, [left + margin + indent, text_top]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_ends_at_a_round_number_that_most_points_are_within() {
        let distances: Vec<f64> = (0..100).map(|i| f64::from(i) * 1e-5).collect();
        assert_eq!(scale_end(&distances), Some(1e-3));
        assert_eq!(scale_end(&[-0.03]), Some(0.05));
        assert_eq!(scale_end(&[0.0, 0.0]), Some(1.0));
        assert_eq!(scale_end(&[]), None);
    }

    #[test]
    fn colours_part_inside_from_outside() {
        assert_eq!(color(-7.0), [40, 90, 255]);
        assert_eq!(color(0.0), [245, 245, 245]);
        assert_eq!(color(1.0), [255, 50, 30]);
    }
}
