//! Lines on a surface, parted into those that a camera sees and those that the solid hides.

use nalgebra::Vector3;

use super::projection::Projection;
use super::rim::Viewpoint;
use crate::model::Model;
use crate::shape::Superellipsoid;

/// Where lines stand on the sides of the cube that they are taken from.
const PLACES: [f64; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];

/// Segments of a line.
const SEGMENTS: u32 = 64;

/// Halvings that find where a line passes the rim: 1e-9 of its length.
const HALVINGS: usize = 30;

/// Lines `[column, row]` in an image.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wireframe {
    /// Lines on the side towards the camera.
    pub visible: Vec<Vec<[f64; 2]>>,
    /// Lines on the side away from it.
    pub hidden: Vec<Vec<[f64; 2]>>,
}

impl Wireframe {
    /// The lines of a grid on a cube of the model's semi-axes, projected from the centre onto the
    /// surface: on a box parallels of its edges, on a ball great circles. The model is given in the
    /// camera's frame, and is convex: exponents up to 2. What is behind the camera or not let
    /// through by the lens is left out.
    pub fn of(model_camera: &Model, camera: &impl Projection) -> Self {
        let sight = Sight::new(model_camera, camera.viewpoint(&model_camera.pose));
        let mut wireframe = Self::default();
        for line in cube_lines() {
            for (is_visible, piece) in sight.pieces(&line) {
                let lines = if is_visible { &mut wireframe.visible } else { &mut wireframe.hidden };
                lines.extend(projected(model_camera, camera, &piece));
            }
        }
        wireframe
    }
}

/// A straight line on the cube `max |x| = 1` along an axis.
struct CubeLine {
    axis: usize,
    across: [f64; 2],
}

impl CubeLine {
    /// The point at `along`, from -1 to 1.
    fn at(&self, along: f64) -> Vector3<f64> {
        let mut x = Vector3::zeros();
        x[self.axis] = along;
        x[(self.axis + 1) % 3] = self.across[0];
        x[(self.axis + 2) % 3] = self.across[1];
        x
    }
}

fn cube_lines() -> impl Iterator<Item = CubeLine> {
    let is_on_cube = |across: &[f64; 2]| across[0].abs().max(across[1].abs()) == 1.0;
    let places = PLACES.into_iter().flat_map(|p| PLACES.map(|q| [p, q])).filter(is_on_cube);
    places.flat_map(|across| (0..3).map(move |axis| CubeLine { axis, across }))
}

/// A shape and what of it is seen, in its own frame.
struct Sight<'m> {
    shape: &'m Superellipsoid,
    viewpoint: Viewpoint,
}

impl<'m> Sight<'m> {
    fn new(model: &'m Model, viewpoint: Viewpoint) -> Self {
        Self { shape: &model.shape, viewpoint }
    }

    /// The point of the surface on the ray through one of the cube's.
    fn surface_point(&self, x_cube: &Vector3<f64>) -> Vector3<f64> {
        self.shape.radial_projection(&x_cube.component_mul(&Vector3::from(self.shape.size())))
    }

    /// Whether the surface faces the camera there: on a convex solid, whether it is seen.
    fn is_visible(&self, x: &Vector3<f64>) -> bool {
        let gradient = self.shape.gauge_gradient(x);
        match self.viewpoint {
            Viewpoint::At(centre) => gradient.dot(&centre) > 1.0,
            Viewpoint::Along(direction) => gradient.dot(&direction) < 0.0,
        }
    }

    /// A line on the surface, parted where it passes the rim.
    fn pieces(&self, line: &CubeLine) -> Vec<(bool, Vec<Vector3<f64>>)> {
        let along = |i: u32| 2.0 * f64::from(i) / f64::from(SEGMENTS) - 1.0;
        let point = |along: f64| self.surface_point(&line.at(along));
        let first = point(-1.0);
        let mut pieces = vec![(self.is_visible(&first), vec![first])];
        for i in 1..=SEGMENTS {
            let x = point(along(i));
            let is_visible = self.is_visible(&x);
            if let Some((was_visible, piece)) = pieces.last_mut()
                && *was_visible != is_visible
            {
                let crossing = self.crossing(&point, [along(i - 1), along(i)], *was_visible);
                piece.push(crossing);
                pieces.push((is_visible, vec![crossing]));
            }
            if let Some((_, piece)) = pieces.last_mut() {
                piece.push(x);
            }
        }
        pieces
    }

    /// The point between two places at which the line changes sides.
    fn crossing(
        &self,
        point: &impl Fn(f64) -> Vector3<f64>,
        [mut low, mut high]: [f64; 2],
        low_is_visible: bool,
    ) -> Vector3<f64> {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.is_visible(&point(middle)) == low_is_visible {
                low = middle;
            } else {
                high = middle;
            }
        }
        point(high)
    }
}

/// The image of a line in the model's frame, parted where it is not seen.
fn projected(
    model_camera: &Model,
    camera: &impl Projection,
    line: &[Vector3<f64>],
) -> Vec<Vec<[f64; 2]>> {
    let pixels: Vec<Option<[f64; 2]>> =
        line.iter().map(|x| camera.project(&model_camera.pose.world_from_model(x))).collect();
    let runs = pixels.split(Option::is_none).filter(|run| run.len() > 1);
    runs.map(|run| run.iter().copied().flatten().collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::Pose;
    use crate::view::{Camera, Contour, Distortion};

    #[test]
    fn lines_lie_within_the_contour_and_change_sides_on_it() {
        let camera = Camera {
            fx: 500.0,
            fy: 500.0,
            cx: 319.5,
            cy: 239.5,
            width: 640,
            height: 480,
            depth_unit: None,
            distortion: Distortion::default(),
        };
        for exponents in [[0.1, 0.3], [1.0, 1.0], [0.3, 1.8]] {
            let shape = Superellipsoid::new([0.1, 0.2, 0.3], exponents).unwrap();
            let pose = Pose::from_euler_zyz([0.4, 1.0, -0.7], Vector3::new(0.1, 0.0, 1.2));
            let model = Model { shape, pose };
            let contour = Contour::of(&model, &camera).unwrap();
            let [min, max] = contour.bounding_box();
            let wireframe = Wireframe::of(&model, &camera);
            let length = |lines: &[Vec<[f64; 2]>]| {
                let of = |line: &Vec<[f64; 2]>| {
                    line.windows(2).map(|ends| distance(ends[0], ends[1])).sum::<f64>()
                };
                lines.iter().map(of).sum::<f64>()
            };
            assert!(length(&wireframe.visible) > 100.0 && length(&wireframe.hidden) > 100.0);
            let ends = |lines: &[Vec<[f64; 2]>]| -> Vec<[f64; 2]> {
                lines.iter().flat_map(|line| [line[0], line[line.len() - 1]]).collect()
            };
            let (visible, hidden) = (ends(&wireframe.visible), ends(&wireframe.hidden));
            let crossings: Vec<_> = visible.iter().filter(|end| hidden.contains(end)).collect();
            assert!(crossings.len() > 20, "{exponents:?} {}", crossings.len());
            for crossing in crossings {
                let off = distance_to(contour.polygon(), *crossing);
                assert!(off < 0.02, "{exponents:?} {crossing:?} {off}");
            }
            for [u, v] in wireframe.visible.iter().chain(&wireframe.hidden).flatten() {
                let slack = 0.02;
                assert!(*u > min[0] - slack && *u < max[0] + slack);
                assert!(*v > min[1] - slack && *v < max[1] + slack);
            }
        }
    }

    fn distance_to(polygon: &[[f64; 2]], [u, v]: [f64; 2]) -> f64 {
        let next = polygon.iter().skip(1).chain(polygon.first());
        let to_segment = |(a, b): (&[f64; 2], &[f64; 2])| {
            let [x, y] = [b[0] - a[0], b[1] - a[1]];
            let share = ((u - a[0]) * x + (v - a[1]) * y) / (x * x + y * y);
            let share = share.clamp(0.0, 1.0);
            distance([a[0] + share * x, a[1] + share * y], [u, v])
        };
        polygon.iter().zip(next).map(to_segment).fold(f64::INFINITY, f64::min)
    }

    fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
        (a[0] - b[0]).hypot(a[1] - b[1])
    }
}
