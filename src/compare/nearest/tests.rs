use super::*;
use crate::surface::{sample_solid, sample_surface};

const EXPONENTS: [f64; 6] = [0.05, 0.1, 0.5, 1.0, 1.5, 1.9];

const SIZES: [[f64; 3]; 4] =
    [[1.0, 1.0, 1.0], [2.0, 1.0, 0.5], [1.0, 1.0, 50.0], [50.0, 20.0, 0.5]];

fn shapes() -> impl Iterator<Item = Superellipsoid> {
    EXPONENTS.into_iter().flat_map(|e1| {
        EXPONENTS
            .into_iter()
            .flat_map(move |e2| SIZES.map(|size| Superellipsoid::new(size, [e1, e2]).unwrap()))
    })
}

#[test]
fn feet_of_known_normals_are_found() {
    let (mut missed, mut all) = (0_usize, 0_usize);
    for shape in shapes() {
        let projection = EuclideanProjection::new(&shape);
        for foot in sample_surface(&shape, 20, 1) {
            let normal = shape.gauge_gradient(&foot).normalize();
            for height in [1e-9, 1e-3, 0.1, 1.0, 30.0] {
                let distance = projection.distance(&(foot + normal * height));
                let error = (distance - height) / shape.mean_semi_axis();
                // A foot found is never nearer than the nearest; 1e-12 is the rounding.
                assert!(error > -1e-12, "{shape:?} {height}: {error}");
                assert!(error < 1e-4, "{shape:?} {height}: {error}");
                missed += usize::from(error > 1e-8);
                all += 1;
            }
        }
    }
    // One in a thousand, far from needles.
    assert!(missed * 1000 <= all, "{missed} of {all}");
}

#[test]
fn depth_is_the_least_over_all_tangent_planes() {
    for shape in shapes() {
        let projection = EuclideanProjection::new(&shape);
        let surface = tessellate(&shape, Resolution::new(64).unwrap());
        let planes: Vec<_> =
            surface.vertices().iter().map(|y| (*y, shape.gauge_gradient(y).normalize())).collect();
        for x in sample_solid(&shape, 20, 2) {
            let depth = projection.distance(&x) / shape.mean_semi_axis();
            // The solid lies behind every tangent plane, so none is nearer than the surface.
            let planes = planes.iter().map(|(y, normal)| normal.dot(&(y - x)));
            let bound = planes.fold(f64::INFINITY, f64::min) / shape.mean_semi_axis();
            // From above to rounding; from below to the turn between the planes' normals.
            assert!(depth < bound + 1e-9, "{shape:?}: {depth} {bound}");
            assert!(depth > bound - 1e-2, "{shape:?}: {depth} {bound}");
        }
    }
}

#[test]
fn the_centre_of_an_ellipsoid_is_one_least_semi_axis_deep() {
    for size in [[1.0, 1.0, 1.0], [3.0, 1.0, 0.2], [1.0, 2.0, 3.0]] {
        let shape = Superellipsoid::new(size, [1.0, 1.0]).unwrap();
        let depth = EuclideanProjection::new(&shape).distance(&Vector3::zeros());
        // The tolerance of the search.
        assert!((depth - size.iter().copied().fold(3.0, f64::min)).abs() < 1e-9, "{depth}");
    }
}
