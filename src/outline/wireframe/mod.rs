//! Lines on surfaces, parted into those that a camera sees and those that are hidden.

mod lines;

use nalgebra::Vector3;
use rayon::prelude::*;

use self::lines::{Line, surface_lines};
use super::facing::Facing;
use super::part::{bounds, convex, parts};
use super::visibility::Visibility;
use crate::deform::Deform;
use crate::pose::Pose;
use crate::ray::outward_normal;
use crate::shape::{LevelSet, Shape};
use crate::solid::{Primitive, Tree};
use crate::view::Projection;

/// Segments of a line.
const SEGMENTS: u32 = 64;

/// Halvings that find where a line passes the rim: 1e-7 of its length.
const HALVINGS: usize = 16;

/// How far from 1 the level of a solid is where its surface is a primitive's.
const ON_SURFACE: f64 = 1e-6;

/// Lines `[column, row]` in an image.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wireframe {
    /// Lines that the camera sees.
    pub visible: Vec<Vec<[f64; 2]>>,
    /// Lines that something is in the way to.
    pub hidden: Vec<Vec<[f64; 2]>>,
}

impl Wireframe {
    /// The lines of a grid on the surface of each primitive of a solid, given in the camera's
    /// frame, as far as they are on the surface of the solid. What is behind the camera or not
    /// let through by the lens is left out.
    pub fn of(solid_camera: &Tree, camera: &(impl Projection + Sync)) -> Self {
        let sight = Sight::new(solid_camera, camera);
        let lines: Vec<_> = primitives(solid_camera)
            .into_iter()
            .flat_map(|primitive| {
                let lines = surface_lines(primitive.deformed.shape());
                lines.into_iter().map(move |line| PrimitiveLine { primitive, line })
            })
            .collect();
        let pieces: Vec<_> = lines.par_iter().flat_map_iter(|line| sight.pieces(line)).collect();
        let of = |wanted: Seen| {
            let wanted = pieces.iter().filter(|(seen, _)| *seen == wanted);
            wanted.flat_map(|(_, piece)| projected(camera, piece)).collect()
        };
        Self { visible: of(Seen::Visible), hidden: of(Seen::Hidden) }
    }
}

/// The primitives that a solid is made of.
fn primitives(solid: &Tree) -> Vec<&Primitive<Shape>> {
    match solid {
        Tree::Leaf(primitive) => vec![primitive],
        Tree::Union(parts) | Tree::Intersection(parts) => {
            parts.iter().flat_map(primitives).collect()
        }
        Tree::Difference(from, parts) => {
            primitives(from).into_iter().chain(parts.iter().flat_map(primitives)).collect()
        }
    }
}

/// A line on a deformed shape.
struct PrimitiveLine<'a> {
    primitive: &'a Primitive<Shape>,
    line: Line,
}

impl PrimitiveLine<'_> {
    /// The point at a place from 0 to 1, in the frame of the solid.
    fn at(&self, place: f64) -> Vector3<f64> {
        let Primitive { deformed, pose } = self.primitive;
        pose.world_from_model(&deformed.chain().forward_of((self.line)(place).into()).into())
    }
}

/// What is seen of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Seen {
    Visible,
    Hidden,
    /// The primitive's surface is not the solid's there.
    Inside,
}

/// A solid and what of it is seen.
struct Sight<'a> {
    facing: Facing<'a, Tree>,
    /// A convex solid hides what faces away, and nothing else.
    visibility: Option<Visibility>,
}

impl<'a> Sight<'a> {
    fn new(solid: &'a Tree, camera: &impl Projection) -> Self {
        let viewpoint = camera.viewpoint(&Pose::identity());
        let bounds = || bounds(&parts(solid));
        let visibility =
            convex(solid).is_none().then(|| Visibility::new(solid, bounds(), viewpoint));
        Self { facing: Facing { solid, viewpoint }, visibility }
    }

    fn seen(&self, x: &Vector3<f64>) -> Seen {
        let solid = self.facing.solid;
        let is_hidden = match &self.visibility {
            None => self.facing.away(x) >= 0.0,
            Some(_) if (solid.level((*x).into()) - 1.0).abs() > ON_SURFACE => return Seen::Inside,
            Some(visibility) => visibility.is_hidden(x, &outward_normal(solid, x)),
        };
        if is_hidden { Seen::Hidden } else { Seen::Visible }
    }

    /// A line, parted where it is seen otherwise.
    fn pieces(&self, line: &PrimitiveLine<'_>) -> Vec<(Seen, Vec<Vector3<f64>>)> {
        let place = |i: u32| f64::from(i) / f64::from(SEGMENTS);
        let first = line.at(0.0);
        let mut pieces = vec![(self.seen(&first), vec![first])];
        for i in 1..=SEGMENTS {
            let x = line.at(place(i));
            let seen = self.seen(&x);
            if let Some((before, piece)) = pieces.last_mut()
                && *before != seen
            {
                let change = self.change(line, [place(i - 1), place(i)], *before);
                piece.push(change);
                pieces.push((seen, vec![change]));
            }
            if let Some((_, piece)) = pieces.last_mut() {
                piece.push(x);
            }
        }
        pieces
    }

    /// The point between two places at which the line begins to be seen otherwise.
    fn change(
        &self,
        line: &PrimitiveLine<'_>,
        [mut low, mut high]: [f64; 2],
        at_low: Seen,
    ) -> Vector3<f64> {
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.seen(&line.at(middle)) == at_low { low = middle } else { high = middle }
        }
        line.at(high)
    }
}

/// The image of a line, parted where it is not in the picture's reach.
fn projected(camera: &impl Projection, line: &[Vector3<f64>]) -> Vec<Vec<[f64; 2]>> {
    let pixels: Vec<Option<[f64; 2]>> = line.iter().map(|x| camera.project(x)).collect();
    let runs = pixels.split(Option::is_none).filter(|run| run.len() > 1);
    runs.map(|run| run.iter().copied().flatten().collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::shape::Superellipsoid;
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
            let primitive = Primitive::from(Model { shape: Shape::from(shape), pose });
            let wireframe = Wireframe::of(&primitive.into(), &camera);
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
