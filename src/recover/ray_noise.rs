//! Noise along the rays of a sensor: what it is, told from the points' distances from a model.
//!
//! A range camera errs along its rays, far more than across them. A surface that is seen at the angle t
//! then has points whose distances from it vary with `across + (along - across) cos^2 t`. Noise that is
//! alike in all directions leaves them as they are, and nothing to be told.

use nalgebra::{Matrix2, Vector2, Vector3};

use super::descent::PointSet;
use super::evidence::Side;
use super::kernel::{ModelView, Residual, Spread, normals};
use super::result::RangeNoise;
use super::subset::Subset;
use crate::model::Model;

/// Standard errors by which the squares of distances must grow with `cos^2 t`.
const TOLD: f64 = 3.0;

/// Least standard deviation across the rays, as a share of that along them: of edges, which the rays
/// miss, and of the model's own errors.
const LEAST_ACROSS: f64 = 0.2;

/// Rounds in which the two variances are estimated, and the least of each as a share of the mean.
const ROUNDS: usize = 10;
const LEAST_VARIANCE: f64 = 1e-3;

/// The noise of points that were seen from one side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RayNoise {
    /// Where the sensor was.
    side: Side,
    /// Variances along and across the rays, in the mean of those of the points' distances.
    along: f64,
    across: f64,
}

/// What a point says of the noise: `cos^2 t` and the square of its distance.
struct Sample {
    square_cosine: f64,
    square: f64,
}

impl RayNoise {
    /// That of points of a model's surface, if they tell it from noise that is alike in all directions.
    pub fn of(surface: &PointSet, model: &Model) -> Option<Self> {
        let side = Side::of(surface, model)?;
        let samples = samples(surface, model, &side);
        if !is_told(&samples) {
            return None;
        }
        let [along, across] = variances(&samples)?;
        let across = across.max(LEAST_ACROSS * LEAST_ACROSS * along);
        let share = mean(&samples, |sample| sample.square_cosine);
        let of_distances = share * along + (1.0 - share) * across;
        Some(Self { side, along: along / of_distances, across: across / of_distances })
    }

    /// Its standard deviations where that of the points' distances is such.
    pub fn deviations(&self, of_distances: f64) -> RangeNoise {
        let [along, across] = [self.along, self.across].map(|v| v.sqrt() * of_distances);
        RangeNoise { along, across }
    }

    /// How it spreads the points, in the frame of a model.
    pub fn spread(&self, model: &Model) -> Spread {
        let Self { side, along, across } = *self;
        Spread { sensor: side.in_frame_of(model), along, across }
    }
}

fn samples(surface: &PointSet, model: &Model, side: &Side) -> Vec<Sample> {
    let view = ModelView::new(surface.normalization, model, Residual::Geometric);
    let normals = normals(&view, surface.points);
    let normalized = Subset::normalized(surface.points, surface.normalization);
    let distances = surface.geometric_distances(model);
    let sample = |(i, (normal, distance)): (usize, ([f64; 3], f64))| {
        let to_sensor = side.direction_from(normalized.columns().map(|column| column[i]).into());
        let normal = model.pose.rotation() * Vector3::from(normal);
        Sample { square_cosine: normal.dot(&to_sensor).powi(2), square: distance * distance }
    };
    normals.into_iter().zip(distances).enumerate().map(sample).collect()
}

fn mean(samples: &[Sample], of: impl Fn(&Sample) -> f64) -> f64 {
    samples.iter().map(of).sum::<f64>() / samples.len() as f64
}

/// Whether squares of distances grow with `cos^2 t`, by the slope's standard error, whatever the
/// distribution of the noise.
fn is_told(samples: &[Sample]) -> bool {
    let square = mean(samples, |sample| sample.square);
    let square_cosine = mean(samples, |sample| sample.square_cosine);
    let products = samples
        .iter()
        .map(|sample| (sample.square - square) * (sample.square_cosine - square_cosine));
    let (sum, squares) = products
        .fold((0.0, 0.0), |(sum, squares), product| (sum + product, squares + product * product));
    sum > TOLD * squares.sqrt()
}

/// The most likely variances along and across the rays, in a unit of its own: Fisher's scoring. None if
/// all points are seen at one angle.
fn variances(samples: &[Sample]) -> Option<[f64; 2]> {
    let mean = mean(samples, |sample| sample.square);
    let mut variances = Vector2::new(0.5, 0.5);
    for _ in 0..ROUNDS {
        let (mut information, mut score) = (Matrix2::zeros(), Vector2::zeros());
        for Sample { square_cosine, square } in samples {
            let terms = Vector2::new(*square_cosine, 1.0);
            let weight = variances.dot(&terms).powi(-2);
            information += weight * terms * terms.transpose();
            score += weight * square / mean * terms;
        }
        variances = (information.try_inverse()? * score).map(|v| v.max(LEAST_VARIANCE));
    }
    let [excess, across] = variances.into();
    Some([excess + across, across])
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::pose::Pose;
    use crate::recover::descent::tests::bare;
    use crate::shape::Superellipsoid;
    use crate::surface::sample_surface;

    const ALONG: f64 = 0.02;

    fn model() -> Model {
        let shape = Superellipsoid::new([1.0, 0.8, 1.2], [0.6, 0.9]).unwrap();
        Model { shape, pose: Pose::identity() }
    }

    /// Points of a solid, or of its side that faces up, with uniform noise along z and across.
    fn noisy_points(across: f64, is_one_sided: bool) -> Subset {
        let shape = model().shape;
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut noise = |deviation: f64| deviation * 3f64.sqrt() * rng.random_range(-1.0..1.0);
        sample_surface(&shape, 4_000, 2)
            .into_iter()
            .filter(|x| !is_one_sided || shape.gauge_gradient(x).z > 0.0)
            .map(|x| x + Vector3::new(noise(across), noise(across), noise(ALONG)))
            .collect()
    }

    fn noise_of(points: &Subset) -> Option<RayNoise> {
        RayNoise::of(&bare(points.columns()), &model())
    }

    #[test]
    fn the_noise_along_the_rays_and_across_is_told() {
        let noise = noise_of(&noisy_points(0.4 * ALONG, true)).unwrap();
        let ratio = (noise.across / noise.along).sqrt();
        assert!((ratio / 0.4 - 1.0).abs() < 0.1, "{ratio}");
        let Side::Direction(to_sensor) = noise.side else { panic!("{:?}", noise.side) };
        assert!(to_sensor.z > 0.95, "{to_sensor}");
        // None at all counts as a little.
        let noise = noise_of(&noisy_points(0.0, true)).unwrap();
        assert!(((noise.across / noise.along).sqrt() / LEAST_ACROSS - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_variances_are_in_the_mean_of_those_of_the_distances() {
        let points = noisy_points(0.4 * ALONG, true);
        let noise = noise_of(&points).unwrap();
        let samples = samples(&bare(points.columns()), &model(), &noise.side);
        let square_cosine = mean(&samples, |sample| sample.square_cosine);
        let variance = noise.across + (noise.along - noise.across) * square_cosine;
        assert!((variance - 1.0).abs() < 1e-12, "{variance}");
    }

    #[test]
    fn noise_alike_in_all_directions_is_not_told_nor_is_that_of_what_faces_none() {
        assert_eq!(noise_of(&noisy_points(ALONG, true)), None);
        assert_eq!(noise_of(&noisy_points(0.4 * ALONG, false)), None);
    }
}
