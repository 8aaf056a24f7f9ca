//! Clutter by nearest neighbours: the points of a surface have nearer neighbours than those
//! strewn in space.
//!
//! The distance D of the k-th neighbour makes `pi l D^2`, on a surface with l points to the unit
//! area, and `4/3 pi m D^3`, in a space with m points to the unit volume, a Gamma variate of
//! shape k. The two densities and the share of clutter are estimated by expectation and
//! maximisation (S. Byers and A. Raftery, Nearest-Neighbor Clutter Removal for Estimating
//! Features in Spatial Point Processes, JASA 93, 1998; here the feature is a surface).

use std::f64::consts::{LN_2, PI};

use super::neighbours::NEIGHBOUR;

/// The shape k of the Gamma variates.
const SHAPE: f64 = NEIGHBOUR as f64;

/// Rounds of expectation and maximisation.
const ROUNDS: usize = 40;

/// Gain in mean log-likelihood over one surface without clutter, above which there is clutter:
/// a single view without any reaches 0.11, 80 % of clutter 0.16, 60 % 1.5.
const LEAST_GAIN: f64 = 0.12;

/// Least and greatest of what one point's neighbours say, as a ratio of densities.
const ODDS_BOUNDS: [f64; 2] = [0.02, 50.0];

/// Least share of either population while it is estimated.
const LEAST_SHARE: f64 = 1e-6;

/// What neighbours say of the points.
#[derive(Debug, Clone)]
pub(crate) struct Clutter {
    /// Probability of each neighbour's distance on the surface over that in clutter.
    pub odds: Vec<f64>,
    /// Share of clutter among the points.
    pub share: f64,
    /// The area on which the points of the surface lie: the sum of each one's own.
    pub surface_area: f64,
    /// Probability of each point to be of the surface.
    on_surface: Vec<f64>,
}

impl Clutter {
    /// Of points with these distances to their neighbours; none where one surface explains all.
    pub fn find(distances: &[f64]) -> Option<Self> {
        let all = vec![1.0; distances.len()];
        let without = Populations::most_likely(distances, &all);
        let mut on_surface = nearer_half(distances);
        let mut populations = Populations::most_likely(distances, &on_surface);
        for _ in 0..ROUNDS {
            on_surface = distances.iter().map(|&d| populations.on_surface(d)).collect();
            populations = Populations::most_likely(distances, &on_surface);
        }
        let gain = populations.log_likelihood(distances) - without.log_likelihood(distances);
        let is_clutter_sparser = populations.clutter_distance() > populations.surface_distance();
        (gain > LEAST_GAIN && is_clutter_sparser).then(|| Self {
            odds: distances.iter().map(|&d| populations.odds(d)).collect(),
            share: populations.clutter_share,
            surface_area: seen_area(distances, &on_surface),
            on_surface,
        })
    }

    /// Indices of the points that are of the surface more likely than not.
    pub fn surface(&self) -> Vec<usize> {
        (0..self.on_surface.len()).filter(|&i| self.on_surface[i] > 0.5).collect()
    }
}

/// The area on which points lie: each has `pi D^2 / k` to itself.
pub(crate) fn seen_area(distances: &[f64], weights: &[f64]) -> f64 {
    let squares = distances.iter().zip(weights).map(|(distance, weight)| weight * distance.powi(2));
    PI / SHAPE * squares.sum::<f64>()
}

/// One for the points with the nearer neighbours, none for the others.
fn nearer_half(distances: &[f64]) -> Vec<f64> {
    let mut sorted = distances.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted[sorted.len() / 2];
    distances.iter().map(|&distance| f64::from(u8::from(distance <= middle))).collect()
}

/// A surface among clutter.
#[derive(Debug, Clone, Copy)]
struct Populations {
    clutter_share: f64,
    /// Points to the unit area.
    surface_density: f64,
    /// Points to the unit volume.
    clutter_density: f64,
}

impl Populations {
    /// Those that make distances most likely, by the points' weights on the surface.
    fn most_likely(distances: &[f64], on_surface: &[f64]) -> Self {
        let (mut near, mut squares, mut cubes) = (0.0, 0.0, 0.0);
        for (distance, weight) in distances.iter().zip(on_surface) {
            near += weight;
            squares += weight * distance.powi(2);
            cubes += (1.0 - weight) * distance.powi(3);
        }
        let count = distances.len() as f64;
        let clutter_share = (1.0 - near / count).clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
        let density = |points: f64, measure: f64| SHAPE * points / measure.max(f64::MIN_POSITIVE);
        Self {
            clutter_share,
            surface_density: density((1.0 - clutter_share) * count, PI * squares),
            clutter_density: density(clutter_share * count, 4.0 / 3.0 * PI * cubes),
        }
    }

    /// Logarithms of the densities of `ln D` on the surface and in clutter, but for a constant.
    fn log_densities(&self, distance: f64) -> [f64; 2] {
        let distance = distance.max(f64::MIN_POSITIVE);
        let area = PI * distance.powi(2) * self.surface_density;
        let volume = 4.0 / 3.0 * PI * distance.powi(3) * self.clutter_density;
        // An area or volume that vanishes has the least logarithm there is, not none.
        let log = |measure: f64| measure.max(f64::MIN_POSITIVE).ln();
        [LN_2 + SHAPE * log(area) - area, 3.0_f64.ln() + SHAPE * log(volume) - volume]
    }

    fn odds(&self, distance: f64) -> f64 {
        let [low, high] = ODDS_BOUNDS;
        let [surface, clutter] = self.log_densities(distance);
        (surface - clutter).exp().clamp(low, high)
    }

    /// Probability of a point to be of the surface.
    fn on_surface(&self, distance: f64) -> f64 {
        let [surface, clutter] = self.log_densities(distance);
        let log_odds = (self.clutter_share / (1.0 - self.clutter_share)).ln() + clutter - surface;
        1.0 / (1.0 + log_odds.exp())
    }

    /// Mean over the points.
    fn log_likelihood(&self, distances: &[f64]) -> f64 {
        let of_one = |&distance: &f64| {
            let [surface, clutter] = self.log_densities(distance);
            let [surface, clutter] =
                [surface + (1.0 - self.clutter_share).ln(), clutter + self.clutter_share.ln()];
            let greater = surface.max(clutter);
            greater + ((surface - greater).exp() + (clutter - greater).exp()).ln()
        };
        distances.iter().map(of_one).sum::<f64>() / distances.len() as f64
    }

    /// Typical distance of a neighbour on the surface.
    fn surface_distance(&self) -> f64 {
        (SHAPE / (PI * self.surface_density)).sqrt()
    }

    /// Typical distance of a neighbour in clutter.
    fn clutter_distance(&self) -> f64 {
        (SHAPE / (4.0 / 3.0 * PI * self.clutter_density)).cbrt()
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::recover::neighbours::neighbour_distances;
    use crate::shape::Superellipsoid;
    use crate::surface::sample_surface;

    const SURFACE: usize = 1_000;

    /// Points of a sphere of radius 1, then strays in a cube of side 4.
    fn sphere_among(strays: usize) -> [Vec<f64>; 3] {
        let sphere = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let points = sample_surface(&sphere, SURFACE, 2);
        std::array::from_fn(|k| {
            let surface = points.iter().map(|point| point[k]);
            surface.chain((0..strays).map(|_| rng.random_range(-2.0..2.0))).collect()
        })
    }

    fn distances(columns: &[Vec<f64>; 3]) -> Vec<f64> {
        neighbour_distances([&columns[0], &columns[1], &columns[2]])
    }

    #[test]
    fn clutter_is_told_from_a_sphere_and_its_share_found() {
        for strays in [250, 1_000, 2_500] {
            let clutter = Clutter::find(&distances(&sphere_among(strays))).expect("clutter");
            let share = strays as f64 / (SURFACE + strays) as f64;
            // Strays next to the surface have near neighbours too.
            assert!(clutter.share < share && clutter.share > share - 0.1, "{strays} {clutter:?}");
            let kept = clutter.surface();
            let right = kept.iter().filter(|&&i| i < SURFACE).count();
            assert!(right >= SURFACE * 99 / 100, "{right}");
            let most_wrong = strays / 5;
            assert!(kept.len() - right < most_wrong, "{strays}: {} kept", kept.len() - right);
        }
    }

    #[test]
    fn a_sphere_alone_has_no_clutter_and_its_area_is_seen() {
        let distances = distances(&sphere_among(0));
        assert!(Clutter::find(&distances).is_none());
        let area = seen_area(&distances, &vec![1.0; SURFACE]);
        assert!((area / (4.0 * PI) - 1.0).abs() < 0.05, "{area}");
    }

    #[test]
    fn twins_and_points_without_neighbours_are_no_clutter() {
        assert!(Clutter::find(&[0.0; 20]).is_none());
        assert!(Clutter::find(&[f64::INFINITY; 5]).is_none());
    }
}
