//! Spherical products of clipped curves as meshes (B81).

use nalgebra::{Vector2, Vector3};

use super::mesh::Mesh;
use super::tessellate::Resolution;
use crate::shape::{ClippedCurve, Polyline};

/// The spherical product `(m1 h1, m1 h2, m2)` of a vertical curve m, `north`, and a horizontal one
/// h, `east` (B81), in the unit of their sizes: quadrangles cut in two, with so many segments to a
/// quadrant of either curve. Vertices are on the surface.
///
/// The mesh is open where the curves are, and seen from outside where these run counter-clockwise;
/// every pair of branches is a piece of its own. Of a vertical curve that is symmetric about the y
/// axis the half `x >= 0` is used, as B81 does, but of a polyline all. That of two superellipses is
/// closed. Edges of polylines are not cut: those of two make plane pieces.
pub fn spherical_product_mesh(
    north: &ClippedCurve,
    east: &ClippedCurve,
    resolution: Resolution,
) -> Mesh {
    let segments = resolution.segments();
    let equators = east.polylines(segments);
    let mut pieces = Pieces::default();
    for meridian in north.meridians(segments) {
        for equator in &equators {
            pieces.add(&meridian, equator);
        }
    }
    Mesh::new(pieces.vertices, pieces.triangles)
}

#[derive(Default)]
struct Pieces {
    vertices: Vec<Vector3<f64>>,
    triangles: Vec<[u32; 3]>,
}

/// The vertices of one latitude: a single one on the vertical axis.
#[derive(Clone, Copy)]
struct Row {
    first: u32,
    is_pole: bool,
}

impl Row {
    fn vertex(self, column: usize) -> u32 {
        if self.is_pole { self.first } else { self.first + column as u32 }
    }
}

impl Pieces {
    fn add(&mut self, meridian: &Polyline, equator: &Polyline) {
        let rows: Vec<Row> = meridian.points().iter().map(|m| self.add_row(m, equator)).collect();
        for pair in rows.windows(2) {
            self.add_band([pair[0], pair[1]], equator);
        }
        if let (true, [first, .., last]) = (meridian.is_closed(), rows.as_slice()) {
            self.add_band([*last, *first], equator);
        }
    }

    fn add_row(&mut self, m: &Vector2<f64>, equator: &Polyline) -> Row {
        let row = Row { first: self.vertices.len() as u32, is_pole: m.x == 0.0 };
        let columns = if row.is_pole { 1 } else { equator.points().len() };
        let horizontal = equator.points().iter().take(columns);
        self.vertices.extend(horizontal.map(|h| Vector3::new(m.x * h.x, m.x * h.y, m.y)));
        row
    }

    /// Triangles between a row and the next one north.
    fn add_band(&mut self, [south, north]: [Row; 2], equator: &Polyline) {
        let columns = equator.points().len();
        let quadrangles = if equator.is_closed() { columns } else { columns - 1 };
        for west in 0..quadrangles {
            let east = (west + 1) % columns;
            let [a, b] = [west, east].map(|column| south.vertex(column));
            let [d, c] = [west, east].map(|column| north.vertex(column));
            if a != b {
                self.triangles.push([a, b, c]);
            }
            if c != d {
                self.triangles.push([a, c, d]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{LameCurve, PlaneCurve, Superellipse, Superellipsoid, Superhyperbola};

    fn superellipse(size: [f64; 2], e: f64) -> ClippedCurve {
        let curve = PlaneCurve::Superellipse(Superellipse::new(size, e).unwrap());
        ClippedCurve::new(curve, None).unwrap()
    }

    fn superhyperbola(size: [f64; 2], e: f64) -> ClippedCurve {
        let curve = PlaneCurve::Superhyperbola(Superhyperbola::new(size, e).unwrap());
        ClippedCurve::new(curve, Some(2.0)).unwrap()
    }

    fn lame(numerator: i32, denominator: u32) -> ClippedCurve {
        let curve = LameCurve::new([1.0, 1.0], numerator, denominator).unwrap();
        ClippedCurve::new(PlaneCurve::Lame(curve), None).unwrap()
    }

    fn resolution() -> Resolution {
        Resolution::new(16).unwrap()
    }

    /// Over exponents from boxes to beyond bevels: closed, on the surface, and of nearly its
    /// volume.
    #[test]
    fn superellipses_make_the_closed_surface_of_a_superellipsoid() {
        for e1 in [0.1, 0.5, 1.0, 1.5, 2.0, 3.0] {
            for e2 in [0.1, 0.5, 1.0, 1.5, 2.0, 3.0] {
                let (north, east) = (superellipse([1.0, 0.7], e1), superellipse([2.0, 0.3], e2));
                let mesh = spherical_product_mesh(&north, &east, resolution());
                let solid = Superellipsoid::new([2.0, 0.3, 0.7], [e1, e2]).unwrap();
                assert!(mesh.is_closed(), "{e1} {e2}");
                for x in mesh.vertices() {
                    assert!((solid.gauge(x) - 1.0).abs() < 1e-13, "{e1} {e2} {x}");
                }
                let ratio = mesh.volume() / solid.volume();
                assert!((ratio - 1.0).abs() < 0.07, "{e1} {e2} {ratio}");
            }
        }
    }

    fn polyline(points: &[[f64; 2]], is_closed: bool) -> ClippedCurve {
        let points = points.iter().map(|&x| x.into()).collect();
        let line = Polyline::new(points, is_closed).unwrap();
        ClippedCurve::new(PlaneCurve::Polyline(line), None).unwrap()
    }

    /// A star of ten corners, and the area in it.
    fn star() -> (ClippedCurve, f64) {
        let corner = |i: u32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::PI / 5.0).sin_cos();
            let radius = if i.is_multiple_of(2) { 1.0 } else { 0.4 };
            [radius * cos, radius * sin]
        };
        let area = 5.0 * 0.4 * (std::f64::consts::PI / 5.0).sin();
        (polyline(&(0..10).map(corner).collect::<Vec<_>>(), true), area)
    }

    /// B81 Fig. 1: at every height the star, scaled.
    #[test]
    fn an_ellipse_crossed_with_a_star_is_closed_and_has_the_volume_of_its_slices() {
        let (star, area) = star();
        let ellipse = superellipse([1.0, 0.7], 1.0);
        let mesh = spherical_product_mesh(&ellipse, &star, Resolution::new(128).unwrap());
        assert!(mesh.is_closed());
        let volume = area * 4.0 / 3.0 * 0.7;
        assert!((mesh.volume() / volume - 1.0).abs() < 1e-4, "{} {volume}", mesh.volume());
    }

    /// Pyramids and frustums between the points of a meridian that ends on the axis, that is a ring
    /// around it, or that is open.
    #[test]
    fn polylines_make_the_polyhedra_of_their_corners() {
        let (star, area) = star();
        let frustums = |points: &[[f64; 2]]| {
            let pairs = points.windows(2).map(|pair| {
                let ([r, low], [s, high]) = (pair[0], pair[1]);
                (high - low) * (r * r + r * s + s * s) / 3.0
            });
            area * pairs.sum::<f64>()
        };
        let spindle = [[0.0, -2.0], [1.0, -1.0], [0.5, 0.0], [3.0, 0.5], [0.0, 1.0]];
        let mesh = spherical_product_mesh(&polyline(&spindle, false), &star, resolution());
        assert!(mesh.is_closed());
        assert_eq!(mesh.vertices().len(), 3 * 10 + 2);
        assert!((mesh.volume() / frustums(&spindle) - 1.0).abs() < 1e-14);

        let ring = [[1.0, -1.0], [2.0, 0.0], [1.5, 1.0], [1.0, -1.0]];
        let mesh = spherical_product_mesh(&polyline(&ring[..3], true), &star, resolution());
        assert!(mesh.is_closed());
        assert!((mesh.volume() / frustums(&ring) - 1.0).abs() < 1e-14);

        let mesh = spherical_product_mesh(&polyline(&ring[..2], false), &star, resolution());
        assert_eq!(mesh.boundary_edges().len(), 2 * 10);
    }

    /// B81 Fig. 3: open pieces, one or two, on the quadrics.
    #[test]
    fn hyperbolas_make_open_quadrics() {
        let (circle, hyperbola) = (superellipse([1.0, 1.0], 1.0), superhyperbola([1.0, 1.0], 1.0));
        for (east, sign, boundary) in [(&circle, 1.0, 2 * 64), (&hyperbola, -1.0, 2 * 4 * 32)] {
            let mesh = spherical_product_mesh(&hyperbola, east, resolution());
            assert_eq!(mesh.boundary_edges().len(), boundary);
            for x in mesh.vertices() {
                let quadric = x.x * x.x + sign * x.y * x.y - x.z * x.z;
                assert!((quadric - 1.0).abs() < 1e-13 * x.norm_squared().max(10.0), "{x}");
            }
        }
    }

    #[test]
    fn any_two_curves_make_a_finite_mesh_of_triangles() {
        let mut curves = vec![superellipse([1.0, 1.0], 0.5), superhyperbola([1.0, 1.0], 0.5)];
        curves.push(polyline(&[[-1.0, 0.0], [0.0, 0.0], [0.0, 1.0], [2.0, 1.0]], false));
        let exponents = [(8, 3), (2, 3), (5, 2), (1, 2), (3, 1), (1, 3), (-2, 1), (-3, 2), (-1, 3)];
        curves.extend(exponents.map(|(numerator, denominator)| lame(numerator, denominator)));
        for north in &curves {
            for east in &curves {
                let mesh = spherical_product_mesh(north, east, resolution());
                assert!(!mesh.triangles().is_empty());
                assert!(mesh.vertices().iter().all(|x| x.iter().all(|c| c.is_finite())));
            }
        }
    }
}
