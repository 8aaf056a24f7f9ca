//! The plane that an object stands on, from points around it.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::cloud::PointCloud;
use crate::recover::Plane;

/// Planes through three points at random that are tried.
const TRIALS: usize = 400;

/// Points on which planes are tried.
const SAMPLE: usize = 2_000;

/// Distance from a plane that counts as on it, in that of the points from the viewpoint: twice
/// the noise of common depth cameras.
const TOLERANCE: f64 = 0.006;

/// Least share of the points on the plane.
const LEAST_SHARE: f64 = 0.3;

/// Rounds of fitting a plane to the points on it.
const ROUNDS: usize = 5;

/// The plane on which most points lie, its normal to the viewpoint's side. None where less than
/// 30 % of them lie on one.
///
/// Random sample consensus (M. Fischler and R. Bolles 1981), then least squares over the points
/// on it. The same points, viewpoint and seed give the same plane.
pub fn find_plane(points: &PointCloud, viewpoint: [f64; 3], seed: u64) -> Option<Plane> {
    let points: Vec<Vector3<f64>> = points.points().map(Vector3::from).collect();
    let viewpoint = Vector3::from(viewpoint);
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    if points.len() < 3 {
        return None;
    }
    let mut pick = || points[rng.random_range(0..points.len())];
    let sample: Vec<Vector3<f64>> = (0..points.len().min(SAMPLE)).map(|_| pick()).collect();
    let trials = (0..TRIALS).filter_map(|_| through([pick(), pick(), pick()]));
    let count = |plane: &Plane| sample.iter().filter(|x| is_on(plane, x, &viewpoint)).count();
    let mut best: Option<(usize, Plane)> = None;
    for plane in trials {
        let on_it = count(&plane);
        if best.is_none_or(|(most, _)| on_it > most) {
            best = Some((on_it, plane));
        }
    }
    let (mut plane, mut share) = (best?.1, 0.0);
    for _ in 0..ROUNDS {
        let on_it: Vec<_> = points.iter().filter(|x| is_on(&plane, x, &viewpoint)).collect();
        share = on_it.len() as f64 / points.len() as f64;
        plane = least_squares(&on_it)?;
    }
    let is_towards_viewpoint = plane.height(viewpoint.into()) >= 0.0;
    let plane = if is_towards_viewpoint { plane } else { plane.flipped() };
    (share >= LEAST_SHARE).then_some(plane)
}

/// The points that are neither on a plane nor below it.
pub fn points_above(points: &PointCloud, plane: &Plane, viewpoint: [f64; 3]) -> PointCloud {
    let viewpoint = Vector3::from(viewpoint);
    let is_above =
        |x: &[f64; 3]| plane.height(*x) > TOLERANCE * (Vector3::from(*x) - viewpoint).norm();
    points.points().filter(is_above).collect()
}

fn is_on(plane: &Plane, point: &Vector3<f64>, viewpoint: &Vector3<f64>) -> bool {
    plane.height((*point).into()).abs() <= TOLERANCE * (point - viewpoint).norm()
}

fn through([a, b, c]: [Vector3<f64>; 3]) -> Option<Plane> {
    let normal = (b - a).cross(&(c - a)).try_normalize(0.0)?;
    Plane::new(normal.into(), -normal.dot(&a))
}

/// The plane of least squared distance.
fn least_squares(points: &[&Vector3<f64>]) -> Option<Plane> {
    let count = points.len() as f64;
    let centroid = points.iter().copied().sum::<Vector3<f64>>() / count;
    let scatter: Matrix3<f64> =
        points.iter().map(|x| (*x - centroid) * (*x - centroid).transpose()).sum();
    let eigen = SymmetricEigen::new(scatter);
    let normal = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
    Plane::new(normal.into(), -normal.dot(&centroid))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a table seen from a metre above, noisy, and as many anywhere.
    fn table_among(strays: usize) -> PointCloud {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut uniform = |half: f64| rng.random_range(-half..half);
        let table: Vec<[f64; 3]> =
            (0..1_000).map(|_| [uniform(0.3), uniform(0.3), 1.0 + uniform(0.002)]).collect();
        let strays = (0..strays).map(|_| [uniform(0.3), uniform(0.3), 0.8 + uniform(0.3)]);
        table.into_iter().chain(strays).collect()
    }

    #[test]
    fn a_table_among_strays_is_found_and_faces_the_camera() {
        for strays in [0, 1_000] {
            let plane = find_plane(&table_among(strays), [0.0; 3], 1).unwrap();
            let [x, y, z] = plane.normal();
            assert!(z < -0.9999 && x.abs() < 0.01 && y.abs() < 0.01, "{plane:?}");
            assert!((plane.offset() - 1.0).abs() < 0.002, "{plane:?}");
        }
    }

    #[test]
    fn points_of_no_plane_have_none() {
        let mut rng = ChaCha8Rng::seed_from_u64(6);
        let anywhere = (0..500).map(|_| [0; 3].map(|_| rng.random_range(1.0..2.0)));
        assert_eq!(find_plane(&anywhere.collect(), [0.0; 3], 1), None);
        assert_eq!(find_plane(&PointCloud::new(), [0.0; 3], 1), None);
        assert_eq!(find_plane(&PointCloud::from_rows([[1.0; 3]; 9]), [0.0; 3], 1), None);
    }
}
