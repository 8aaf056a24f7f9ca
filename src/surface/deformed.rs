//! Deformed surfaces as triangles and as points.

use nalgebra::Vector3;

use super::covering::Covering;
use super::mesh::Mesh;
use super::patches::sample;
use super::tessellate::{Resolution, tessellate};
use crate::deform::{Deform, Deformed};
use crate::shape::Shape;

/// A closed mesh of a deformed surface, in the shape's frame: the shape's mesh, its vertices
/// deformed.
pub fn tessellate_deformed(solid: &Deformed, resolution: Resolution) -> Mesh {
    deformed_mesh(solid, &tessellate(solid.shape(), resolution))
}

/// The mesh of a shape of any family, its vertices deformed.
pub fn deformed_mesh<S>(solid: &Deformed<S>, mesh: &Mesh) -> Mesh {
    mesh.mapped(|x| solid.chain().forward_of((*x).into()).into())
}

/// `count` independent points of a deformed surface, uniform by area, in the shape's frame; the
/// same for the same seed. Domain: that of [`sample_shape_surface`](super::sample_shape_surface).
pub fn sample_deformed_surface<S: Copy + Into<Shape>>(
    solid: &Deformed<S>,
    count: usize,
    seed: u64,
) -> Vec<Vector3<f64>> {
    sample(&Covering { shape: &(*solid.shape()).into(), chain: solid.chain() }, count, seed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::deform::{Bend, Chain, Deformation, Line, Scale, Taper, Twist};
    use crate::shape::Superellipsoid;
    use crate::surface::sample_surface;

    fn solid() -> Deformed {
        let shape = Superellipsoid::new([0.8, 1.8, 0.6], [0.5, 0.8]).unwrap();
        let line = |at_zero, slope| Line::new(at_zero, slope).unwrap();
        let stages = [
            Deformation::new(Taper::new(line(1.0, -0.6))),
            Deformation::new(Twist::new(line(0.0, 1.2))),
            Deformation::new(Bend::new(0.7, 0.0, [-1.0, 1.0]).unwrap()),
        ];
        Deformed::new(shape, Chain::new(stages)).unwrap()
    }

    #[test]
    fn a_deformed_mesh_is_closed_and_has_the_volume_and_area_of_the_quadrature() {
        let solid = solid();
        let mesh = tessellate_deformed(&solid, Resolution::new(128).unwrap());
        let estimate = solid.mass_estimate(1e-6);
        assert!(mesh.is_closed());
        // Facets of a hundredth of the size.
        assert!((mesh.volume() / estimate.properties.volume() - 1.0).abs() < 1e-3);
        assert!((mesh.area() / estimate.surface_area - 1.0).abs() < 1e-3);
    }

    #[test]
    fn points_are_on_the_surface_and_uniform_by_area() {
        let solid = solid();
        let count = 20_000;
        let points = sample_deformed_surface(&solid, count, 7);
        assert_eq!(points.len(), count);
        assert!(points.iter().all(|x| (solid.inside_outside(x) - 1.0).abs() < 1e-9));
        let mesh = tessellate_deformed(&solid, Resolution::new(128).unwrap());
        // Shares of the area beyond planes, as a mesh has them.
        for (axis, level) in [(0, 0.2), (1, -0.5), (1, 1.0), (2, 0.1)] {
            let beyond: f64 = mesh
                .corners()
                .filter(|corners| corners.iter().map(|x| x[axis]).sum::<f64>() > 3.0 * level)
                .map(|[a, b, c]| 0.5 * (b - a).cross(&(c - a)).norm())
                .sum();
            let share = points.iter().filter(|x| x[axis] > level).count() as f64 / count as f64;
            // Five standard errors, and triangles cut by the plane.
            let slack = 5.0 * 0.5 / (count as f64).sqrt() + 3e-3;
            assert!((share - beyond / mesh.area()).abs() < slack, "{axis} {level}");
        }
    }

    #[test]
    fn points_of_a_scaled_ball_are_those_of_the_ellipsoid() {
        let ball = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        let scale = Deformation::new(Scale::new([1.0, 1.0, 0.1]).unwrap());
        let solid = Deformed::new(ball, Chain::new([scale])).unwrap();
        let points = sample_deformed_surface(&solid, 5000, 1);
        let ellipsoid = Superellipsoid::new([1.0, 1.0, 0.1], [1.0; 2]).unwrap();
        let mean = |points: &[Vector3<f64>]| {
            points.iter().map(|x| x.xy().norm()).sum::<f64>() / points.len() as f64
        };
        let expected = mean(&sample_surface(&ellipsoid, 5000, 2));
        // Five standard errors of the difference; the radius scatters by a quarter.
        assert!((mean(&points) - expected).abs() < 5.0 * 0.25 * (2.0_f64 / 5000.0).sqrt());
    }
}
